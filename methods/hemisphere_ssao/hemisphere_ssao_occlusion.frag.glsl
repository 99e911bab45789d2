// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010, equation (2) with points in the hemisphere, and on their cut of 2 r. The bias is ours (see README).
#include "parameters.glsl"
#include "methods/common/estimator.glsl"
#include "methods/common/kernel_rotation.glsl"
#include "methods/common/point_test.glsl"
#include "methods/common/tangent_frame.glsl"
layout(std140) uniform KernelBlock { vec4 kernel[param_samples]; };

void main() {
    Receiver receiver = read_receiver(ivec2(gl_FragCoord.xy));
    if (isinf(receiver.depth)) {
        visibility = 1.0;
        return;
    }
    vec3 p = receiver.position;
    vec3 n = receiver.normal;
    vec3 t;
    vec3 b;
    compute_tangent_frame(n, t, b);
    rotate_about_axis(t, b, compute_turn(receiver.pixel, noise_seed));
    float bias = compute_footprint_bias(p, n, 2.0 * tangents * receiver.pixel_size, param_bias);
    float cut_squared = param_cut * param_radius * param_cut * param_radius;
    const bool kIsClamped = param_border == param_border_clamp;
    float sum = 0.0;
    for (int i = 0; i < param_samples; ++i) {
        vec4 s = kernel[i];
        vec3 q = p + param_radius * s.w * (s.x * t + s.y * b + s.z * n);
        float weight = param_directions == param_directions_uniform ? 2.0 * s.z : 1.0;
        sum += weight * test_point(receiver, q, bias, cut_squared, kIsClamped);
    }
    visibility = clamp(1.0 - param_strength * (sum / float(param_samples)), 0.0, 1.0);
}
