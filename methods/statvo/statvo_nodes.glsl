// The sums of all layers of one level over a rectangle.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, algorithm 2.
#include "methods/common/summed_area_table.glsl"
// NODE_COUNT: layers of the level, or slices of a batch. HAS_ALL_TABLES: one table a layer; otherwise the root's, then
// those of the even layers of level 1, of level 2 and so on, and the odd layers are what is left of their parents.
layout(binding = 4) uniform SAT_SAMPLER tables[NODE_COUNT];

// Written out: llvmpipe does not unroll loops over the lookups.
#define SUM_TABLE(i) sum_rectangle(tables[i], low, high)

void split_node(inout vec4 nodes[NODE_COUNT], int node, vec4 even) {
    nodes[2 * node + 1] = nodes[node] - even;
    nodes[2 * node] = even;
}

void sum_nodes(vec2 low, vec2 high, out vec4 nodes[NODE_COUNT]) {
    nodes[0] = SUM_TABLE(0);
#if HAS_ALL_TABLES
#if NODE_COUNT > 1
    nodes[1] = SUM_TABLE(1);
#endif
#if NODE_COUNT > 2
    nodes[2] = SUM_TABLE(2);
#endif
#if NODE_COUNT > 3
    nodes[3] = SUM_TABLE(3);
#endif
#if NODE_COUNT > 4
    nodes[4] = SUM_TABLE(4);
#endif
#if NODE_COUNT > 5
    nodes[5] = SUM_TABLE(5);
#endif
#if NODE_COUNT > 6
    nodes[6] = SUM_TABLE(6);
#endif
#if NODE_COUNT > 7
    nodes[7] = SUM_TABLE(7);
#endif
#else
#if NODE_COUNT > 1
    split_node(nodes, 0, SUM_TABLE(1));
#endif
#if NODE_COUNT > 2
    split_node(nodes, 1, SUM_TABLE(3));
    split_node(nodes, 0, SUM_TABLE(2));
#endif
#if NODE_COUNT > 4
    split_node(nodes, 3, SUM_TABLE(7));
    split_node(nodes, 2, SUM_TABLE(6));
    split_node(nodes, 1, SUM_TABLE(5));
    split_node(nodes, 0, SUM_TABLE(4));
#endif
#endif
}
