// A point against the shadow maps of one light (methods/common/shadow_maps.hpp), with the bias that follows the slope.
// This work is based on: Williams. Casting curved shadows on curved surfaces. 1978; Ritschel, Grosch, Seidel. Approximating
// dynamic global illumination in image space. 2009, figure 8: b = p / 2 tan alpha, p the side of a texel on a surface that
// faces the light, alpha the angle between light direction and normal. Distances are measured along the ray from the light,
// not along the map's axis, so that the formula holds off the axis as well.
#include "shadow_map_counts.glsl"
layout(binding = 12) uniform sampler2D map_texture[kFaces]; // eye depth of the map's camera, infinite where nothing is
uniform mat4 map_from_view[kFaces];                         // to the map's camera, which looks along -z
uniform float map_extent;                                   // tangent of half the angle of view, or half the width in metres
uniform bool map_is_perspective;
uniform float map_side; // texels

const int kBiasNone = 0;
const int kBiasSlope = 1;
const int kBiasClamped = 2;
// Tangent of 80 degrees: where a light grazes more, a bias that follows the slope swallows shadows.
const float kSteepest = 5.6712818;
// Rounding of a 32-bit distance against a stored depth, whose ray is another one: 16 units in the last place.
const float kMapGuard = 1.0 + 16.0 / 16777216.0;

struct MapPlace {
    bool is_seen; // false: the map does not show the point
    int face;
    vec2 uv;
    float range;   // metres from the light, or along the axis of a map without perspective
    float texel_m; // p
};

MapPlace find_on_map(vec3 p) {
    vec3 q = (map_from_view[0] * vec4(p, 1.0)).xyz;
    int face = 0;
    for (int i = 1; i < kFaces; ++i) {
        // Of a cube's faces the one with the largest depth shows it.
        vec3 other = (map_from_view[i] * vec4(p, 1.0)).xyz;
        if (-other.z > -q.z) {
            q = other;
            face = i;
        }
    }
    float half_width = map_extent * (map_is_perspective ? -q.z : 1.0);
    vec2 uv = 0.5 + 0.5 * q.xy / half_width;
    bool is_inside = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    // A cube has no outside: what rounding puts beyond an edge lies on it.
    uv = kFaces > 1 ? clamp(uv, 0.0, 1.0) : uv;
    float range = map_is_perspective ? length(q) : -q.z;
    float texel_m = 2.0 * map_extent * (map_is_perspective ? range : 1.0) / map_side;
    return MapPlace(q.z < 0.0 && (kFaces > 1 || is_inside), face, uv, range, texel_m);
}

// Metres. cosine: of alpha; scale: factor on p / 2; most_m: limit of the clamped bias.
float compute_map_bias(int kind, float texel_m, float cosine, float scale, float most_m) {
    float tangent = sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 1e-4);
    float half_texel = 0.5 * scale * texel_m;
    float clamped = min(half_texel * min(tangent, kSteepest), most_m);
    return kind == kBiasNone ? 0.0 : kind == kBiasSlope ? half_texel * tangent : clamped;
}

// True if the map has something nearer to the light than the place, by more than the bias.
bool is_in_map_shadow(MapPlace at, float bias_m) {
    ivec2 texel = min(ivec2(at.uv * map_side), ivec2(map_side) - 1);
    float stored = 1.0 / 0.0;
    for (int i = 0; i < kFaces; ++i) {
        if (i == at.face) {
            stored = texelFetch(map_texture[i], texel, 0).r;
        }
    }
    vec2 centre = 2.0 * (vec2(texel) + 0.5) / map_side - 1.0;
    float stored_range = map_is_perspective ? stored * length(vec3(centre * map_extent, 1.0)) : stored;
    return at.is_seen && stored_range * kMapGuard + bias_m < at.range;
}
