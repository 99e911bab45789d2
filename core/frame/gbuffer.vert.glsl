// Everything is relative to the current camera: matrices were composed in double on the CPU.
#include "vertex_streams.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 packed_normal; // octahedral
#ifdef HAS_COLORS
layout(location = 2) in vec3 color;
#endif
#ifdef HAS_TEXTURE
layout(location = 3) in vec2 coordinates;
#endif
#ifdef DEFORMS
layout(location = 4) in vec3 delta; // where the vertex was one frame ago, minus position
uniform mat3 previous_world_from_object;
#endif
// One instance: rows of matrices.
layout(location = 5) in vec4 view_from_object[3];
layout(location = 8) in vec4 motion_matrix[3]; // previous minus current object-to-world
layout(location = 11) in vec3 albedo;
layout(location = 12) in uint instance_id;

out vec3 view_normal;
invariant out float eye_depth; // layers compare it between programs
out vec3 motion;
out vec3 surface_albedo;
flat out uint surface_id;
#ifdef HAS_PLACED_LIGHT
out vec3 surface_position;
out vec4 tangent_plane; // unit normal, and the position's distance along it from the camera
#endif
#ifdef HAS_TEXTURE
out vec2 texture_coordinates;
#endif

uniform mat4 clip_from_view;
invariant gl_Position;

vec3 unpack_normal(vec2 square) {
    vec3 n = vec3(square, 1.0 - abs(square.x) - abs(square.y));
    float fold = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -fold : fold;
    n.y += n.y >= 0.0 ? -fold : fold;
    return n;
}

vec3 apply(vec4 rows[3], vec4 point) {
    return vec3(dot(rows[0], point), dot(rows[1], point), dot(rows[2], point));
}

void main() {
    vec3 view_position = apply(view_from_object, vec4(position, 1.0));
    // Normals go by the cofactors of the linear part: its inverse transpose up to a positive
    // factor where the transform does not mirror.
    vec3 a = view_from_object[0].xyz;
    vec3 b = view_from_object[1].xyz;
    vec3 c = view_from_object[2].xyz;
    vec3 n = unpack_normal(packed_normal);
    view_normal = vec3(dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)) *
                  (dot(a, cross(b, c)) < 0.0 ? -1.0 : 1.0);
    eye_depth = -view_position.z;
#ifdef HAS_PLACED_LIGHT
    surface_position = view_position;
    vec3 unit_normal = normalize(view_normal);
    tangent_plane = vec4(unit_normal, dot(unit_normal, view_position));
#endif
    motion = apply(motion_matrix, vec4(position, 1.0));
#ifdef DEFORMS
    motion += previous_world_from_object * delta;
#endif
    surface_albedo = albedo;
#ifdef HAS_COLORS
    surface_albedo *= color;
#endif
#ifdef HAS_TEXTURE
    texture_coordinates = coordinates;
#endif
    surface_id = instance_id;
    gl_Position = clip_from_view * vec4(view_position, 1.0);
}
