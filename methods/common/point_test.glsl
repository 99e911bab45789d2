// A point of a kernel against the depth buffer, for shaders over estimator.glsl.
#include "methods/common/hemisphere_estimator.glsl"

// 1 if the surface hides q from the viewer and lies within the cut distance of the receiver.
float test_point(Receiver receiver, vec3 q, float bias, float cut_squared, bool is_clamped) {
    float inverse_depth = 1.0 / -q.z;
    vec2 uv = project_to_uv(q, inverse_depth, tangents);
    bool comparable = is_comparable(q, uv, is_clamped);
    if (is_clamped) {
        uv = clamp(uv, 0.5 * receiver.pixel_size, 1.0 - 0.5 * receiver.pixel_size);
    }
    float surface = textureLod(eye_depth_texture, uv, 0.0).r;
    vec3 to_hit = reconstruct_view_position(uv, surface, tangents) - receiver.position;
    bool hidden = is_hidden(surface, inverse_depth, bias);
    return comparable && hidden && dot(to_hit, to_hit) <= cut_squared ? 1.0 : 0.0;
}
