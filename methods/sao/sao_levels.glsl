// Where the levels of the depth pyramid lie in their one texture: side by side, level 1 leftmost. Level m holds one of
// every 2^m x 2^m pixels of the depth buffer, which of them a rotated grid says.
// This work is based on: McGuire, Mara, Luebke. Scalable ambient obscurance. 2012.

// Column at which level `level` >= 1 begins, for a depth buffer of this width.
int find_level_column(int level, int width) {
    int column = 0;
    for (int k = 1; k < level; ++k) {
        column += max(width >> k, 1);
    }
    return column;
}

ivec2 compute_level_size(int level, ivec2 size) {
    return max(size >> level, ivec2(1));
}

// The pixel of the depth buffer that stands for a texel of a level.
ivec2 find_level_pixel(ivec2 texel, int level) {
    for (int k = 0; k < level; ++k) {
        texel = 2 * texel + ((texel.yx & 1) ^ 1);
    }
    return texel;
}
