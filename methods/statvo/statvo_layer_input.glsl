// What a summed-area table adds up: the samples of one layer, or all.
#include "parameters.glsl"
#include "methods/statvo/statvo_table_space.glsl"
layout(binding = 0) uniform sampler2D visible_texture;
layout(binding = 1) uniform sampler2D hidden_texture;
layout(binding = 2) uniform usampler2D layer_texture; // of the visible and of the hidden sample
layout(binding = 3) uniform sampler2D range_texture;
uniform int layer; // -1: all samples
uniform vec2 size; // full resolution
uniform vec2 tangents;

struct SummedAreaInput {
    TableSpace space;
    int layer;
};

SummedAreaInput begin_input() {
    return SummedAreaInput(make_table_space(texelFetch(range_texture, ivec2(0), 0), size, tangents), layer);
}

vec4 read_layer(sampler2D samples, ivec2 place, uint assigned, int wanted) {
    return wanted < 0 || int(assigned) == wanted ? texelFetch(samples, place, 0) : vec4(0.0);
}

SAT_VALUE read_input(SummedAreaInput state, ivec2 place) {
    uvec2 assigned = state.layer < 0 ? uvec2(0u) : texelFetch(layer_texture, place, 0).rg;
    vec4 sum = read_layer(visible_texture, place, assigned.r, state.layer);
    if (param_source == param_source_peeled) {
        sum += read_layer(hidden_texture, place, assigned.g, state.layer);
    }
    vec4 moved = vec4((sum.xyz - state.space.centre * sum.w) * state.space.scale, sum.w);
    return SAT_IS_FLOAT ? SAT_VALUE(moved) : SAT_VALUE(ivec4(roundEven(moved)));
}
