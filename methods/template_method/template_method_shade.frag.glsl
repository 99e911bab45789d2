// One function a formula; bindings and globals only in main().
#include "parameters.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D normal_texture;
layout(location = 0) out float visibility;

float compute_facing_visibility(vec3 n, float strength) {
    return 1.0 - strength * (1.0 - clamp(n.z, 0.0, 1.0));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool is_background = isinf(texelFetch(eye_depth_texture, pixel, 0).r);
    vec3 n = texelFetch(normal_texture, pixel, 0).xyz;
    visibility = is_background ? 1.0 : compute_facing_visibility(n, param_strength);
}
