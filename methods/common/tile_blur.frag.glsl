// One direction of the mean over a tile of sample sets, along surfaces.
// This work is based on: Segovia, Iehl, Mitanchey, Peroche. Non-interleaved deferred shading of interleaved sample
// patterns. 2006.
#include "core/frame/reconstruct.glsl"
layout(binding = 0) uniform sampler2D incoming_texture; // rgb: mean incoming radiance, a: eye depth
layout(binding = 1) uniform sampler2D normal_texture;
layout(binding = 2) uniform sampler2D albedo_texture;
uniform ivec2 direction;        // (1,0) or (0,1)
uniform int tile;               // pixels a side; 1: no blur
uniform int finish;             // 0: as it is, with depth; 1: times albedo, 0 on the background; 2: visibility: at most 1, and 1 there
uniform float edge_distance;    // metres off the tangent plane at which a tap's weight is 1/e
uniform vec2 tangents;
layout(location = 0) out vec4 result;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(incoming_texture, 0) - 1;
    vec2 pixel_size = 1.0 / vec2(last + 1);
    vec4 centre = texelFetch(incoming_texture, pixel, 0);
    if (isinf(centre.a)) {
        result = vec4(vec3(finish == 2 ? 1.0 : 0.0), centre.a);
        return;
    }
    vec3 sum = centre.rgb;
    if (tile > 1) {
        vec3 p = reconstruct_view_position(gl_FragCoord.xy * pixel_size, centre.a, tangents);
        vec3 n = normalize(texelFetch(normal_texture, pixel, 0).xyz);
        float total = 1.0;
        int reach = tile / 2;
        for (int offset = -reach; offset <= reach; ++offset) {
            ivec2 tap = clamp(pixel + offset * direction, ivec2(0), last);
            vec4 value = texelFetch(incoming_texture, tap, 0);
            if (offset == 0 || isinf(value.a)) {
                continue;
            }
            vec3 q = reconstruct_view_position((vec2(tap) + 0.5) * pixel_size, value.a, tangents);
            float off_plane = dot(q - p, n) / edge_distance;
            // To the eighth power: 1/2 at 24 degrees, nothing across an edge of a box.
            float cosine = clamp(dot(n, texelFetch(normal_texture, tap, 0).xyz), 0.0, 1.0);
            // The ends of an even tile are the same set: half a weight each.
            float share = tile % 2 == 0 && abs(offset) == reach ? 0.5 : 1.0;
            cosine *= cosine;
            cosine *= cosine;
            float weight = share * exp(-off_plane * off_plane) * cosine * cosine;
            sum += weight * value.rgb;
            total += weight;
        }
        sum /= total;
    }
    vec3 factor = finish == 1 ? texelFetch(albedo_texture, pixel, 0).rgb : vec3(1.0);
    // A pixel's own samples may weigh a little more than 1; their mean over the tile does not.
    result = vec4(finish == 2 ? min(sum, vec3(1.0)) : sum * factor, centre.a);
}
