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
    vec3 n = texelFetch(normal_texture, pixel, 0).xyz;
    // Positions are linear in place x depth, and so is their height over the plane: dot(q, n) = depth (base + dot(slope,
    // place)), relative to the pixel so that large depths lose nothing.
    float base = dot(reconstruct_view_position(gl_FragCoord.xy * pixel_size, 1.0, tangents), n);
    vec2 slope = 2.0 * tangents * pixel_size * n.xy;
    float scale = 1.0 / edge_distance;
    vec2 texel_size = 1.0 / vec2(textureSize(visibility_texture, 0));
    float reach = 0.5 * float(width) + 1.0;
    // The pixel of texel t has its centre at 2 t + 0.5, or one further. At least the pixel's own texel and those on each
    // side: see kWindowRest.
    vec2 first = min(ceil(0.5 * (gl_FragCoord.xy - reach - 0.5)), floor(0.5 * gl_FragCoord.xy) - 1.0);
    int taps = max(3, int(ceil(reach)));
    float sum = 0.0;
    float total = 0.0;
    for (int y = 0; y < taps; ++y) {
        for (int x = 0; x < taps; ++x) {
            vec2 texel = first + vec2(x, y);
            vec2 uv = (texel + 0.5) * texel_size;
            vec2 selected = textureLod(selection_texture, uv, 0.0).rg;
            vec2 off = 2.0 * texel + 0.5 + find_place(selected.g) - gl_FragCoord.xy;
            vec2 window = compute_window(off);
            float height = (selected.r * (base + dot(slope, off)) - depth * base) * scale;
            float weight = isinf(selected.r) ? kBackgroundRest : exp(-height * height) + kSurfaceRest;
            bool is_inside = all(greaterThan(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
            weight = is_inside ? weight * window.x * window.y : 0.0;
            sum += weight * textureLod(visibility_texture, uv, 0.0).r;
            total += weight;
        }
    }
    visibility = sum / total;
}
