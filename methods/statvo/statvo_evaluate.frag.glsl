// Obscurance from the mean position of each layer's samples in the box around a surface point.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, equations (4) to (7).
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
#include "methods/statvo/statvo_nodes.glsl"
#include "methods/statvo/statvo_psi.glsl"
#include "methods/statvo/statvo_table_space.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D normal_texture;
layout(binding = 3) uniform sampler2D range_texture;
uniform vec2 tangents;
uniform ivec2 border; // pixels of the guard band
#ifdef ACCUMULATES
layout(binding = 2) uniform sampler2D occlusion_texture; // of the slices before this batch
layout(binding = 12) uniform sampler2D samples_texture;
uniform int batch; // slices in this batch
uniform bool is_first;
layout(location = 0) out vec4 occlusion;
layout(location = 1) out vec4 samples;
#else
const int batch = NODE_COUNT;
layout(location = 0) out float visibility;
#endif

struct Receiver {
    vec3 p;
    vec3 n;
    vec3 scale; // of the tables
};

// Psi times samples, and samples, of all layers that hold at least half a pixel of one region.
vec2 add_layers(Receiver receiver, vec2 low, vec2 high, int layers) {
    vec4 nodes[NODE_COUNT];
    sum_nodes(low, high, nodes);
    vec2 sums = vec2(0.0);
    for (int i = 0; i < NODE_COUNT; ++i) {
        bool counts = nodes[i].w >= 0.5 && i < layers;
        vec3 above = nodes[i].xyz / (max(nodes[i].w, 0.5) * receiver.scale) - receiver.p;
        float along_view = above.z + (param_box == param_box_centre ? 0.5 * param_height : 0.0);
        float height = param_projection == param_projection_normal ? dot(above, receiver.n) : along_view;
        sums += counts ? nodes[i].w * vec2(compute_psi(height / param_height, param_drop), 1.0) : vec2(0.0);
    }
    return sums;
}

// The same for each region, in x of both if there is one.
void add_regions(Receiver receiver, vec2 pixel, vec2 half_extent, vec2 size, int layers, out vec4 sums, out vec4 counts) {
    float factor = float(param_downsample);
    vec2 low = convert_to_lattice(max(pixel + 0.5 - half_extent, 0.0), size, factor);
    vec2 high = convert_to_lattice(min(pixel + 0.5 + half_extent, size), size, factor);
    sums = vec4(0.0);
    counts = vec4(0.0);
    if (param_regions == param_regions_one) {
        vec2 whole = add_layers(receiver, low, high, layers);
        sums.x = whole.x;
        counts.x = whole.y;
        return;
    }
    // The pixel itself belongs to the upper right one.
    vec2 middle = convert_to_lattice(pixel, size, factor);
    vec2 a = add_layers(receiver, low, middle, layers);
    vec2 b = add_layers(receiver, vec2(middle.x, low.y), vec2(high.x, middle.y), layers);
    vec2 c = add_layers(receiver, vec2(low.x, middle.y), vec2(middle.x, high.y), layers);
    vec2 d = add_layers(receiver, middle, high, layers);
    sums = vec4(a.x, b.x, c.x, d.x);
    counts = vec4(a.y, b.y, c.y, d.y);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) + border;
    vec2 size = vec2(textureSize(eye_depth_texture, 0));
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    vec4 sums = vec4(0.0);
    vec4 counts = vec4(0.0);
    if (has_surface(depth)) {
        TableSpace space = make_table_space(texelFetch(range_texture, ivec2(0), 0), size, tangents);
        vec3 p = reconstruct_view_position((vec2(pixel) + 0.5) / size, depth, tangents) - space.centre;
        vec3 normal = texelFetch(normal_texture, pixel, 0).xyz;
        // A normal that is no number is none: nothing is above it.
        Receiver receiver = Receiver(p, dot(normal, normal) >= 0.0 ? normal : vec3(0.0), space.scale);
        vec2 half_extent = compute_half_extent(param_radius, depth, size, tangents);
        add_regions(receiver, vec2(pixel), half_extent, size, batch, sums, counts);
    }
#ifdef ACCUMULATES
    ivec2 place = ivec2(gl_FragCoord.xy);
    occlusion = sums + (is_first ? vec4(0.0) : texelFetch(occlusion_texture, place, 0));
    samples = counts + (is_first ? vec4(0.0) : texelFetch(samples_texture, place, 0));
#else
    visibility = compute_visibility(sums, counts, param_strength, param_regions == param_regions_four);
#endif
}
