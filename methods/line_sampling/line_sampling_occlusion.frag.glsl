// This work is based on: Loos, Sloan. Volumetric obscurance. 2010, section on line sampling. Lines are the view rays
// through pixel centres (see README), so that a plane fills nothing of the half ball above it at any tilt.
#include "parameters.glsl"
#include "methods/common/estimator.glsl"
#include "methods/common/kernel_rotation.glsl"
layout(std140) uniform KernelBlock { vec4 kernel[param_samples]; };

// The piece of a view ray that may be filled, and how much of it is: volumes per area of the disc, in metres.
struct Line {
    float possible;
    float filled;
    bool is_outlier; // the surface lies nearer than the ball
};

// Rays part with distance: a piece of eye depth from a to b stands for (b^3 - a^3) / (3 z^2) of volume per area at z.
float measure_piece(float a, float b, float z) {
    return (b - a) * (a * a + a * b + b * b) / (3.0 * z * z);
}

// The view ray is t * ray with eye depth t. Chord of the ball: t0 +- half. The offset from the ball's centre at t0 keeps
// its digits far from the camera, where the textbook form b^2 - a c loses them.
Line measure_line(Receiver receiver, vec2 uv) {
    Place place = find_place(uv, receiver.pixel_size, param_border == param_border_clamp);
    vec3 ray = reconstruct_view_position(place.uv, 1.0, tangents);
    float ray_squared = dot(ray, ray);
    float t0 = dot(ray, receiver.position) / ray_squared;
    vec3 off = t0 * ray - receiver.position;
    float half_chord = sqrt(max(param_radius * param_radius - dot(off, off), 0.0) / ray_squared);
    float near = t0 - half_chord;
    float far = t0 + half_chord;
    if (param_domain == param_domain_hemisphere) {
        float facing = dot(receiver.normal, ray);
        float plane = dot(receiver.normal, receiver.position);
        // Above the plane lies what is nearer than it; all of a ray that does not meet it from the front; nothing where a
        // shading normal is turned away from the viewer, which interpolation leaves at silhouettes.
        float limit = facing < 0.0 ? plane / facing : far;
        far = clamp(plane < 0.0 ? limit : near, near, far);
    }
    float surface = textureLod(eye_depth_texture, place.uv, 0.0).r;
    float possible = measure_piece(near, far, receiver.depth);
    float filled = measure_piece(clamp(surface, near, far), far, receiver.depth);
    return Line(possible, place.counts ? filled : 0.0, place.counts && surface < near);
}

void main() {
    Receiver receiver = read_receiver(ivec2(gl_FragCoord.xy));
    if (isinf(receiver.depth)) {
        visibility = 1.0;
        return;
    }
    vec3 t = vec3(1.0, 0.0, 0.0); // the disc lies in the image plane
    vec3 b = vec3(0.0, 1.0, 0.0);
    rotate_about_axis(t, b, compute_turn(receiver.pixel, noise_seed));
    float filled = 0.0;
    float possible = 0.0;
    Line previous = Line(0.0, 0.0, true);
    for (int i = 0; i < param_samples; ++i) {
        vec3 q = receiver.position + param_radius * (kernel[i].x * t + kernel[i].y * b);
        Line line = measure_line(receiver, project_to_uv(q, 1.0 / receiver.depth, tangents));
        if (param_outliers == param_outliers_solid || !line.is_outlier) {
            filled += line.filled;
            possible += line.possible;
        }
        if (param_outliers == param_outliers_paired && (i & 1) == 1 && line.is_outlier != previous.is_outlier) {
            // The one that is no outlier stands for both.
            filled += line.is_outlier ? previous.filled : line.filled;
            possible += line.is_outlier ? previous.possible : line.possible;
        }
        previous = line;
    }
    float obscurance = possible > 0.0 ? filled / possible : 0.0;
    visibility = clamp(1.0 - param_strength * obscurance, 0.0, 1.0);
}
