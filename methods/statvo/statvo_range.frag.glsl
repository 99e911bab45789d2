// Smallest and largest eye depth, sum of eye depths and number of surfaces, of 16 x 16 texels.
#include "parameters.glsl"
layout(binding = 0) uniform sampler2D input_texture;
layout(binding = 1) uniform sampler2D hidden_texture;
uniform bool reads_samples; // the input holds samples; otherwise what this pass wrote
layout(location = 0) out vec4 range;

const int kSide = 16;

vec4 join_ranges(vec4 a, vec4 b) {
    return b.w == 0.0 ? a : a.w == 0.0 ? b : vec4(min(a.x, b.x), max(a.y, b.y), a.zw + b.zw);
}

vec4 make_range(vec4 samples) {
    float depth = samples.w > 0.0 ? -samples.z / samples.w : 0.0;
    return vec4(depth, depth, -samples.z, samples.w);
}

void main() {
    ivec2 size = textureSize(input_texture, 0);
    ivec2 first = ivec2(gl_FragCoord.xy) * kSide;
    ivec2 end = min(first + kSide, size);
    vec4 joined = vec4(0.0);
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            vec4 texel = texelFetch(input_texture, ivec2(x, y), 0);
            joined = join_ranges(joined, reads_samples ? make_range(texel) : texel);
            if (param_source == param_source_peeled && reads_samples) {
                joined = join_ranges(joined, make_range(texelFetch(hidden_texture, ivec2(x, y), 0)));
            }
        }
    }
    range = joined;
}
