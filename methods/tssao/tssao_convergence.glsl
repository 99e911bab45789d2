// Convergence of a pixel from its count (section 3.3): min(n_t, n_max) / n_max. Without a cap it is held against the
// largest one published, so that the filter and the many samples still come to an end.
float compute_convergence(float count) {
    return min(count / min(param_history_cap, LARGEST_PUBLISHED_CAP), 1.0);
}
