// Splits every layer of a level in two: samples nearer than the mean depth around them go to the upper layer, the others,
// those exactly at it among them, to the lower.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, section 5 and algorithm 1.
#include "parameters.glsl"
#include "methods/statvo/statvo_table_space.glsl"
#include "methods/statvo/statvo_nodes.glsl"
layout(binding = 0) uniform sampler2D visible_texture;
layout(binding = 1) uniform sampler2D hidden_texture;
layout(binding = 2) uniform usampler2D layer_texture; // of the level before
layout(binding = 3) uniform sampler2D range_texture;
uniform vec2 size; // full resolution
uniform vec2 tangents;
layout(location = 0) out uvec2 layers;

uint split_sample(vec4 samples, uint parent, vec2 center, TableSpace space, vec2 size, vec2 tangents) {
    if (samples.w == 0.0) {
        return 2u * parent;
    }
    float z = samples.z / samples.w;
    vec2 half_extent = compute_half_extent(param_radius, -z, size, tangents);
    float factor = float(param_downsample);
    vec2 low = convert_to_lattice(max(center - half_extent, 0.0), size, factor);
    vec2 high = convert_to_lattice(min(center + half_extent, size), size, factor);
    vec4 nodes[NODE_COUNT];
    sum_nodes(low, high, nodes);
    vec4 node = nodes[0];
    for (int i = 1; i < NODE_COUNT; ++i) {
        node = uint(i) == parent ? nodes[i] : node;
    }
    float offset = (z - space.centre.z) * space.scale.z;
    bool is_upper = node.w >= 0.5 && offset > node.z / node.w;
    return 2u * parent + (is_upper ? 0u : 1u);
}

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    TableSpace space = make_table_space(texelFetch(range_texture, ivec2(0), 0), size, tangents);
    vec2 first = vec2(place * param_downsample);
    vec2 center = 0.5 * (first + min(first + float(param_downsample), size));
    uvec2 parents = NODE_COUNT == 1 ? uvec2(0u) : texelFetch(layer_texture, place, 0).rg;
    layers.r = split_sample(texelFetch(visible_texture, place, 0), parents.r, center, space, size, tangents);
    layers.g = param_source == param_source_peeled
                   ? split_sample(texelFetch(hidden_texture, place, 0), parents.g, center, space, size, tangents)
                   : 0u;
}
