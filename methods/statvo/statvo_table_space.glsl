// What the tables subtract from positions and multiply them with, over a whole frame.
#include "methods/statvo/statvo_box.glsl"

struct TableSpace {
    vec3 centre; // metres in view space
    vec3 scale;  // table units a metre
};

// `range`: smallest and largest eye depth, sum of eye depths, number of pixels with a surface.
TableSpace make_table_space(vec4 range, vec2 size, vec2 tangents) {
    TableSpace space = TableSpace(vec3(0.0), vec3(1.0));
    if (param_numbers == param_numbers_float32 || range.w == 0.0) {
        return space;
    }
    if (param_numbers == param_numbers_float32_centred) {
        space.centre.z = -range.z / range.w;
        return space;
    }
    // Whole numbers: the largest box of the frame, that of its nearest surface, and the farthest position in it must fit
    // into 31 bits. Interpolation asks for a sample more on each side. One percent is left for rounding.
    float factor = float(param_downsample);
    vec2 box = min(2.0 * compute_half_extent(param_radius, range.x, size, tangents) + 2.0 * factor, size);
    float samples = box.x * box.y * (param_source == param_source_peeled ? 2.0 : 1.0);
    space.centre.z = -0.5 * (range.x + range.y);
    vec3 reach = vec3(tangents * range.y, max(0.5 * (range.y - range.x), 1e-6 * range.y));
    space.scale = 0.99 * 2147483648.0 / (samples * reach);
    return space;
}
