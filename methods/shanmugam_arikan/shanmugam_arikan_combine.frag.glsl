// Both parts together.
// This work is based on: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on GPUs. 2007, section 6.
#include "parameters.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D near_texture; // occlusion
layout(binding = 2) uniform sampler2D far_texture;  // occlusion, or what is left open
layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    const bool kIsAdditive = param_blending == param_blending_additive;
    const bool kHasNear = param_part != param_part_far;
    const bool kHasFar = param_part != param_part_near;
    float near = kHasNear ? texelFetch(near_texture, pixel, 0).r : 0.0;
    float far = kHasFar ? texelFetch(far_texture, pixel, 0).r : (kIsAdditive ? 0.0 : 1.0);
    float occlusion = kIsAdditive ? near + far : 1.0 - (1.0 - clamp(near, 0.0, 1.0)) * far;
    bool is_background = isinf(texelFetch(eye_depth_texture, pixel, 0).r);
    visibility = is_background ? 1.0 : 1.0 - clamp(param_strength * clamp(occlusion, 0.0, 1.0), 0.0, 1.0);
}
