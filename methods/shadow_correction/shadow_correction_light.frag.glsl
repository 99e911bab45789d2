// Irradiance of one light: by its shadow maps, and by the screen where they call a point lit.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// section 5: for a point that is not in shadow, samples on the segment P .. P + b l towards the light; if anything blocks
// one of them the point is in shadow. Section 4 takes the segment P .. P + r_max l, without maps.
#include "parameters.glsl"
#include "methods/common/segment_test.glsl"
#include "methods/common/shadow_map.glsl"
#include "light_outputs.glsl"
layout(binding = 1) uniform sampler2D normal_texture;
uniform vec4 light_place; // view space; w = 0: unit direction to the light; w = 1: position
uniform vec3 light_color; // irradiance that faces it, or intensity at 1 m
uniform vec4 light_axis;  // of a spot's cone, away from the light; w: cosine of the outer angle, -2 without cone
uniform float light_inner_cosine;
uniform bool casts_shadow;
layout(location = 0) out vec4 arriving;
#ifdef GIVES_OPEN
layout(location = 1) out vec4 open; // the same if nothing blocks
#endif

bool is_shadowed(vec3 p, float cosine, vec3 direction, float to_light_m, float screen_bias) {
    MapPlace at = find_on_map(p);
    float bias = compute_map_bias(param_bias, at.texel_m, cosine, param_bias_scale, param_radius);
    if (param_maps && is_in_map_shadow(at, bias)) {
        return true;
    }
    float length_m = min(param_segment == param_segment_bias ? bias : param_radius, to_light_m);
    return param_correction && length_m > 0.0 &&
           is_segment_blocked(p, direction * length_m, param_correction_samples, screen_bias, param_thickness, param_radius);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(eye_depth_texture, pixel, 0).r;
    vec3 irradiance = vec3(0.0);
    bool is_open = true;
    if (!isinf(depth)) {
        vec2 pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
        vec3 p = reconstruct_view_position(gl_FragCoord.xy * pixel_size, depth, tangents);
        vec3 n = normalize(texelFetch(normal_texture, pixel, 0).xyz);
        vec3 to_light = light_place.xyz - light_place.w * p;
        float squared = light_place.w > 0.5 ? max(dot(to_light, to_light), 1e-12) : 1.0;
        vec3 direction = light_place.w > 0.5 ? to_light * inversesqrt(squared) : to_light;
        float cosine = max(dot(n, direction), 0.0);
        float factor = cosine / squared;
        if (light_axis.w > -1.5) {
            float inside = (-dot(direction, light_axis.xyz) - light_axis.w) / (light_inner_cosine - light_axis.w);
            inside = clamp(inside, 0.0, 1.0);
            factor *= inside * inside;
        }
        irradiance = light_color * factor;
        if (casts_shadow && factor > 0.0) {
            float bias = compute_footprint_bias(p, n, 2.0 * tangents * pixel_size, param_screen_bias);
            float to_light_m = light_place.w > 0.5 ? sqrt(squared) : 1.0 / 0.0;
            is_open = !is_shadowed(p, cosine, direction, to_light_m, bias);
        }
    }
    arriving = vec4(is_open ? irradiance : vec3(0.0), 0.0);
#ifdef GIVES_OPEN
    open = vec4(irradiance, 0.0);
#endif
}
