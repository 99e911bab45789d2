// The full-resolution pixel that stands for a texel of a half-resolution image, as BilateralUpsample selects it.
struct HalfPixel {
    ivec2 pixel;  // of the full-resolution image
    float depth;  // its eye depth
};

HalfPixel read_half_pixel(sampler2D selection_texture, ivec2 texel) {
    vec2 selected = texelFetch(selection_texture, texel, 0).rg;
    int place = int(selected.g);
    return HalfPixel(2 * texel + ivec2(place & 1, place >> 1), selected.r);
}
