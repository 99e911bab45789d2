// This work is based on: Loos, Sloan. Volumetric obscurance. 2010, and on its use as a reference in: Statistical
// volumetric obscurance (equation 2), by 256 points.
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
    vec3 t;
    vec3 b;
    compute_tangent_frame(receiver.normal, t, b);
    rotate_about_axis(t, b, compute_turn(receiver.pixel, noise_seed));
    vec2 pixel_tangents = 2.0 * tangents * receiver.pixel_size;
    float bias = compute_footprint_bias(receiver.position, receiver.normal, pixel_tangents, param_bias);
    float cut_squared = param_cut * param_radius * param_cut * param_radius;
    const bool kIsClamped = param_border == param_border_clamp;
    float sum = 0.0;
    for (int i = 0; i < param_samples; ++i) {
        vec4 s = kernel[i];
        vec3 offset = s.w * (s.x * t + s.y * b + s.z * receiver.normal);
        sum += test_point(receiver, receiver.position + param_radius * offset, bias, cut_squared, kIsClamped);
    }
    visibility = clamp(1.0 - param_strength * (sum / float(param_samples)), 0.0, 1.0);
}
