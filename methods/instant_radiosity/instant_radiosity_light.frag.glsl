// Irradiance of one virtual light: clamped form factor, shadow map, and the screen where the map calls a point lit.
// This work is based on: Keller. Instant radiosity. 1997; Ritschel, Grosch, Seidel. Approximating dynamic global
// illumination in image space. 2009, section 5: E = I cos theta_s cos theta_r / max(d, clamp)^2.
#include "parameters.glsl"
#include "methods/common/segment_test.glsl"
#include "methods/common/shadow_map.glsl"
#include "light_outputs.glsl"
layout(binding = 1) uniform sampler2D normal_texture;
uniform vec3 light_position;  // view space
uniform vec3 light_normal;    // view space
uniform vec3 light_intensity; // along its normal
layout(location = 0) out vec4 arriving;
#ifdef GIVES_OPEN
layout(location = 1) out vec4 open; // the same if nothing blocks
#endif

// The segment ends before the light, which is a point of a surface that would block its last sample.
const float kMostOfTheWay = 0.75;
// Of places in one plane rounding decides on which side each lies: positions in 32 bits that are told from metres away are
// a few micrometres off, which is this much of some millimetres. What lies lower sends nothing: of the light it could
// bring less than a thousandth is lost, where a visibility of such light alone would be one of nothing.
const float kLeastCosine = 1e-3;

bool is_shadowed(vec3 p, float cosine, vec3 direction, float to_light_m, float screen_bias) {
    MapPlace at = find_on_map(p);
    float bias = compute_map_bias(param_bias, at.texel_m, cosine, param_bias_scale, param_radius);
    if (is_in_map_shadow(at, bias)) {
        return true;
    }
    // Beyond the map's angle of view there is the screen alone.
    float length_m = min(at.is_seen ? bias : param_radius, kMostOfTheWay * to_light_m);
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
        vec3 to_light = light_position - p;
        float to_light_m = max(length(to_light), 1e-6);
        vec3 direction = to_light / to_light_m;
        float cosine = dot(n, direction);
        float sent = -dot(light_normal, direction);
        if (min(cosine, sent) > kLeastCosine) {
            float least_m = max(to_light_m, param_clamp);
            irradiance = light_intensity * (cosine * sent / (least_m * least_m));
            float bias = compute_footprint_bias(p, n, 2.0 * tangents * pixel_size, param_screen_bias);
            is_open = !is_shadowed(p, cosine, direction, to_light_m, bias);
        }
    }
    arriving = vec4(is_open ? irradiance : vec3(0.0), 0.0);
#ifdef GIVES_OPEN
    open = vec4(irradiance, 0.0);
#endif
}
