// Sums over rectangles from a summed-area table.
// This work is based on: Crow. Summed-area tables for texture mapping. 1984.
#include "summed_area_format.glsl"

vec4 convert_sum(vec4 sum) {
    return sum;
}
// What wrapped around on the way is right again as a signed number if the rectangle's own sum fits.
vec4 convert_sum(uvec4 sum) {
    return vec4(ivec4(sum));
}

// Over whole samples: low <= (i, j) < high.
vec4 sum_samples(SAT_SAMPLER table, ivec2 low, ivec2 high) {
    SAT_VALUE top = texelFetch(table, high, 0) - texelFetch(table, ivec2(low.x, high.y), 0);
    SAT_VALUE bottom = texelFetch(table, ivec2(high.x, low.y), 0) - texelFetch(table, low, 0);
    return convert_sum(top - bottom);
}

// One row of the lattice between two samples' columns: from a to b, from a to the next, from b to the next.
struct LatticeRow {
    SAT_VALUE whole;
    SAT_VALUE left;
    SAT_VALUE right;
};

LatticeRow read_lattice_row(SAT_SAMPLER table, ivec2 columns, ivec2 next_columns, int row) {
    SAT_VALUE at_a = texelFetch(table, ivec2(columns.x, row), 0);
    SAT_VALUE at_b = texelFetch(table, ivec2(columns.y, row), 0);
    SAT_VALUE left = texelFetch(table, ivec2(next_columns.x, row), 0) - at_a;
    return LatticeRow(at_b - at_a, left, texelFetch(table, ivec2(next_columns.y, row), 0) - at_b);
}

vec4 sum_rows(LatticeRow upper, LatticeRow lower, float share_a, float share_b) {
    vec4 sum = convert_sum(upper.whole - lower.whole);
    return sum + share_b * convert_sum(upper.right - lower.right) - share_a * convert_sum(upper.left - lower.left);
}

// Over a rectangle that may cut through samples, which count by their share of area: linear interpolation of the table.
// The differences come before the weights, so that whole numbers stay exact: for each axis the sum from a to b is that of
// whole samples from floor(a) to floor(b), plus the share of b's own sample, minus the share of a's.
// Written out: loops over it were not unrolled by llvmpipe, which made arrays and samplers indirect and cost a factor 2.
vec4 sum_area(SAT_SAMPLER table, vec2 low, vec2 high) {
    ivec2 a = ivec2(low);
    ivec2 b = ivec2(high);
    vec2 share_a = low - vec2(a);
    vec2 share_b = high - vec2(b);
    ivec2 last = textureSize(table, 0) - 1;
    ivec2 a1 = min(a + 1, last);
    ivec2 b1 = min(b + 1, last);
    ivec2 columns = ivec2(a.x, b.x);
    ivec2 next_columns = ivec2(a1.x, b1.x);
    LatticeRow at_a = read_lattice_row(table, columns, next_columns, a.y);
    LatticeRow after_a = read_lattice_row(table, columns, next_columns, a1.y);
    LatticeRow at_b = read_lattice_row(table, columns, next_columns, b.y);
    LatticeRow after_b = read_lattice_row(table, columns, next_columns, b1.y);
    vec4 whole = sum_rows(at_b, at_a, share_a.x, share_b.x);
    vec4 lower = sum_rows(after_a, at_a, share_a.x, share_b.x);
    vec4 upper = sum_rows(after_b, at_b, share_a.x, share_b.x);
    return whole + share_b.y * upper - share_a.y * lower;
}

vec4 sum_rectangle(SAT_SAMPLER table, vec2 low, vec2 high) {
    return SAT_INTERPOLATED ? sum_area(table, low, high) : sum_samples(table, ivec2(low + 0.25), ivec2(high + 0.25));
}
