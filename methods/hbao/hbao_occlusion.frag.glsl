// This work is based on: Bavoil, Sainz, Dimitrov. Image-space horizon-based ambient occlusion. 2008: per direction the sum
// of W(d) (sin h - sin t) over rising horizons, W(d) = 1 - (d/r)^2. Elevations are told from the plane across the view
// ray, not from the image plane, and each sample's from the tangent below that very sample, so that a plane never rises
// above itself although samples lie at pixel centres beside the direction's line.
#include "parameters.glsl"
#include "methods/common/estimator.glsl"
#include "methods/common/kernel_rotation.glsl"

const float kTwoPi = 6.2831853;

// Sine of the elevation of `offset` towards the viewer.
float compute_elevation_sine(vec3 offset, vec3 to_viewer) {
    return dot(offset, to_viewer) * inversesqrt(max(dot(offset, offset), 1e-20));
}

// Where a place's view ray leaves the tangent plane.
vec3 compute_tangent(Receiver receiver, vec3 ray) {
    float facing = dot(receiver.normal, ray);
    float plane = dot(receiver.normal, receiver.position);
    // A plane that the ray does not meet from the front rises towards the viewer; so does that of a shading normal turned
    // away from him, which interpolation leaves at silhouettes.
    return facing < 0.0 && plane < 0.0 ? ray * (plane / facing) - receiver.position : -receiver.position;
}

// Sine of the elevation that a horizon must rise above: the tangent's plus the bias.
float compute_least_sine(vec3 tangent, vec3 to_viewer, float sin_bias, float cos_bias) {
    float sine = compute_elevation_sine(tangent, to_viewer);
    float cosine = sqrt(max(1.0 - sine * sine, 0.0));
    bool is_past_zenith = cosine * cos_bias < sine * sin_bias;
    return is_past_zenith ? 1.0 : sine * cos_bias + cosine * sin_bias;
}

float march(Receiver receiver, vec2 step_uv, float offset, float sin_bias, float cos_bias) {
    vec2 uv = (vec2(receiver.pixel) + 0.5) * receiver.pixel_size;
    vec3 to_viewer = -normalize(receiver.position);
    float horizon = 0.0; // highest rise so far, as a difference of sines
    float sum = 0.0;
    for (int i = 0; i < param_steps; ++i) {
        vec2 tap = uv + (float(i) + offset) * step_uv;
        Place place = find_place(tap, receiver.pixel_size, param_border == param_border_clamp);
        float surface = textureLod(eye_depth_texture, place.uv, 0.0).r;
        vec3 ray = reconstruct_view_position(place.uv, 1.0, tangents);
        vec3 to_hit = surface * ray - receiver.position;
        float distance = dot(to_hit, to_hit) / (param_radius * param_radius);
        if (!place.counts || !(distance < 1.0) || distance <= 0.0) {
            continue;
        }
        vec3 tangent = compute_tangent(receiver, ray);
        float rise = compute_elevation_sine(to_hit, to_viewer) -
                     compute_least_sine(tangent, to_viewer, sin_bias, cos_bias);
        if (rise > horizon) {
            sum += (param_attenuation ? 1.0 - distance : 1.0) * (rise - horizon);
            horizon = rise;
        }
    }
    return sum;
}

void main() {
    Receiver receiver = read_receiver(ivec2(gl_FragCoord.xy));
    if (isinf(receiver.depth)) {
        visibility = 1.0;
        return;
    }
    vec2 radius_uv = 0.5 * param_radius / (receiver.depth * tangents);
    vec2 step_uv = radius_uv / float(param_steps);
    float sin_bias = sin(radians(param_angle_bias));
    float cos_bias = cos(radians(param_angle_bias));
    float turn = compute_turn(receiver.pixel, noise_seed) / kTwoPi;
    // Steps start anywhere in the first one, by the same number taken elsewhere.
    float offset = param_rotation == param_rotation_off ? 1.0 : fract(turn * 5.0 + 0.5) * 0.9375 + 0.0625;
    float sum = 0.0;
    for (int i = 0; i < param_directions; ++i) {
        float angle = kTwoPi * (float(i) + turn) / float(param_directions);
        sum += march(receiver, step_uv * vec2(cos(angle), sin(angle)), offset, sin_bias, cos_bias);
    }
    visibility = clamp(1.0 - param_strength * (sum / float(param_directions)), 0.0, 1.0);
}
