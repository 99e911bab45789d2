// Which of the sample sets a pixel takes (methods/common/sample_sets.hpp).
#include "sample_set_counts.glsl"
#include "methods/common/noise.glsl"
layout(std140) uniform KernelBlock { vec4 kernel[kTile * kTile * kSamples]; };

// Index of the set's first sample. All sets occur in every tile; the seed reorders them.
int find_sample_set(ivec2 pixel, uint seed) {
    ivec2 place = pixel % kTile;
    int set = place.x + kTile * place.y + int(hash_uint(seed) % uint(kTile * kTile));
    return set % (kTile * kTile) * kSamples;
}
