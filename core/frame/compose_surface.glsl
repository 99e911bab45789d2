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

// What the surroundings show at a pixel. uv in [0,1], (0,0) bottom left.
vec3 show_surroundings(vec2 uv) {
    vec3 direction = reconstruct_view_position(uv, 1.0, tangents);
    return textureLod(surroundings_texture, encode_octahedral(map_from_view * direction), 0.0).rgb;
}
