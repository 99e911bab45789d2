// Per-pixel random numbers. The seed is the harness's: equal seed and pixel give equal numbers.

// This work is based on: Jarzynski, Olano. Hash functions for GPU rendering. 2020 (pcg).
uint hash_uint(uint value) {
    uint state = value * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Uniform in [0,1), 24 bits.
float compute_pixel_noise(ivec2 pixel, uint seed) {
    uint hashed = hash_uint(uint(pixel.x) + hash_uint(uint(pixel.y) + hash_uint(seed)));
    return float(hashed >> 8) * (1.0 / 16777216.0);
}

// One of 16 evenly spaced values in [0,1), all of which occur in every 4x4 tile, near ones far apart: the small
// random texture of published methods. The seed reorders them.
float compute_tile_noise(ivec2 pixel, uint seed) {
    uvec2 p = uvec2(pixel) & 3u;
    uint crossed = p.x ^ p.y;
    uint order = ((crossed & 1u) << 3u) | ((p.y & 1u) << 2u) | (crossed & 2u) | (p.y >> 1u);
    return float(order ^ (hash_uint(seed) & 15u)) * (1.0 / 16.0);
}
