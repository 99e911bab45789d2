// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010, equation (2) with points in the hemisphere, and on their cut of 2 r. The bias is ours (see README).
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
#include "methods/common/hemisphere_estimator.glsl"
#include "methods/common/noise.glsl"
#include "methods/common/tangent_frame.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D normal_texture;
layout(std140) uniform KernelBlock { vec4 kernel[param_samples]; };
uniform vec2 tangents;
uniform uint noise_seed;
layout(location = 0) out float visibility;

const float kTwoPi = 6.2831853;
// 1 if the surface hides q from the viewer and lies within the cut distance of p.
float compute_blocked(vec3 p, vec3 q, float bias, float cut_squared, vec2 half_pixel) {
    float inverse_depth = 1.0 / -q.z;
    vec2 uv = project_to_uv(q, inverse_depth, tangents);
    const bool is_clamped = param_border == param_border_clamp;
    bool comparable = is_comparable(q, uv, is_clamped);
    if (is_clamped) {
        uv = clamp(uv, half_pixel, 1.0 - half_pixel);
    }
    float surface = textureLod(eye_depth_texture, uv, 0.0).r;
    vec3 hit = reconstruct_view_position(uv, surface, tangents);
    vec3 to_hit = hit - p;
    bool hidden = is_hidden(surface, inverse_depth, bias);
    return comparable && hidden && dot(to_hit, to_hit) <= cut_squared ? 1.0 : 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    if (isinf(depth)) {
        visibility = 1.0;
        return;
    }
    vec3 p = reconstruct_view_position(gl_FragCoord.xy * pixel_size, depth, tangents);
    vec3 n = normalize(texelFetch(normal_texture, pixel, 0).xyz);
    vec3 t;
    vec3 b;
    compute_tangent_frame(n, t, b);
    if (param_rotation) {
        float angle = kTwoPi * compute_pixel_noise(pixel, noise_seed);
        vec3 turned = cos(angle) * t + sin(angle) * b;
        b = cos(angle) * b - sin(angle) * t;
        t = turned;
    }
    float bias = compute_footprint_bias(p, n, 2.0 * tangents * pixel_size, param_bias);
    float cut_squared = param_cut * param_radius * param_cut * param_radius;
    float sum = 0.0;
    for (int i = 0; i < param_samples; ++i) {
        vec4 s = kernel[i];
        vec3 q = p + param_radius * s.w * (s.x * t + s.y * b + s.z * n);
        float weight = param_directions == param_directions_uniform ? 2.0 * s.z : 1.0;
        sum += weight * compute_blocked(p, q, bias, cut_squared, 0.5 * pixel_size);
    }
    visibility = clamp(1.0 - param_strength * (sum / float(param_samples)), 0.0, 1.0);
}
