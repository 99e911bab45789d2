// What the surfaces of a deeper layer or of a further camera send: their direct light, and the light of the surroundings as
// if nothing blocked it, since their neighbourhood is not looked at.
#include "core/frame/octahedral.glsl"
layout(binding = 0) uniform sampler2D normal_texture;
layout(binding = 1) uniform sampler2D albedo_texture;
layout(binding = 2) uniform sampler2D direct_light_texture;
layout(binding = 3) uniform sampler2D prefiltered_texture;
uniform mat3 map_from_view; // of the camera that sees them
uniform bool sends_outward; // of a deeper layer: from the side that the mesh's normal points to
layout(location = 0) out vec4 sent;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 normal = texelFetch(normal_texture, pixel, 0);
    vec3 outward = sends_outward && normal.a > 0.5 ? -normal.xyz : normal.xyz;
    vec3 around = textureLod(prefiltered_texture, encode_octahedral(map_from_view * outward), 0.0).rgb;
    bool is_surface = dot(normal.xyz, normal.xyz) > 0.25;
    vec3 albedo = texelFetch(albedo_texture, pixel, 0).rgb;
    sent = vec4(is_surface ? texelFetch(direct_light_texture, pixel, 0).rgb + albedo * around : vec3(0.0), 1.0);
}
