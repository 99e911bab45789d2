// From half to full resolution along the receiver's tangent plane, blurred over a window on the way.
// This work is based on: Kopf, Cohen, Lischinski, Uyttendaele. Joint bilateral upsampling. 2007.
#include "core/frame/reconstruct.glsl"
#include "methods/common/half_resolution.glsl"
layout(binding = 0) uniform sampler2D visibility_texture; // half resolution
layout(binding = 1) uniform sampler2D selection_texture;  // half resolution
layout(binding = 2) uniform sampler2D eye_depth_texture;
layout(binding = 3) uniform sampler2D normal_texture;
uniform int width;            // of the window, pixels of the full resolution
uniform float edge_distance;  // metres off the tangent plane at which a tap's weight is 1/e
uniform vec2 tangents;
layout(location = 0) out float visibility;

// What is left for a tap off the plane and for one of the background, so that a pixel that no tap fits still gets the
// value of a surface, and the background's 1 only where there is nothing else.
const float kSurfaceRest = 1e-6;
const float kBackgroundRest = 1e-12;
// Of a tap at the end of the window: beside a thin pole the only one on the same surface may be two pixels away.
const float kWindowRest = 1e-4;

// A box of `width` pixels drawn out by linear interpolation: taps two pixels apart that are equal modulo width / 2 weigh
// the same together wherever the pixel lies, so that a box of 8 takes out noise that repeats every 4x4 texels.
vec2 compute_window(vec2 off) {
    return clamp(0.5 * (0.5 * float(width) + 1.0 - abs(off)), kWindowRest, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    if (isinf(depth)) {
        visibility = 1.0;
        return;
    }
    vec3 p = reconstruct_view_position(gl_FragCoord.xy * pixel_size, depth, tangents);
    vec3 n = texelFetch(normal_texture, pixel, 0).xyz;
    ivec2 last = textureSize(visibility_texture, 0) - 1;
    float reach = 0.5 * float(width) + 1.0;
    // The pixel of texel t has its centre at 2 t + 0.5 or 2 t + 1.5.
    ivec2 first = max(ivec2(ceil(0.5 * (gl_FragCoord.xy - reach - 1.5))), ivec2(0));
    ivec2 end = min(ivec2(floor(0.5 * (gl_FragCoord.xy + reach - 0.5))), last);
    float sum = 0.0;
    float total = 0.0;
    for (int y = first.y; y <= end.y; ++y) {
        for (int x = first.x; x <= end.x; ++x) {
            ivec2 texel = ivec2(x, y);
            HalfPixel tap = read_half_pixel(selection_texture, texel);
            vec2 place = vec2(tap.pixel) + 0.5;
            vec2 window = compute_window(place - gl_FragCoord.xy);
            float weight = kBackgroundRest;
            if (!isinf(tap.depth)) {
                vec3 q = reconstruct_view_position(place * pixel_size, tap.depth, tangents);
                float off_plane = dot(q - p, n) / edge_distance;
                weight = exp(-off_plane * off_plane) + kSurfaceRest;
            }
            weight *= window.x * window.y;
            sum += weight * texelFetch(visibility_texture, texel, 0).r;
            total += weight;
        }
    }
    visibility = sum / total;
}
