// What a picture, or a visibility image, takes from a sum of lights (methods/common/light_sum.hpp).
#include "core/frame/octahedral.glsl"
layout(binding = 0) uniform sampler2D arriving_texture; // irradiance
layout(binding = 1) uniform sampler2D open_texture;     // the same as if nothing blocked it
layout(binding = 2) uniform sampler2D normal_texture;
layout(binding = 3) uniform sampler2D albedo_texture;
layout(binding = 4) uniform sampler2D prefiltered_texture;
layout(binding = 5) uniform sampler2D reflected_texture;
uniform mat3 map_from_view;
uniform bool adds_surroundings;
uniform bool adds_reflected;
uniform bool shows_visibility;
layout(location = 0) out vec4 result;

const float kPi = 3.14159265;
const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 normal = texelFetch(normal_texture, pixel, 0).xyz;
    bool is_surface = dot(normal, normal) > 0.25;
    vec3 around = vec3(0.0);
    if (adds_surroundings && is_surface) {
        around = kPi * textureLod(prefiltered_texture, encode_octahedral(map_from_view * normal), 0.0).rgb;
    }
    vec3 arriving = texelFetch(arriving_texture, pixel, 0).rgb + around;
    if (shows_visibility) {
        float open = dot(kLuminance, texelFetch(open_texture, pixel, 0).rgb + around);
        result = vec4(is_surface && open > 0.0 ? clamp(dot(kLuminance, arriving) / open, 0.0, 1.0) : 1.0);
    } else {
        vec3 reflected = adds_reflected ? texelFetch(reflected_texture, pixel, 0).rgb : vec3(0.0);
        vec3 radiance = texelFetch(albedo_texture, pixel, 0).rgb * arriving / kPi + reflected;
        result = vec4(is_surface ? radiance : vec3(0.0), 1.0);
    }
}
