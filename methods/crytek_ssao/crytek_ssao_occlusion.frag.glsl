// Points around the pixel's position against the depth buffer.
// This work is based on: Mittring. Finding next gen: CryEngine 2. 2007; "Know your SSAO artifacts", 2013 (kernels, least
// cosine, range check). The bias is ours (see README).
#include "parameters.glsl"
#include "methods/common/estimator.glsl"
#include "methods/common/hemisphere_estimator.glsl"
#include "methods/crytek_ssao/crytek_ssao_kernel.glsl"
#include "methods/crytek_ssao/crytek_ssao_random.glsl"

// 1 if the surface hides q from the viewer and lies less than `range` before it.
float compute_blocked(vec3 q, float bias, float range, vec2 half_pixel) {
    float inverse_depth = 1.0 / -q.z;
    vec2 uv = project_to_uv(q, inverse_depth, tangents);
    const bool is_clamped = param_border == param_border_clamp;
    bool comparable = is_comparable(q, uv, is_clamped);
    if (is_clamped) {
        uv = clamp(uv, half_pixel, 1.0 - half_pixel);
    }
    float surface = textureLod(eye_depth_texture, uv, 0.0).r;
    return comparable && is_hidden(surface, inverse_depth, bias) && -q.z - surface < range ? 1.0 : 0.0;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    Receiver receiver = read_receiver(texel);
    if (isinf(receiver.depth)) {
        visibility = 1.0;
        return;
    }
    vec3 p = receiver.position;
    vec2 pixel_size = receiver.pixel_size;
    // Where there is no normal, that of a surface that faces the viewer.
    vec3 n = dot(receiver.normal, receiver.normal) > 0.0 ? receiver.normal : normalize(-p);
    TexelRandom random = compute_texel_random(texel, noise_seed);
    vec3 tangent;
    vec3 bitangent;
    compute_kernel_frame(n, random.angle, tangent, bitangent);
    bool is_reflected = param_randomisation != param_randomisation_off;
    float bias = compute_footprint_bias(p, n, 2.0 * tangents * pixel_size, param_bias);
    float range = param_range * param_radius;
    float sum = 0.0;
    float total = 0.0;
    for (int j = 0; j < param_samples; ++j) {
        vec4 point = read_point(kIsWholeSphere ? j / 2 : j, random.offsets);
        vec3 direction = point.xyz;
        float weight = 1.0;
        if (kIsSphere) {
            direction = is_reflected ? reflect(direction, random.direction) : direction;
            float cosine = dot(direction, n);
            bool turns = kIsWholeSphere ? (j & 1) == 1 : cosine < 0.0;
            direction = turns ? -direction : direction;
            weight = param_weighting == param_weighting_cosine ? 2.0 * abs(cosine) : 1.0;
            weight = abs(cosine) < param_min_cosine ? 0.0 : weight;
        } else {
            direction = direction.x * tangent + direction.y * bitangent + direction.z * n;
        }
        vec3 q = p + param_radius * point.w * direction;
        sum += weight * compute_blocked(q, bias, range, 0.5 * pixel_size);
        total += weight;
    }
    float occlusion = total > 0.0 ? sum / total : 0.0;
    if (kIsWholeSphere && param_normalise) {
        occlusion = max(0.0, 2.0 * occlusion - 1.0);
    }
    visibility = clamp(1.0 - param_strength * occlusion, 0.0, 1.0);
}
