// The random numbers of a texel and the vectors made of them.
#include "methods/common/noise.glsl"

const float kTwoPi = 6.2831853;

struct TexelRandom {
    float angle;      // of the turn about the normal, and of the random vector about z
    vec3 direction;   // uniform on the sphere
    vec2 offsets;     // in [0,1): for the indices of directions and of lengths
};

// Four numbers in [0,1) for each of 16 places: a lattice, so that every tile holds angles, elevations and offsets evenly
// spread. Odd factors: each of the four runs over all sixteenths.
vec4 compute_tile_numbers(ivec2 texel, uint seed) {
    vec4 shift = vec4(compute_pixel_noise(ivec2(0, 0), seed), compute_pixel_noise(ivec2(1, 0), seed),
                      compute_pixel_noise(ivec2(2, 0), seed), compute_pixel_noise(ivec2(3, 0), seed));
    return fract(compute_tile_noise(texel, seed) * vec4(1.0, 5.0, 11.0, 3.0) + shift);
}

vec4 compute_pixel_numbers(ivec2 texel, uint seed) {
    return vec4(compute_pixel_noise(texel, seed), compute_pixel_noise(texel, seed + 0x9e3779b9u),
                compute_pixel_noise(texel, seed + 0x3c6ef372u), compute_pixel_noise(texel, seed + 0xdaa66d2bu));
}

TexelRandom compute_texel_random(ivec2 texel, uint seed) {
    vec4 u = param_randomisation == param_randomisation_tile    ? compute_tile_numbers(texel, seed)
             : param_randomisation == param_randomisation_pixel ? compute_pixel_numbers(texel, seed)
                                                                : vec4(0.0);
    float z = 2.0 * u.y - 1.0;
    float horizontal = sqrt(max(0.0, 1.0 - z * z));
    float angle = kTwoPi * u.x;
    return TexelRandom(angle, vec3(horizontal * cos(angle), horizontal * sin(angle), z), u.zw);
}
