// One sample of the hemisphere estimator: a point in the oriented hemisphere, compared with the depth buffer.
// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010, equation (2), after Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space.
// 2009. The bias is ours.
// Rounding of a 32-bit sample depth against a 32-bit stored depth: 8 units in the last place.
const float kRoundingGuard = 1.0 + 8.0 / 16777216.0;

// On a plane 1/depth is linear in pixels, so a depth read at a pixel's centre instead of at the sample's own place is off
// by at most half of |d(1/z)/dx| + |d(1/z)/dy|: exact for planes at any tilt, in units of inverse metres.
float compute_footprint_bias(vec3 p, vec3 n, vec2 pixel_tangents, float bias) {
    return bias * 0.5 * dot(abs(n.xy), pixel_tangents) / abs(dot(n, p));
}

// True if a surface at eye depth `surface` hides a point at 1 / inverse_depth from the viewer.
bool is_hidden(float surface, float inverse_depth, float bias) {
    return surface * (inverse_depth * kRoundingGuard + bias) < 1.0;
}

// True if a sample's place may be compared: in front of the camera and, unless it is clamped, inside the image.
bool is_comparable(vec3 q, vec2 uv, bool is_clamped) {
    bool inside = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    return q.z < 0.0 && (is_clamped || inside);
}
