// How a kernel is turned about its axis, by the parameter `rotation` (describe_rotation).
#include "methods/common/noise.glsl"

// Radians in [0, 2 pi).
float compute_turn(ivec2 pixel, uint seed) {
    float turn = 0.0;
    if (param_rotation == param_rotation_tile) {
        turn = compute_tile_noise(pixel, seed);
    } else if (param_rotation == param_rotation_pixel) {
        turn = compute_pixel_noise(pixel, seed);
    }
    return 6.2831853 * turn;
}

void rotate_about_axis(inout vec3 tangent, inout vec3 bitangent, float angle) {
    vec3 turned = cos(angle) * tangent + sin(angle) * bitangent;
    bitangent = cos(angle) * bitangent - sin(angle) * tangent;
    tangent = turned;
}
