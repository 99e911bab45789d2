// Second half of a summed-area table: a running sum along each row of column sums, in place, one invocation a row.
// This work is based on: Crow. Summed-area tables for texture mapping. 1984.
#include "summed_area_format.glsl"
layout(local_size_x = SAT_GROUP_SIZE) in;
layout(SAT_FORMAT, binding = 0) uniform SAT_IMAGE table;
uniform ivec2 samples;

void main() {
    int y = int(gl_GlobalInvocationID.x);
    if (y >= samples.y) {
        return;
    }
    SAT_VALUE sum = SAT_VALUE(0);
    for (int x = 0; x < samples.x; ++x) {
        ivec2 texel = ivec2(x, y) + 1;
        sum += imageLoad(table, texel);
        imageStore(table, texel, sum);
    }
}
