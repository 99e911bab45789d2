// The far part: a sphere's occlusion of every receiver under its billboard.
// This work is based on: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on GPUs. 2007, section 5.
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
#include "methods/shanmugam_arikan/shanmugam_arikan_sphere.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 4) uniform sampler2D normal_texture;
uniform vec2 tangents;
uniform float far_distance; // in radii, equation (5)
flat in vec4 sphere;
layout(location = 0) out float result; // additive: occlusion; multiplicative: what is left open

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    vec3 to_center = sphere.xyz - reconstruct_view_position(gl_FragCoord.xy * pixel_size, depth, tangents);
    float distance_squared = dot(to_center, to_center);
    float limit = min(far_distance * sphere.w, param_reach);
    const bool kLeavesNear = param_far_from_r_far && param_part == param_part_combined;
    float steradians = 0.0;
    if (kLeavesNear && distance_squared < param_r_far * param_r_far) {
        steradians = 0.0;
    } else if (distance_squared <= sphere.w * sphere.w) {
        steradians = param_inside_value;
    } else if (distance_squared <= limit * limit) {
        vec3 n = normalize(texelFetch(normal_texture, pixel, 0).xyz);
        steradians = compute_sphere_occlusion(to_center, sphere.w, n);
    }
    float occlusion = normalise_occlusion(steradians);
    result = param_blending == param_blending_additive ? occlusion : max(1.0 - occlusion, 0.0);
}
