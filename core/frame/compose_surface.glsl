// One surface point of the shaded picture.
#include "core/frame/octahedral.glsl"
#include "core/frame/reconstruct.glsl"
layout(binding = 6) uniform sampler2D surroundings_texture;
layout(binding = 7) uniform sampler2D prefiltered_texture;
uniform mat3 map_from_view;
uniform vec2 tangents;
uniform bool is_radiance;
uniform bool adds_direct_light;

vec3 shade(vec3 albedo, vec3 direct, vec3 normal, vec3 method_value) {
    vec3 indirect = method_value;
    if (!is_radiance) {
        vec2 place = encode_octahedral(map_from_view * normal);
        indirect = textureLod(prefiltered_texture, place, 0.0).rgb * albedo * method_value.r;
    }
    return adds_direct_light ? direct + indirect : indirect;
}

// What the surroundings show at a pixel: between the middles of the four texels around, since texels would show, as
// Environment::interpolate. uv in [0,1], (0,0) bottom left.
vec3 show_surroundings(vec2 uv) {
    vec3 direction = reconstruct_view_position(uv, 1.0, tangents);
    int side = textureSize(surroundings_texture, 0).x;
    vec2 place = encode_octahedral(map_from_view * direction) * float(side) - 0.5;
    ivec2 corner = ivec2(floor(place));
    vec2 share = fract(place);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i % 2, i / 2);
        vec2 weight = mix(1.0 - share, share, vec2(step));
        sum += weight.x * weight.y * texelFetch(surroundings_texture, wrap_octahedral(corner + step, side), 0).rgb;
    }
    return sum;
}
