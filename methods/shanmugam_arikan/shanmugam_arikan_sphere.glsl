// The occlusion of one sphere, equations (2) and (3), in steradians.
// This work is based on: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on GPUs. 2007. The cap is
// 2 pi t^2 / (1 + sqrt(1 - t^2)), t = radius / distance, which keeps its digits where 1 - cos(asin t) has none.

float compute_sphere_occlusion(vec3 to_center, float radius, vec3 n) {
    float distance_squared = max(dot(to_center, to_center), 1e-20);
    float inverse_distance = inversesqrt(distance_squared);
    float t = min(radius * inverse_distance, 1.0);
    float cap = 6.2831853 * t * t / (1.0 + sqrt(max(1.0 - t * t, 0.0)));
    return cap * max(dot(n, to_center) * inverse_distance, 0.0);
}

// A sum in steradians as a share of the hemisphere, by the parameter `norm`.
float normalise_occlusion(float steradians) {
    const float kNorm = param_norm == param_norm_one ? 1.0 : (param_norm == param_norm_pi ? 0.31830989 : 0.15915494);
    return kNorm * steradians;
}
