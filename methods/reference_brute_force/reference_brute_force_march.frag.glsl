// Rays in the hemisphere, marched over the screen against one depth layer.
// This work is based on: McGuire, Mara. Efficient GPU screen-space ray tracing. 2014 (steps of whole pixels, depth
// interpolated in inverse depth, and the depth interval of a step held against surface and thickness). Directions:
// Hammersley points, turned on the torus a pixel (Cranley, Patterson. Randomization of number theoretic methods for
// multiple integration. 1976).
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
#include "methods/common/hemisphere_estimator.glsl"
#include "methods/common/noise.glsl"
#include "methods/common/tangent_frame.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D normal_texture;
layout(binding = 2) uniform sampler2D visibility_texture;
uniform vec2 tangents;
uniform uint noise_seed;
uniform uint first_ray;
uniform uint end_ray;
layout(location = 0) out float visibility;

const float kTwoPi = 6.2831853;
const int kMostSteps = 8192;

float compute_weight(float relative_distance) {
    float d = min(relative_distance, 1.0);
    return param_falloff == param_falloff_none     ? 1.0
           : param_falloff == param_falloff_linear ? 1.0 - d
                                                   : 1.0 - d * d;
}

// z along the normal.
vec3 make_direction(uint ray, vec2 turn) {
    vec2 u = fract(vec2((float(ray) + 0.5) / float(param_rays), float(bitfieldReverse(ray)) * (1.0 / 4294967296.0)) + turn);
    float z = param_weighting == param_weighting_cosine ? sqrt(1.0 - u.x) : 1.0 - u.x;
    float across = sqrt(max(1.0 - z * z, 0.0));
    return vec3(across * cos(kTwoPi * u.y), across * sin(kTwoPi * u.y), z);
}

// Weight of the first hit along the ray from p, 0 if it is open.
float march(vec3 p, vec3 direction, float bias, vec2 size) {
    float reach = param_radius;
    if (direction.z > 0.0) {
        // Towards the viewer: not past the camera's plane.
        reach = min(reach, 0.999 * -p.z / direction.z);
    }
    vec3 end = p + reach * direction;
    float inverse_begin = 1.0 / -p.z;
    float inverse_end = 1.0 / -end.z;
    vec2 uv_begin = project_to_uv(p, inverse_begin, tangents);
    vec2 uv_end = project_to_uv(end, inverse_end, tangents);
    vec2 pixels = abs(uv_end - uv_begin) * size;
    int steps = clamp(int(ceil(max(pixels.x, pixels.y) / param_step)), param_least_steps, kMostSteps);
    float thickness = param_thickness * param_radius;
    float before = -p.z;
    for (int i = 0; i < steps; ++i) {
        float s = (float(i) + 0.5) / float(steps);
        vec2 uv = mix(uv_begin, uv_end, s);
        if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(1.0)))) {
            return 0.0;
        }
        float inverse_depth = mix(inverse_begin, inverse_end, s);
        float depth = 1.0 / inverse_depth;
        float surface = textureLod(eye_depth_texture, uv, 0.0).r;
        // Hidden, and some part of the step not yet behind the back of what hides it.
        if (is_hidden(surface, inverse_depth, bias) && min(before, depth) - surface <= thickness) {
            vec3 q = reconstruct_view_position(uv, depth, tangents);
            return compute_weight(length(q - p) / param_radius);
        }
        before = depth;
    }
    return 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 size = vec2(textureSize(eye_depth_texture, 0));
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    if (isinf(depth)) {
        visibility = 1.0;
        return;
    }
    vec3 p = reconstruct_view_position(gl_FragCoord.xy / size, depth, tangents);
    vec3 n = normalize(texelFetch(normal_texture, pixel, 0).xyz);
    vec3 t;
    vec3 b;
    compute_tangent_frame(n, t, b);
    float bias = compute_footprint_bias(p, n, 2.0 * tangents / size, param_bias);
    vec2 turn = vec2(compute_pixel_noise(pixel, noise_seed), compute_pixel_noise(pixel, noise_seed + 0x9e3779b9u));
    float blocked = 0.0;
    for (uint ray = first_ray; ray < end_ray; ++ray) {
        vec3 local = make_direction(ray, turn);
        blocked += march(p, local.x * t + local.y * b + local.z * n, bias, size);
    }
    float earlier = first_ray == 0u ? 1.0 : texelFetch(visibility_texture, pixel, 0).r;
    visibility = clamp(earlier - blocked / float(param_rays), 0.0, 1.0);
}
