// The sums of all layers of one level over a rectangle.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, algorithm 2.
#include "methods/common/summed_area_table.glsl"
// NODE_LEVEL: the level; NODE_COUNT: layers on it, or slices of a batch. Explicit: one table a layer. Differential: root,
// then the even layers of level 1, of level 2 and so on.
layout(binding = 4) uniform SAT_SAMPLER tables[NODE_COUNT];

void sum_nodes(vec2 low, vec2 high, out vec4 nodes[NODE_COUNT]) {
    if (param_layering == param_layering_uniform || param_tables == param_tables_all) {
        for (int i = 0; i < NODE_COUNT; ++i) {
            nodes[i] = sum_rectangle(tables[i], low, high);
        }
        return;
    }
    nodes[0] = sum_rectangle(tables[0], low, high);
    for (int level = 1; level <= NODE_LEVEL; ++level) {
        int parents = 1 << (level - 1);
        for (int k = parents - 1; k >= 0; --k) {
            vec4 even = sum_rectangle(tables[parents + k], low, high);
            nodes[2 * k + 1] = nodes[k] - even;
            nodes[2 * k] = even;
        }
    }
}
