// All levels of the depth pyramid in one pass.
// This work is based on: McGuire, Mara, Luebke. Scalable ambient obscurance. 2012, section 2.2: rotated-grid subsampling,
// so that every value is a real depth. Level m + 1 picks from level m; followed down to the depth buffer itself here.
#include "parameters.glsl"
#include "methods/sao/sao_levels.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(location = 0) out float eye_depth;

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(eye_depth_texture, 0);
    int level = 1;
    while (level < param_levels && place.x >= compute_level_size(level, size).x) {
        place.x -= compute_level_size(level, size).x;
        ++level;
    }
    ivec2 pixel = min(find_level_pixel(place, level), size - 1);
    eye_depth = texelFetch(eye_depth_texture, pixel, 0).r;
}
