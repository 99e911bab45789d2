// The box of a surface point on the screen, and its edges on the lattice of the (downsampled) tables.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, section 3.3.

// Background and depths that are no number have none: one of them in a sum would be in every sum beyond it.
bool has_surface(float depth) {
    return depth > 0.0 && !isinf(depth);
}

// Half the box's width and height in pixels: half_side metres at this eye depth, at least one pixel, in whole pixels and
// the half of the pixel in the middle, so that a box about a pixel holds whole pixels, the same number on each side.
vec2 compute_half_extent(float half_side, float depth, vec2 size, vec2 tangents) {
    vec2 pixels = half_side * size / (2.0 * tangents * depth);
    return max(vec2(1.0), floor(min(pixels, size) + 0.5)) + 0.5;
}

// From full-resolution pixels, whole or half, to samples of `factor` x `factor` pixels. The last sample of a row holds
// what is left of it.
vec2 convert_to_lattice(vec2 corner, vec2 size, float factor) {
    vec2 cell = floor((corner + 0.25) / factor);
    vec2 width = clamp(size - cell * factor, vec2(1.0), vec2(factor));
    return cell + max(corner - cell * factor, 0.0) / width;
}
