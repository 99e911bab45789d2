#include "core/gl/known_load.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f, binding = 0) uniform writeonly image2D target_image;
uniform int iterations;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    float seed = dot(vec2(pixel) + 0.5, vec2(1.0, 0.37)) / 256.0;
    imageStore(target_image, pixel, vec4(run_known_load(iterations, seed)));
}
