// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. 2010. Reprojects a pixel's history, tests it, takes new samples and merges them: equations (3) to (8).
#include "variant.glsl"
#include "parameters.glsl"
#include "methods/tssao/tssao_convergence.glsl"
#include "core/frame/reproject.glsl"
#include "methods/common/disc_estimator.glsl"
#include "methods/common/hemisphere_estimator.glsl"
#include "methods/common/noise.glsl"
#include "methods/common/tangent_frame.glsl"
layout(binding = 0) uniform sampler2D depth_texture;  // eye depth in r; motion and eye depth where packed
layout(binding = 1) uniform sampler2D normal_texture;
layout(binding = 2) uniform sampler2D motion_texture; // unused where packed
layout(binding = 3) uniform sampler2D history_texture;
layout(std140) uniform KernelBlock { vec4 kernel[KERNEL_LENGTH]; };
uniform vec2 tangents;
uniform mat3 view_from_world;
uniform uint noise_seed;
uniform bool history_valid;
uniform float post_projective_scale; // far near / (far - near)
// Occlusion AO_t, count n_t, index into the table (+ kBorderFlag), eye depth.
layout(location = 0) out vec4 history;
layout(location = 1) out float visibility;
#ifdef WRITE_HISTORY_STATE
layout(location = 2) out vec4 history_state;
#endif

const float kTwoPi = 6.2831853;
const bool kIsHemisphere = param_estimator == param_estimator_hemisphere;
const bool kIsPacked = IS_PACKED;
// Where no object moves there is no channel to read; where the camera stands still as well, every pixel's history is its own.
const bool kReadsMotion = READS_MOTION;
// Where nothing has moved equation (8) is 0 = 0 for every sample.
const bool kTestsNeighbourhood = param_use_history && param_invalidation != param_invalidation_none && OBJECTS_MAY_MOVE;
const int kScale = param_resolution == param_resolution_half ? 2 : 1;
const int kBorderFlag = 2 * KERNEL_LENGTH;
// Nearer to a texel than this it is the texel: what rounding leaves of a camera that stands still.
const float kSnapTexels = 1e-3;
// Farther off the tangent plane than this in front counts with test_near_plane (in r).
const float kNearPlane = -0.1;
struct Surface {
    vec3 motion;
    float depth;
};

Surface fetch_surface(vec2 uv, bool with_motion) {
    if (kIsPacked) {
        vec4 packed_texel = textureLod(depth_texture, uv, 0.0);
        return Surface(packed_texel.rgb, packed_texel.a);
    }
    vec3 motion = with_motion && kReadsMotion ? textureLod(motion_texture, uv, 0.0).rgb : vec3(0.0);
    return Surface(motion, textureLod(depth_texture, uv, 0.0).r);
}

struct Past {
    float occlusion;
    float count;
    int index;
    bool touches_border; // the old samples reached over the image's border
    int cause;
};

// Equation (7) and its predecessors: is the surface at `tap_depth` the one that is expected there?
bool is_same_surface(float expected_depth, float tap_depth, float plane_inverse_depth) {
    if (param_disocclusion == param_disocclusion_relative) {
        return abs(1.0 - expected_depth / tap_depth) < param_disocclusion_tolerance;
    }
    if (param_disocclusion == param_disocclusion_absolute) {
        return abs(expected_depth - tap_depth) < param_disocclusion_distance;
    }
    if (param_disocclusion == param_disocclusion_post_projective) {
        float difference = abs(1.0 / expected_depth - 1.0 / tap_depth);
        return post_projective_scale * difference < param_disocclusion_post_projective_step;
    }
    return abs(1.0 - plane_inverse_depth * tap_depth) < param_disocclusion_tolerance;
}

// Comparisons with NaN are false, so a history that holds one is dropped.
bool is_sound(vec4 old) {
    return old.r >= 0.0 && old.r < 1e6 && old.g > 0.0 && old.g < 1e9 && old.b >= 0.0 && old.b < float(2 * kBorderFlag);
}

// Manual bilinear fetch: each tap is tested, the weights of those that pass are renormalised. The index comes from the
// nearest valid tap alone: an interpolated one would bias the sequence.
Past fetch_past(vec3 old_position, vec3 old_normal) {
    Past past = Past(0.0, 0.0, 0, false, HISTORY_OFF_SCREEN);
    float inverse_depth = 1.0 / -old_position.z;
    vec2 uv = project_to_uv(old_position, inverse_depth, previous_tangents);
    vec2 image = vec2(textureSize(depth_texture, 0));
    bool on_screen = old_position.z < 0.0 && all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    if (!on_screen) {
        return past;
    }
    past.cause = HISTORY_DISOCCLUSION;
    ivec2 last = textureSize(history_texture, 0) - 1;
    vec2 place = (uv * image - 0.5) / float(kScale);
    ivec2 nearest = clamp(ivec2(floor(place + 0.5)), ivec2(0), last);
    vec2 off = place - vec2(nearest);
    off = mix(off, vec2(0.0), lessThan(abs(off), vec2(kSnapTexels)));
    ivec2 side = ivec2(sign(off));
    off = abs(off);
    float plane_scale = 1.0 / dot(old_normal, old_position);
    float total = 0.0;
    float unused = 1.0;
    for (int tap = 0; tap < 4 && unused > 0.0; ++tap) {
        ivec2 step = ivec2(tap & 1, tap >> 1);
        float weight = (step.x == 1 ? off.x : 1.0 - off.x) * (step.y == 1 ? off.y : 1.0 - off.y);
        ivec2 texel = nearest + step * side;
        bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThanEqual(texel, last));
        vec4 old = textureLod(history_texture, (vec2(texel) + 0.5) / vec2(last + 1), 0.0);
        vec2 tap_uv = (vec2(texel * kScale) + 0.5) / image;
        float plane_inverse_depth = dot(old_normal, reconstruct_view_position(tap_uv, 1.0, previous_tangents)) * plane_scale;
        if (inside && is_sound(old) && weight > 0.0 && is_same_surface(-old_position.z, old.a, plane_inverse_depth)) {
            if (total == 0.0) {
                int stored = int(old.b);
                past.touches_border = stored >= kBorderFlag;
                past.index = past.touches_border ? stored - kBorderFlag : stored;
            }
            past.occlusion += weight * old.r;
            past.count += weight * old.g;
            total += weight;
        }
        unused -= weight;
        unused = unused < 1e-6 ? 0.0 : unused;
    }
    if (total > 0.0) {
        past.occlusion /= total;
        past.count /= total;
        past.cause = HISTORY_KEPT;
    }
    return past;
}

// The pixel's own texel. Its depth is tested all the same: it is the surface's own unless the history is another's.
Past fetch_past_still(float depth) {
    Past past = Past(0.0, 0.0, 0, false, HISTORY_DISOCCLUSION);
    vec4 old = texelFetch(history_texture, ivec2(gl_FragCoord.xy), 0);
    if (is_sound(old) && old.a == depth) {
        int stored = int(old.b);
        past.touches_border = stored >= kBorderFlag;
        past.index = past.touches_border ? stored - kBorderFlag : stored;
        past.occlusion = old.r;
        past.count = old.g;
        past.cause = HISTORY_KEPT;
    }
    return past;
}

struct Receiver {
    vec3 position;
    vec3 normal;
    vec3 motion;
    vec3 tangent;
    vec3 bitangent;
    float bias;
};

struct Taken {
    float sum;        // of the contributions
    int count;
    float change;     // largest violation of equation (8), in tolerances
    bool over_border; // a sample fell outside the image
};

// Equation (8): how much the distance between receiver and surface point has changed.
float compute_change(vec3 to_hit, vec3 relative_motion, vec3 n, bool is_within) {
    float limit = param_test_near_plane ? kNearPlane * param_radius : 0.0;
    vec3 old_to_hit = to_hit + view_from_world * relative_motion;
    return is_within && dot(to_hit, n) > limit ? abs(length(to_hit) - length(old_to_hit)) : 0.0;
}

Taken take_samples(Receiver receiver, int start, int wanted, float tolerance) {
    Taken taken = Taken(0.0, 0, 0.0, false);
    vec2 half_pixel = 0.5 / vec2(textureSize(depth_texture, 0));
    float cut_distance = param_cut * param_radius;
    const bool is_clamped = param_border == param_border_clamp;
    for (; taken.count < wanted; ++taken.count) {
        vec4 s = kernel[(start + taken.count) & (KERNEL_LENGTH - 1)];
        vec3 offset = s.x * receiver.tangent + s.y * receiver.bitangent;
        if (kIsHemisphere) {
            offset = s.w * (offset + s.z * receiver.normal);
        }
        vec3 q = receiver.position + param_radius * offset;
        float inverse_depth = 1.0 / -q.z;
        vec2 uv = project_to_uv(q, inverse_depth, tangents);
        bool inside = is_comparable(q, uv, false);
        bool comparable = inside || (is_clamped && q.z < 0.0);
        if (is_clamped) {
            uv = clamp(uv, half_pixel, 1.0 - half_pixel);
        }
        if (!kIsHemisphere) {
            // The surface point that the depth was written for: elsewhere in the texel a tilted plane would lie off
            // itself. In the receiver's own texel this is the receiver to the last bit, at no distance and no elevation.
            vec2 size = vec2(textureSize(depth_texture, 0));
            uv = (floor(uv * size) + 0.5) / size;
        }
        Surface surface = fetch_surface(uv, kTestsNeighbourhood);
        vec3 to_hit = reconstruct_view_position(uv, surface.depth, tangents) - receiver.position;
        bool is_within = comparable && dot(to_hit, to_hit) <= cut_distance * cut_distance;
        float contribution;
        if (kIsHemisphere) {
            float weight = param_directions == param_directions_uniform ? 2.0 * s.z : 1.0;
            contribution = is_hidden(surface.depth, inverse_depth, receiver.bias) ? weight : 0.0;
        } else {
            contribution = compute_disc_contribution(to_hit, receiver.normal, cut_distance, param_grazing_cosine);
        }
        taken.sum += is_within ? contribution : 0.0;
        taken.over_border = taken.over_border || !inside;
        if (kTestsNeighbourhood) {
            float change = compute_change(to_hit, surface.motion - receiver.motion, receiver.normal, is_within);
            taken.change = max(taken.change, change / tolerance);
            if (param_top_up && taken.change > 1.0) {
                wanted = max(wanted, param_initial_samples);
            }
        }
    }
    return taken;
}

Receiver make_receiver(ivec2 pixel, vec2 uv, vec3 normal, Surface surface, bool rotates) {
    Receiver receiver;
    receiver.position = reconstruct_view_position(uv, surface.depth, tangents);
    receiver.normal = normal;
    receiver.motion = surface.motion;
    vec2 pixel_tangents = 2.0 * tangents / vec2(textureSize(depth_texture, 0));
    receiver.bias = compute_footprint_bias(receiver.position, receiver.normal, pixel_tangents, param_bias);
    vec3 t = vec3(1.0, 0.0, 0.0); // offsets of the disc lie in the image plane
    vec3 b = vec3(0.0, 1.0, 0.0);
    if (kIsHemisphere) {
        compute_tangent_frame(receiver.normal, t, b);
    }
    float angle = rotates ? kTwoPi * compute_pixel_noise(pixel, noise_seed) : 0.0;
    receiver.tangent = cos(angle) * t + sin(angle) * b;
    receiver.bitangent = cos(angle) * b - sin(angle) * t;
    return receiver;
}

// What is left of the history's count after the neighbourhood test.
float limit_count(float count, float change) {
    float kept = param_invalidation == param_invalidation_smooth ? min(count, param_smooth_samples) : 0.0;
    if (param_confidence == param_confidence_graded) {
        // The paper's future work: full confidence up to the tolerance, none from twice that on.
        return mix(kept, count, clamp(2.0 - change, 0.0, 1.0));
    }
    return change > 1.0 ? kept : count;
}

void write_background() {
    history = vec4(0.0, 0.0, 0.0, uintBitsToFloat(0x7F800000u));
    visibility = 1.0;
    gl_FragDepth = DEPTH_CONVERGED;
#ifdef WRITE_HISTORY_STATE
    history_state = vec4(0.0);
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) * kScale;
    vec2 uv = (vec2(pixel) + 0.5) / vec2(textureSize(depth_texture, 0));
    Surface surface = fetch_surface(uv, param_use_history);
    if (isinf(surface.depth)) {
        write_background();
        return;
    }
    vec3 position = reconstruct_view_position(uv, surface.depth, tangents);
    vec3 normal = normalize(textureLod(normal_texture, uv, 0.0).xyz);
    Past past = Past(0.0, 0.0, 0, false, HISTORY_NO_HISTORY);
    if (param_use_history && history_valid) {
        past = REPROJECTS ? fetch_past(reproject_position(position, surface.motion), previous_from_view * normal)
                          : fetch_past_still(surface.depth);
    }
    float convergence = compute_convergence(past.count);
    Receiver receiver = make_receiver(pixel, uv, normal, surface, convergence < param_rotation_off_conv);
    float footprint = 2.0 * tangents.y * surface.depth / float(textureSize(depth_texture, 0).y);
    float tolerance = max(param_neighbourhood_tolerance * param_radius, footprint);
    int wanted = convergence < param_sample_switch_conv ? param_initial_samples : param_converged_samples;
    Taken taken = take_samples(receiver, past.index, wanted, tolerance);

    float count = past.count;
    float cap = param_history_cap;
    if (past.cause == HISTORY_KEPT && kTestsNeighbourhood && taken.change > 1.0) {
        past.cause = HISTORY_NEIGHBOURHOOD;
        float limited = limit_count(count, taken.change);
        if (param_smooth_clamp == param_smooth_clamp_after && param_invalidation == param_invalidation_smooth) {
            cap = min(cap, limited);
        } else {
            count = limited;
        }
    }
    // Samples clamped at the border must not spread into the image (section 3.6.3): once the kernel lies inside, a
    // history that was taken over the border is dropped.
    if (param_guard > 0.0 && past.touches_border && !taken.over_border) {
        past.cause = HISTORY_OFF_SCREEN;
        count = 0.0;
    }
    float new_count = float(taken.count);
    float occlusion = (count * past.occlusion + taken.sum) / (count + new_count);
    float merged_count = min(count + new_count, cap);
    int index = (past.index + taken.count) & (KERNEL_LENGTH - 1);
    bool touches_border = taken.over_border || (past.touches_border && count > 0.0);
    history = vec4(occlusion, merged_count, float(touches_border ? index + kBorderFlag : index), surface.depth);
    visibility = clamp(1.0 - param_strength * occlusion, 0.0, 1.0);
    float merged_convergence = compute_convergence(merged_count);
    gl_FragDepth = merged_convergence < param_filter_off_conv ? DEPTH_UNCONVERGED : DEPTH_CONVERGED;
#ifdef WRITE_HISTORY_STATE
    history_state = vec4(merged_convergence, new_count, float(past.cause), 1.0);
#endif
}
