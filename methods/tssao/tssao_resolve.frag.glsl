// From the size that was worked at to the image: depth-aware upsampling of a half-size visibility, and the guard band cut
// off.
// This work is based on: Kopf, Cohen, Lischinski, Uyttendaele. Joint bilateral upsampling. 2007.
#include "variant.glsl"
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
layout(binding = 0) uniform sampler2D visibility_texture;
layout(binding = 1) uniform sampler2D depth_texture; // eye depth in r; in a where packed
layout(binding = 2) uniform sampler2D normal_texture;
layout(binding = 3) uniform sampler2D history_texture;
uniform vec2 tangents;
uniform ivec2 border;
layout(location = 0) out float visibility;

const bool kIsPacked = IS_PACKED;

float upsample(ivec2 pixel, float depth) {
    ivec2 last = textureSize(visibility_texture, 0) - 1;
    vec2 image = vec2(textureSize(depth_texture, 0));
    vec3 p = reconstruct_view_position((vec2(pixel) + 0.5) / image, depth, tangents);
    vec3 n = texelFetch(normal_texture, pixel, 0).xyz;
    vec2 place = 0.5 * vec2(pixel);
    ivec2 first = ivec2(floor(place));
    vec2 off = place - vec2(first);
    float sum = 0.0;
    float total = 0.0;
    for (int tap = 0; tap < 4; ++tap) {
        ivec2 step = ivec2(tap & 1, tap >> 1);
        ivec2 texel = min(first + step, last);
        float tap_depth = texelFetch(history_texture, texel, 0).a;
        vec3 q = reconstruct_view_position((vec2(2 * texel) + 0.5) / image, tap_depth, tangents);
        float off_plane = isinf(tap_depth) ? 1e6 : dot(q - p, n) / (param_filter_sigma * param_radius);
        vec2 near = mix(1.0 - off, off, vec2(step));
        // A tap that lies elsewhere still counts a little: some value must come out where none fits.
        float weight = (near.x * near.y + 1e-3) * (exp(-off_plane * off_plane) + 1e-6);
        sum += weight * texelFetch(visibility_texture, texel, 0).r;
        total += weight;
    }
    return sum / total;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) + border;
    if (param_resolution == param_resolution_full) {
        visibility = texelFetch(visibility_texture, pixel, 0).r;
        return;
    }
    vec4 texel = texelFetch(depth_texture, pixel, 0);
    float depth = kIsPacked ? texel.a : texel.r;
    visibility = isinf(depth) ? 1.0 : upsample(pixel, depth);
}
