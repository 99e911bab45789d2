// Is a point behind what the G-buffer knows of the scene: one to four depth layers of the viewer, and the nearest
// surfaces of further cameras?
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// section 3 (a point that moves towards the viewer when it is projected onto the surface is blocked) and section 4 (pairs
// of layers, additional cameras), after Lischinski, Rappoport. Image-based rendering for non-diffuse synthetic scenes.
// 1998. How several cameras are combined is not published: here a point that lies in front of the surface in any view
// that contains it is free.
#include "core/frame/reconstruct.glsl"
#include "methods/common/hemisphere_estimator.glsl"
#include "layer_counts.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 5) uniform sampler2D layer_depth_texture[3]; // layers 2 to 4
layout(binding = 8) uniform sampler2D view_depth_texture[4];
uniform vec2 tangents;
uniform mat4 other_from_view[4]; // view space of the further cameras
uniform vec2 other_tangents[4];

// The surface that hides a point.
struct Blocker {
    bool is_there;
    int source;     // 0 to 3: depth layer, the nearest first; 4 to 7: further camera
    vec2 uv;        // where it is on its image
    vec3 position;  // view space of the viewer
    float distance; // metres from the receiver
    float behind;   // depth of the layer that ends the solid, infinite if not known
};

const Blocker kNothing = Blocker(false, 0, vec2(0.0), vec3(0.0), 0.0, 0.0);

float read_layer(int layer, vec2 uv) {
    return layer == 0 ? textureLod(eye_depth_texture, uv, 0.0).r : textureLod(layer_depth_texture[layer - 1], uv, 0.0).r;
}

// What an image of `kLayers` layers says. `is_seen`: the point lies on the image, in front of the camera; `thickness` ends
// a solid whose back is not known.
Blocker look_from_viewer(vec3 p, vec3 q, float bias, float thickness, out bool is_seen) {
    float inverse_depth = 1.0 / -q.z;
    vec2 uv = project_to_uv(q, inverse_depth, tangents);
    is_seen = is_comparable(q, uv, kIsClamped);
    if (kIsClamped) {
        vec2 half_pixel = 0.5 / vec2(textureSize(eye_depth_texture, 0));
        uv = clamp(uv, half_pixel, 1.0 - half_pixel);
    }
    Blocker blocker = kNothing;
    for (int j = 0; j < kLayers; j += 2) {
        float front = read_layer(j, uv);
        float back = j + 1 < kLayers ? read_layer(j + 1, uv) : 1.0 / 0.0;
        float end = isinf(back) ? front + thickness : back;
        if (is_seen && !blocker.is_there && is_hidden(front, inverse_depth, bias) && -q.z < end) {
            vec3 y = reconstruct_view_position(uv, front, tangents);
            blocker = Blocker(true, j, uv, y, distance(y, p), back);
        }
    }
    return blocker;
}

Blocker look_from_view(int view, vec3 p, vec3 q, float thickness, out bool is_seen) {
    vec3 other_q = (other_from_view[view] * vec4(q, 1.0)).xyz;
    float inverse_depth = 1.0 / -other_q.z;
    vec2 uv = project_to_uv(other_q, inverse_depth, other_tangents[view]);
    is_seen = is_comparable(other_q, uv, false);
    float front = textureLod(view_depth_texture[view], uv, 0.0).r;
    if (!is_seen || !is_hidden(front, inverse_depth, 0.0) || -other_q.z >= front + thickness) {
        return kNothing;
    }
    vec3 other_y = reconstruct_view_position(uv, front, other_tangents[view]);
    // Rotations: the transposed matrix leads back.
    mat3 turn = mat3(other_from_view[view]);
    vec3 y = (other_y - other_from_view[view][3].xyz) * turn;
    return Blocker(true, 4 + view, uv, y, distance(y, p), 1.0 / 0.0);
}

// The nearest blocker of q, seen from p, within `reach` metres; nothing if a camera sees the point free.
Blocker find_blocker(vec3 p, vec3 q, float bias, float thickness, float reach) {
    bool is_seen;
    Blocker nearest = look_from_viewer(p, q, bias, thickness, is_seen);
    bool is_free = is_seen && !nearest.is_there;
    nearest.is_there = nearest.is_there && nearest.distance <= reach;
    for (int view = 0; view < kViews; ++view) {
        Blocker other = look_from_view(view, p, q, thickness, is_seen);
        is_free = is_free || (is_seen && !other.is_there);
        if (other.is_there && other.distance <= reach && (!nearest.is_there || other.distance < nearest.distance)) {
            nearest = other;
        }
    }
    nearest.is_there = nearest.is_there && !is_free;
    return nearest;
}
