// Where a surface point was one frame ago (core/frame/reprojection.hpp).
#include "core/frame/reconstruct.glsl"
uniform mat3 previous_from_view;
uniform vec3 previous_offset;
uniform mat3 previous_from_world;
uniform vec2 previous_tangents;

// position: view space now; motion: p_old - p_new in world axes. Returns view space one frame ago.
vec3 reproject_position(vec3 position, vec3 motion) {
    return previous_from_view * position + previous_offset + previous_from_world * motion;
}
