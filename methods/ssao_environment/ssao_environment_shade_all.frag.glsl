// Mean visibility multiplied on all light: that of the surroundings, and direct light with its shadow maps.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009, figure
// 10: the ambient-occlusion term on top that cannot replace shadows.
#include "core/frame/octahedral.glsl"
layout(binding = 0) uniform sampler2D visibility_texture;
layout(binding = 1) uniform sampler2D normal_texture;
layout(binding = 2) uniform sampler2D albedo_texture;
layout(binding = 3) uniform sampler2D direct_light_texture;
layout(binding = 4) uniform sampler2D prefiltered_texture;
uniform mat3 map_from_view;
layout(location = 0) out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 normal = texelFetch(normal_texture, pixel, 0).xyz;
    bool is_surface = dot(normal, normal) > 0.25;
    vec3 around = textureLod(prefiltered_texture, encode_octahedral(map_from_view * normal), 0.0).rgb;
    vec3 light = texelFetch(direct_light_texture, pixel, 0).rgb + texelFetch(albedo_texture, pixel, 0).rgb * around;
    radiance = vec4(is_surface ? texelFetch(visibility_texture, pixel, 0).r * light : vec3(0.0), 1.0);
}
