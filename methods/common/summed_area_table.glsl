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

// Over a rectangle that may cut through samples, which count by their share of area: linear interpolation of the table.
// The differences come before the weights, so that whole numbers stay exact: for each axis the sum from a to b is that of
// whole samples from floor(a) to floor(b), plus the share of b's own sample, minus the share of a's.
vec4 sum_area(SAT_SAMPLER table, vec2 low, vec2 high) {
    ivec2 a = ivec2(low);
    ivec2 b = ivec2(high);
    vec2 share_a = low - vec2(a);
    vec2 share_b = high - vec2(b);
    ivec2 last = textureSize(table, 0) - 1;
    ivec2 a1 = min(a + 1, last);
    ivec2 b1 = min(b + 1, last);
    int rows[4] = int[4](a.y, a1.y, b.y, b1.y);
    SAT_VALUE whole[4];
    SAT_VALUE left[4];
    SAT_VALUE right[4];
    for (int i = 0; i < 4; ++i) {
        SAT_VALUE at_a = texelFetch(table, ivec2(a.x, rows[i]), 0);
        SAT_VALUE at_b = texelFetch(table, ivec2(b.x, rows[i]), 0);
        whole[i] = at_b - at_a;
        left[i] = texelFetch(table, ivec2(a1.x, rows[i]), 0) - at_a;
        right[i] = texelFetch(table, ivec2(b1.x, rows[i]), 0) - at_b;
    }
    vec4 sums[3];
    for (int k = 0; k < 3; ++k) {
        int upper = k == 0 ? 2 : k == 1 ? 1 : 3;
        int lower = k == 2 ? 2 : 0;
        sums[k] = convert_sum(whole[upper] - whole[lower]) + share_b.x * convert_sum(right[upper] - right[lower]) -
                  share_a.x * convert_sum(left[upper] - left[lower]);
    }
    return sums[0] + share_b.y * sums[2] - share_a.y * sums[1];
}

vec4 sum_rectangle(SAT_SAMPLER table, vec2 low, vec2 high) {
    return SAT_INTERPOLATED ? sum_area(table, low, high) : sum_samples(table, ivec2(low + 0.25), ivec2(high + 0.25));
}
