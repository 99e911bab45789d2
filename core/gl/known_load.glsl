// A chaotic map that no compiler can fold: its cost is proportional to the number of iterations.
float run_known_load(int iterations, float seed) {
    float x = seed;
    for (int i = 0; i < iterations; ++i) {
        x = fract(x * 1.7320508 + 0.31830989);
    }
    return x;
}
