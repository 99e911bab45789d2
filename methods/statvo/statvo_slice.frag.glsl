// Uniform layers: equal slices between the smallest and the largest eye depth of the frame.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, section 4.
#include "parameters.glsl"
layout(binding = 0) uniform sampler2D visible_texture;
layout(binding = 1) uniform sampler2D hidden_texture;
layout(binding = 3) uniform sampler2D range_texture;
layout(location = 0) out uvec2 layers;

uint find_slice(vec4 samples, vec4 range) {
    float depth = samples.w > 0.0 ? -samples.z / samples.w : range.x;
    float share = (depth - range.x) / max(range.y - range.x, 1e-30);
    return uint(clamp(int(share * float(param_slices)), 0, param_slices - 1));
}

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec4 range = texelFetch(range_texture, ivec2(0), 0);
    layers.r = find_slice(texelFetch(visible_texture, place, 0), range);
    layers.g = param_source == param_source_peeled ? find_slice(texelFetch(hidden_texture, place, 0), range) : 0u;
}
