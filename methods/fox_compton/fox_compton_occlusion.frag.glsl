// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010, after Fox, Compton. Ambient occlusive crease shading. 2008.
#include "parameters.glsl"
#include "methods/common/disc_estimator.glsl"
#include "methods/common/estimator.glsl"
#include "methods/common/kernel_rotation.glsl"
layout(std140) uniform KernelBlock { vec4 kernel[param_samples]; };

void main() {
    Receiver receiver = read_receiver(ivec2(gl_FragCoord.xy));
    if (isinf(receiver.depth)) {
        visibility = 1.0;
        return;
    }
    vec3 t = vec3(1.0, 0.0, 0.0); // offsets of the disc lie in the image plane
    vec3 b = vec3(0.0, 1.0, 0.0);
    rotate_about_axis(t, b, compute_turn(receiver.pixel, noise_seed));
    const bool kIsClamped = param_border == param_border_clamp;
    float cut_distance = param_cut * param_radius;
    float sum = 0.0;
    for (int i = 0; i < param_samples; ++i) {
        vec3 q = receiver.position + param_radius * (kernel[i].x * t + kernel[i].y * b);
        // The surface point that the depth was written for: elsewhere in the pixel a tilted plane would lie off itself.
        Place place = find_place(project_to_uv(q, 1.0 / receiver.depth, tangents), receiver.pixel_size, kIsClamped);
        float surface = textureLod(eye_depth_texture, place.uv, 0.0).r;
        vec3 to_hit = reconstruct_view_position(place.uv, surface, tangents) - receiver.position;
        bool counts = place.counts && !isinf(surface);
        float contribution = compute_disc_contribution(to_hit, receiver.normal, cut_distance, param_grazing_cosine);
        sum += counts ? contribution : 0.0;
    }
    visibility = clamp(1.0 - param_strength * (sum / float(param_samples)), 0.0, 1.0);
}
