// One direction of a separable blur that keeps to the receiver's tangent plane.
// This work is based on: Petschnigg, Szeliski, Agrawala, Cohen, Hoppe, Toyama. Digital photography with flash and
// no-flash image pairs. 2004 (joint bilateral filter).
#include "core/frame/reconstruct.glsl"
layout(binding = 0) uniform sampler2D visibility_texture;
layout(binding = 1) uniform sampler2D eye_depth_texture;
layout(binding = 2) uniform sampler2D normal_texture;
uniform ivec2 direction;      // (1,0) or (0,1)
uniform int radius;           // taps on each side
uniform float edge_distance;  // metres off the tangent plane at which a tap's weight is 1/e
uniform vec2 tangents;
layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(eye_depth_texture, 0) - 1;
    vec2 pixel_size = 1.0 / vec2(last + 1);
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    float sum = texelFetch(visibility_texture, pixel, 0).r;
    if (!isinf(depth)) {
        vec3 p = reconstruct_view_position(gl_FragCoord.xy * pixel_size, depth, tangents);
        vec3 n = texelFetch(normal_texture, pixel, 0).xyz;
        float total = 1.0;
        for (int offset = -radius; offset <= radius; ++offset) {
            ivec2 tap = pixel + offset * direction;
            float tap_depth = texelFetch(eye_depth_texture, clamp(tap, ivec2(0), last), 0).r;
            bool outside = any(lessThan(tap, ivec2(0))) || any(greaterThan(tap, last));
            if (offset == 0 || outside || isinf(tap_depth)) {
                continue;
            }
            vec3 q = reconstruct_view_position((vec2(tap) + 0.5) * pixel_size, tap_depth, tangents);
            float off_plane = dot(q - p, n) / edge_distance;
            float along = float(offset) / (0.5 * float(radius) + 0.5);
            float weight = exp(-off_plane * off_plane - 0.5 * along * along);
            sum += weight * texelFetch(visibility_texture, tap, 0).r;
            total += weight;
        }
        sum /= total;
    }
    visibility = sum;
}
