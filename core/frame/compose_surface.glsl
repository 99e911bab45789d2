// One surface point of the shaded picture.
uniform bool is_radiance;
uniform vec3 ambient;

vec3 shade(float eye_depth, vec3 albedo, vec3 direct, vec3 method_value) {
    vec3 indirect = is_radiance ? method_value : ambient * albedo * method_value.r;
    return isinf(eye_depth) ? ambient : direct + indirect;
}
