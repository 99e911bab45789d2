// The shaded picture from a method's image over a multisampled G-buffer: every sample is shaded and
// the mean is kept. A pixel has one value of the method, that of its centre.
layout(binding = 0) uniform sampler2DMS eye_depth_texture;
layout(binding = 1) uniform sampler2DMS albedo_texture;
layout(binding = 2) uniform sampler2DMS direct_light_texture;
layout(binding = 3) uniform sampler2D method_texture; // visibility in r, or radiance in rgb
uniform int samples;
#include "core/frame/compose_surface.glsl"
layout(location = 0) out vec4 picture;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 method_value = texelFetch(method_texture, pixel, 0).rgb;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        sum += shade(texelFetch(eye_depth_texture, pixel, i).r,
                     texelFetch(albedo_texture, pixel, i).rgb,
                     texelFetch(direct_light_texture, pixel, i).rgb, method_value);
    }
    picture = vec4(sum / float(samples), 1.0);
}
