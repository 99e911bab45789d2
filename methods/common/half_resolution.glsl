// The full-resolution pixel that stands for a texel of a half-resolution image, as BilateralUpsample selects it.
struct HalfPixel {
    ivec2 pixel;  // of the full-resolution image
    float depth;  // its eye depth
};

// Where in its 2x2 a pixel lies, from x + 2 y.
vec2 find_place(float place) {
    return place > 1.5 ? vec2(place - 2.0, 1.0) : vec2(place, 0.0);
}

HalfPixel read_half_pixel(sampler2D selection_texture, ivec2 texel) {
    vec2 selected = texelFetch(selection_texture, texel, 0).rg;
    return HalfPixel(2 * texel + ivec2(find_place(selected.g)), selected.r);
}
