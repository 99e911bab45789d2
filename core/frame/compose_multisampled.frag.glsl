// The shaded picture from a method's image over a multisampled G-buffer: every sample is shaded and
// the mean is kept. A pixel has one value of the method, that of its centre; a sample takes its own
// pixel's, which at an edge may be another surface's, or that of the nearest depth around.
layout(binding = 0) uniform sampler2DMS eye_depth_texture;
layout(binding = 1) uniform sampler2DMS albedo_texture;
layout(binding = 2) uniform sampler2DMS direct_light_texture;
layout(binding = 3) uniform sampler2D method_texture; // visibility in r, or radiance in rgb
layout(binding = 4) uniform sampler2D pixel_depth_texture; // where takes_nearest
layout(binding = 5) uniform sampler2DMS normal_texture;
uniform int samples;
uniform bool takes_nearest;
#include "core/frame/compose_surface.glsl"
layout(location = 0) out vec4 picture;

// Of the 3x3 pixels around; equally near ones in favour of the pixel itself.
ivec2 find_nearest(ivec2 pixel, float sample_depth) {
    ivec2 last = textureSize(pixel_depth_texture, 0) - 1;
    ivec2 nearest = pixel;
    float least = abs(texelFetch(pixel_depth_texture, pixel, 0).r - sample_depth);
    for (int i = 0; i < 9; ++i) {
        ivec2 other = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
        float distance = abs(texelFetch(pixel_depth_texture, other, 0).r - sample_depth);
        if (distance < least) {
            least = distance;
            nearest = other;
        }
    }
    return nearest;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        float depth = texelFetch(eye_depth_texture, pixel, i).r;
        if (isinf(depth)) {
            sum += show_surroundings(gl_FragCoord.xy / vec2(textureSize(method_texture, 0)));
            continue;
        }
        ivec2 from = takes_nearest ? find_nearest(pixel, depth) : pixel;
        sum += shade(texelFetch(albedo_texture, pixel, i).rgb,
                     texelFetch(direct_light_texture, pixel, i).rgb,
                     texelFetch(normal_texture, pixel, i).xyz,
                     texelFetch(method_texture, from, 0).rgb);
    }
    picture = vec4(sum / float(samples), 1.0);
}
