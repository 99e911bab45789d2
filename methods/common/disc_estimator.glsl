// One sample of the Fox and Compton estimator: the surface point at an offset on the screen, weighted by its elevation.
// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010, after Fox, Compton. Ambient occlusive crease shading. 2008: C = max(0, cos) D(distance), without a
// visibility test, cosines under a limit rejected. The paper leaves D open; ours falls linearly to 0 at the cut distance,
// so that no surface jumps in or out. The factor 2 is that of uniform directions (requirements of equation (2)).

// to_hit: from the receiver to the surface point. Returns the contribution, 0 where the point is rejected.
float compute_disc_contribution(vec3 to_hit, vec3 n, float cut_distance, float grazing_cosine) {
    float distance_squared = max(dot(to_hit, to_hit), 1e-20);
    float inverse_distance = inversesqrt(distance_squared);
    float cosine = dot(to_hit, n) * inverse_distance;
    float falloff = 1.0 - distance_squared * inverse_distance / cut_distance;
    return cosine >= grazing_cosine && falloff > 0.0 ? 2.0 * cosine * falloff : 0.0;
}
