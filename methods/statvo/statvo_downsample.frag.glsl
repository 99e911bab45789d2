// Eye depth into samples: view-space positions of factor x factor pixels added up, and their number. Pixels without a
// surface count for nothing.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015.
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
#include "methods/statvo/statvo_box.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D hidden_depth_texture;
uniform vec2 tangents;
layout(location = 0) out vec4 visible;
layout(location = 1) out vec4 hidden;

vec4 add_positions(sampler2D depths, ivec2 first, vec2 tangents) {
    ivec2 size = textureSize(depths, 0);
    vec2 pixel_size = 1.0 / vec2(size);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < param_downsample; ++y) {
        for (int x = 0; x < param_downsample; ++x) {
            ivec2 pixel = first + ivec2(x, y);
            float depth = texelFetch(depths, min(pixel, size - 1), 0).r;
            bool counts = all(lessThan(pixel, size)) && has_surface(depth);
            vec3 position = reconstruct_view_position((vec2(pixel) + 0.5) * pixel_size, depth, tangents);
            sum += counts ? vec4(position, 1.0) : vec4(0.0);
        }
    }
    return sum;
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * param_downsample;
    visible = add_positions(eye_depth_texture, first, tangents);
    hidden = param_source == param_source_peeled ? add_positions(hidden_depth_texture, first, tangents) : vec4(0.0);
}
