// First half of a summed-area table: a running sum down each column of the samples, one invocation a column.
// This work is based on: Crow. Summed-area tables for texture mapping. 1984.
#include "summed_area_format.glsl"
#include "summed_area_input.glsl"
layout(local_size_x = SAT_GROUP_SIZE) in;
layout(SAT_FORMAT, binding = 0) uniform writeonly SAT_IMAGE table;
uniform ivec2 samples;

void main() {
    int x = int(gl_GlobalInvocationID.x);
    if (x >= samples.x) {
        return;
    }
    SummedAreaInput state = begin_input();
    SAT_VALUE sum = SAT_VALUE(0);
    for (int y = 0; y < samples.y; ++y) {
        sum += read_input(state, ivec2(x, y));
        imageStore(table, ivec2(x, y) + 1, sum);
    }
}
