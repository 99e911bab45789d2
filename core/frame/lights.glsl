// Direct light on a surface point, with shadow maps (core/frame/scene_lights.hpp). Everything is in view space.
// This work is based on: Williams. Casting curved shadows on curved surfaces. 1978.
#include "light_counts.glsl"

struct Light {
    vec4 place; // w = 0: unit direction to the light; w = 1: position
    vec4 color; // irradiance that faces it, or intensity; w: first face, or -1 without shadow
    vec4 axis;  // of a spot's cone, away from the light; w: cosine of the outer angle, -2 without cone
    vec4 cone;  // x: cosine of the inner angle; y: number of faces
};
struct ShadowFace {
    vec4 rows[3]; // to the light's right, up and distance along its axis
    vec4 extent;  // x: half extent in metres, or tangent of half the angle; y: 1 if perspective
    vec4 corner;  // of the face in the atlas, texels
};
layout(std140) uniform LightBlock {
    vec4 light_numbers; // x: lights, y: texels a face's side
    vec4 world_from_view[3]; // columns
    Light lights[kMostLights];
    ShadowFace shadow_faces[kMostFaces];
};
layout(binding = 2) uniform sampler2D shadow_atlas;

// Half of a texel's diagonal over half of its side: a slope may run along it.
const float kDiagonal = 1.41421356;
// Tangent of 80 degrees: where a light grazes more, a bias that follows the slope swallows shadows.
const float kSteepest = 5.6712818;

// True if the face's map has something nearer to the light than p, which lies on a facet with normal f.
bool is_in_shadow(ShadowFace face, vec3 p, vec3 f) {
    vec3 q = vec3(dot(face.rows[0], vec4(p, 1.0)), dot(face.rows[1], vec4(p, 1.0)), dot(face.rows[2], vec4(p, 1.0)));
    float half_extent = face.extent.x * (face.extent.y > 0.5 ? q.z : 1.0);
    vec2 place = 0.5 + 0.5 * q.xy / half_extent;
    if (q.z <= 0.0 || any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, vec2(1.0)))) {
        return false;
    }
    float side = light_numbers.y;
    float stored = texelFetch(shadow_atlas, ivec2(face.corner.xy + place * side), 0).r;
    // How depth along the face's axis changes over the facet's plane, metre by metre across: off the axis of a perspective
    // also where the facet faces the light.
    vec3 g = vec3(dot(face.rows[0].xyz, f), dot(face.rows[1].xyz, f), dot(face.rows[2].xyz, f));
    vec3 ray = face.extent.y > 0.5 ? q / q.z : vec3(0.0, 0.0, 1.0);
    float slope = min(length(g.xy) / max(abs(dot(g, ray)), 1e-4), kSteepest);
    float bias = kDiagonal * half_extent / side * slope;
    return stored * (1.0 + 8.0 / 16777216.0) + bias < q.z;
}

// Faces of a cube in the order +x -x +y -y +z -z of world axes.
int choose_face(vec3 from_light) {
    vec3 d = world_from_view[0].xyz * from_light.x + world_from_view[1].xyz * from_light.y +
             world_from_view[2].xyz * from_light.z;
    vec3 size = abs(d);
    if (size.x >= size.y && size.x >= size.z) {
        return d.x >= 0.0 ? 0 : 1;
    }
    return size.y >= size.z ? (d.y >= 0.0 ? 2 : 3) : (d.z >= 0.0 ? 4 : 5);
}

// Irradiance at p with shading normal n on a facet with normal f, all lights together.
vec3 compute_irradiance(vec3 p, vec3 n, vec3 f) {
    vec3 irradiance = vec3(0.0);
    for (int i = 0; i < int(light_numbers.x); ++i) {
        Light light = lights[i];
        vec3 to_light = light.place.xyz - light.place.w * p;
        float squared = light.place.w > 0.5 ? dot(to_light, to_light) : 1.0;
        vec3 direction = light.place.w > 0.5 ? to_light * inversesqrt(max(squared, 1e-12)) : to_light;
        float factor = max(dot(n, direction), 0.0) / max(squared, 1e-12);
        if (light.axis.w > -1.5) {
            float inside = clamp((-dot(direction, light.axis.xyz) - light.axis.w) / (light.cone.x - light.axis.w), 0.0, 1.0);
            factor *= inside * inside;
        }
        int first = int(light.color.w);
        if (factor > 0.0 && first >= 0) {
            int face = light.cone.y > 1.5 ? first + choose_face(-to_light) : first;
            factor = is_in_shadow(shadow_faces[face], p, f) ? 0.0 : factor;
        }
        irradiance += light.color.rgb * factor;
    }
    return irradiance;
}
