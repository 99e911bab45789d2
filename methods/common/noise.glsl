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
