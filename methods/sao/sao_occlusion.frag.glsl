// This work is based on: McGuire, Mara, Luebke. Scalable ambient obscurance. 2012: taps i at (i + 0.5) / s of the projected
// radius on a spiral, level log2(offset / 2^q) of the depth pyramid, obscurance by
// max(0, r^2 - v.v)^3 max(0, v.n - bias) / (v.v + epsilon), times 5 intensity / (s r^6). Lengths are in radii here.
#include "parameters.glsl"
#include "methods/common/estimator.glsl"
#include "methods/common/kernel_rotation.glsl"
#include "methods/sao/sao_levels.glsl"
layout(binding = 3) uniform sampler2D pyramid_texture;
layout(std140) uniform KernelBlock { vec4 kernel[param_samples]; }; // xy: a direction of the spiral, z: share of the radius

// The surface point that stands for a place `reach` pixels away: the one whose depth is read.
vec3 read_surface(ivec2 place, float reach, ivec2 size) {
    int level = clamp(int(floor(log2(max(reach, 1.0)))) - param_first_level_log, 0, param_levels);
    ivec2 pixel = place;
    float depth;
    if (level == 0) {
        depth = textureLod(eye_depth_texture, (vec2(place) + 0.5) / vec2(size), 0.0).r;
    } else {
        ivec2 texel = min(place >> level, compute_level_size(level, size) - 1);
        pixel = min(find_level_pixel(texel, level), size - 1);
        depth = texelFetch(pyramid_texture, texel + ivec2(find_level_column(level, size.x), 0), 0).r;
    }
    return reconstruct_view_position((vec2(pixel) + 0.5) / vec2(size), depth, tangents);
}

void main() {
    Receiver receiver = read_receiver(ivec2(gl_FragCoord.xy));
    if (isinf(receiver.depth)) {
        visibility = 1.0;
        return;
    }
    ivec2 size = textureSize(eye_depth_texture, 0);
    float radius_px = 0.5 * float(size.y) * param_radius / (receiver.depth * tangents.y);
    float angle = compute_turn(receiver.pixel, noise_seed);
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    float sum = 0.0;
    for (int i = 0; i < param_samples; ++i) {
        float reach = kernel[i].z * radius_px;
        ivec2 place = receiver.pixel + ivec2(floor(reach * (turn * kernel[i].xy) + 0.5));
        bool is_inside = all(greaterThanEqual(place, ivec2(0))) && all(lessThan(place, size));
        vec3 v = (read_surface(clamp(place, ivec2(0), size - 1), reach, size) - receiver.position) / param_radius;
        float vv = dot(v, v);
        float within = 1.0 - vv;
        if ((is_inside || param_border == param_border_clamp) && within > 0.0) {
            sum += within * within * within * max(dot(v, receiver.normal) - param_bias, 0.0) / (vv + param_epsilon);
        }
    }
    visibility = clamp(1.0 - param_intensity * 5.0 / float(param_samples) * sum, 0.0, 1.0);
}
