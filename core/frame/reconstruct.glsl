// View-space positions from eye depth. tangents = tan of half the horizontal and vertical angle of view.

// uv in [0,1], (0,0) bottom left. The view axis is -z.
vec3 reconstruct_view_position(vec2 uv, float eye_depth, vec2 tangents) {
    return vec3((2.0 * uv - 1.0) * tangents * eye_depth, -eye_depth);
}

// The inverse, for a position in front of the camera; inverse_depth = 1 / -position.z
vec2 project_to_uv(vec3 position, float inverse_depth, vec2 tangents) {
    return 0.5 + 0.5 * position.xy * inverse_depth / tangents;
}
