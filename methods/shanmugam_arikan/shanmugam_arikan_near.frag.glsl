// The near part: every neighbour of a pixel within r_far is a sphere of about a pixel's size.
// This work is based on: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on GPUs. 2007, section 4,
// equation (4). When m of M pixels are used the sum is scaled by M / m (see README).
#include "parameters.glsl"
#include "core/frame/reconstruct.glsl"
#include "methods/common/noise.glsl"
#include "methods/shanmugam_arikan/shanmugam_arikan_sphere.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture[LAYERS];
layout(binding = 4) uniform sampler2D normal_texture[LAYERS];
layout(std140) uniform KernelBlock { vec4 kernel[param_samples]; };
uniform vec2 tangents;
uniform uint noise_seed;
layout(location = 0) out float occlusion; // share of the hemisphere, not clamped

struct Receiver {
    vec3 position;
    vec3 normal;
    vec2 pixel_size;
};

float take_neighbour(Receiver receiver, sampler2D depths, sampler2D normals, vec2 place) {
    vec2 uv = (floor(place) + 0.5) * receiver.pixel_size;
    float depth = textureLod(depths, uv, 0.0).r;
    vec3 q = reconstruct_view_position(uv, depth, tangents);
    vec3 off = q - receiver.position;
    float distance_squared = dot(off, off);
    bool is_inside = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    if (!is_inside || !(distance_squared < param_r_far * param_r_far) || distance_squared <= 0.0) {
        return 0.0;
    }
    float radius = depth * tangents.y * receiver.pixel_size.y; // half a pixel there
    vec3 center = off - param_push_back * radius * textureLod(normals, uv, 0.0).xyz;
    return compute_sphere_occlusion(center, radius, receiver.normal);
}

float take_layers(Receiver receiver, vec2 place) {
    float sum = take_neighbour(receiver, eye_depth_texture[0], normal_texture[0], place);
#if LAYERS > 1
    sum += take_neighbour(receiver, eye_depth_texture[1], normal_texture[1], place);
#endif
#if LAYERS > 2
    sum += take_neighbour(receiver, eye_depth_texture[2], normal_texture[2], place);
#endif
#if LAYERS > 3
    sum += take_neighbour(receiver, eye_depth_texture[3], normal_texture[3], place);
#endif
    return sum;
}

// As many points as the disc has pixels, at most param_samples.
float sum_random(Receiver receiver, ivec2 pixel, float reach_px) {
    float pixels = 3.1415927 * reach_px * reach_px;
    int count = clamp(int(pixels), 1, param_samples);
    float angle = param_rotation ? 6.2831853 * compute_pixel_noise(pixel, noise_seed) : 0.0;
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += take_layers(receiver, vec2(pixel) + 0.5 + reach_px * (turn * kernel[i].xy));
    }
    return sum * pixels / float(count);
}

// As many points from each doubling of the distance: a sphere's solid angle falls with its square, so that points weigh
// alike. Nearer than kNearest pixels there is only the receiver itself.
float sum_logarithmic(Receiver receiver, ivec2 pixel, float reach_px) {
    const float kNearest = 0.6;
    float doublings = log2(max(reach_px / kNearest, 1.0001));
    int count = clamp(int(3.1415927 * reach_px * reach_px), 1, param_samples);
    float angle = param_rotation ? 6.2831853 * compute_pixel_noise(pixel, noise_seed) : 0.0;
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        vec2 point = kernel[i].xy;
        float share = dot(point, point); // uniform in [0, 1)
        float off = kNearest * exp2(share * doublings);
        vec2 place = vec2(pixel) + 0.5 + off * (turn * (point * inversesqrt(share)));
        sum += off * off * take_layers(receiver, place);
    }
    // The density of points is 1 / (2 pi off^2 ln(reach / nearest)) a pixel.
    return sum * 6.2831853 * 0.69314718 * doublings / float(count);
}

// Every k-th pixel of the square, k the least that keeps to param_samples.
float sum_square(Receiver receiver, ivec2 pixel, float reach_px) {
    int most = max(int(sqrt(float(param_samples))), 1);
    int across = min(2 * int(ceil(reach_px)) + 1, most | 1);
    float step_px = across > 1 ? max(2.0 * reach_px / float(across - 1), 1.0) : 1.0;
    float sum = 0.0;
    for (int y = 0; y < across; ++y) {
        for (int x = 0; x < across; ++x) {
            vec2 off = floor((vec2(x, y) - 0.5 * float(across - 1)) * step_px + 0.5);
            sum += take_layers(receiver, vec2(pixel) + 0.5 + off);
        }
    }
    return sum * step_px * step_px;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Receiver receiver;
    receiver.pixel_size = 1.0 / vec2(textureSize(eye_depth_texture[0], 0));
    float depth = texelFetch(eye_depth_texture[0], pixel, 0).r;
    if (isinf(depth)) {
        occlusion = 0.0;
        return;
    }
    receiver.position = reconstruct_view_position(gl_FragCoord.xy * receiver.pixel_size, depth, tangents);
    receiver.normal = normalize(texelFetch(normal_texture[0], pixel, 0).xyz);
    float reach_px = 0.5 * param_r_far / (receiver.pixel_size.y * depth * tangents.y);
    float sum;
    if (param_pattern == param_pattern_logarithmic) {
        sum = sum_logarithmic(receiver, pixel, reach_px);
    } else if (param_pattern == param_pattern_random) {
        sum = sum_random(receiver, pixel, reach_px);
    } else {
        sum = sum_square(receiver, pixel, reach_px);
    }
    occlusion = normalise_occlusion(sum);
}
