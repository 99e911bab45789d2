// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010, equations (9) and (10): a filter that weights by convergence and fades out with it, one direction at a
// time. It draws only where the depth test finds a pixel unconverged, into textures for shading alone.
#include "variant.glsl"
#include "parameters.glsl"
#include "methods/tssao/tssao_convergence.glsl"
#include "core/frame/reconstruct.glsl"
layout(binding = 0) uniform sampler2D history_texture;
layout(binding = 1) uniform sampler2D first_texture; // occlusion after the first direction
uniform ivec2 direction;
uniform bool is_second;
uniform vec2 tangents;
uniform vec2 image; // pixels of the G-buffer
layout(location = 0) out float filtered;

const int kScale = param_resolution == param_resolution_half ? 2 : 1;

vec3 reconstruct_texel(ivec2 texel, float depth) {
    return reconstruct_view_position((vec2(texel * kScale) + 0.5) / image, depth, tangents);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(history_texture, 0) - 1;
    vec4 own = texelFetch(history_texture, texel, 0);
    vec3 p = reconstruct_texel(texel, own.a);
    float convergence = compute_convergence(own.g);
    // Equation (10). The outermost tap fades in, so that the support shrinks without steps.
    float support = float(param_filter_radius) * max(param_filter_off_conv - convergence, 0.0) / param_filter_off_conv;
    float inverse_sigma = 1.0 / (param_filter_sigma * param_radius);
    float sum = 0.0;
    float total = 0.0;
    for (int offset = -param_filter_radius; offset <= param_filter_radius; ++offset) {
        ivec2 tap = texel + offset * direction;
        bool inside = all(greaterThanEqual(tap, ivec2(0))) && all(lessThanEqual(tap, last));
        tap = clamp(tap, ivec2(0), last);
        vec4 other = texelFetch(history_texture, tap, 0);
        float other_convergence = compute_convergence(other.g);
        // Converged pixels were left out in the first direction.
        float occlusion = is_second && other_convergence < param_filter_off_conv ? texelFetch(first_texture, tap, 0).r : other.r;
        float distance_sigmas = length(reconstruct_texel(tap, other.a) - p) * inverse_sigma;
        float window = clamp(support - abs(float(offset)) + 1.0, 0.0, 1.0);
        float weight = window * exp(-0.5 * distance_sigmas * distance_sigmas) * other_convergence;
        // The background has no count; NaN compares false.
        if (inside && other.g > 0.0 && occlusion >= 0.0 && weight > 0.0) {
            sum += weight * occlusion;
            total += weight;
        }
    }
    float result = total > 0.0 ? sum / total : own.r;
    filtered = is_second ? clamp(1.0 - param_strength * result, 0.0, 1.0) : result;
}
