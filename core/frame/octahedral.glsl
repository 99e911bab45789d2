// Texture coordinates of a direction in an octahedral map, and texels beyond its border, as core/base/environment.hpp.
// This work is based on: Cigolle, Donow, Evangelakos, Mara, McGuire, Meyer. A survey of efficient representations for
// independent unit vectors. 2014.
vec2 encode_octahedral(vec3 direction) {
    vec3 size = abs(direction);
    vec2 square = direction.xz / (size.x + size.y + size.z);
    vec2 folded = (1.0 - abs(square.yx)) * vec2(square.x >= 0.0 ? 1.0 : -1.0, square.y >= 0.0 ? 1.0 : -1.0);
    return 0.5 + 0.5 * (direction.y >= 0.0 ? square : folded);
}

// `texel`: up to one beyond the border of a map of `side` x `side` texels.
ivec2 wrap_octahedral(ivec2 texel, int side) {
    ivec2 wrapped = texel;
    if (texel.x < 0 || texel.x >= side) {
        wrapped = ivec2(texel.x < 0 ? 0 : side - 1, side - 1 - wrapped.y);
    }
    if (wrapped.y < 0 || wrapped.y >= side) {
        wrapped = ivec2(side - 1 - wrapped.x, wrapped.y < 0 ? 0 : side - 1);
    }
    return wrapped;
}
