// Visibility from what all slices added up.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, equation (5).
#include "parameters.glsl"
#include "methods/statvo/statvo_psi.glsl"
layout(binding = 0) uniform sampler2D occlusion_texture;
layout(binding = 1) uniform sampler2D samples_texture;
layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 occlusion = texelFetch(occlusion_texture, pixel, 0);
    vec4 samples = texelFetch(samples_texture, pixel, 0);
    visibility = compute_visibility(occlusion, samples, param_strength, param_regions == param_regions_four);
}
