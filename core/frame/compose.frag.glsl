// The shaded picture from a method's image.
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D albedo_texture;
layout(binding = 2) uniform sampler2D direct_light_texture;
layout(binding = 3) uniform sampler2D method_texture; // visibility in r, or radiance in rgb
layout(binding = 5) uniform sampler2D normal_texture;
#include "core/frame/compose_surface.glsl"
layout(location = 0) out vec4 picture;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    if (isinf(depth)) {
        picture = vec4(show_surroundings(gl_FragCoord.xy / vec2(textureSize(eye_depth_texture, 0))), 1.0);
        return;
    }
    picture = vec4(shade(texelFetch(albedo_texture, pixel, 0).rgb,
                         texelFetch(direct_light_texture, pixel, 0).rgb,
                         texelFetch(normal_texture, pixel, 0).xyz,
                         texelFetch(method_texture, pixel, 0).rgb),
                   1.0);
}
