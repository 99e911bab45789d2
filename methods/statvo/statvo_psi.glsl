// From mean heights over the surface to visibility.
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical volumetric
// obscurance. 2015, the psi of equation (4) and equation (5).

// The share of a box that is filled, by the mean height of what is in it; beyond the box's top it falls with the slope
// that the user chooses.
float compute_psi(float t, float drop) {
    return t <= 1.0 ? max(t, 0.0) : max(0.0, 1.0 - drop * (t - 1.0));
}

// `occlusion`: psi times samples, `samples`: their number, over all layers; a component a region. A region without samples
// blocks nothing.
float compute_visibility(vec4 occlusion, vec4 samples, float strength, bool has_four_regions) {
    vec4 means = occlusion / max(samples, vec4(1e-6));
    float mean = has_four_regions ? dot(means, vec4(0.25)) : means.x;
    return clamp(1.0 - strength * mean, 0.0, 1.0);
}
