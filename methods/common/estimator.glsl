// What the occlusion pass of an estimator reads and writes (EstimatorMethod). The shader that includes this defines main().
#include "core/frame/reconstruct.glsl"
#include "estimator_resolution.glsl"
#include "methods/common/half_resolution.glsl"
#include "methods/common/noise.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D normal_texture;
layout(binding = 2) uniform sampler2D selection_texture; // at half resolution only
uniform vec2 tangents;
uniform uint noise_seed;
layout(location = 0) out float visibility;

// The surface point that a fragment stands for.
struct Receiver {
    ivec2 pixel;     // of the full-resolution image
    float depth;     // infinite on the background: the rest is undefined then
    vec3 position;   // view space
    vec3 normal;     // unit
    vec2 pixel_size; // in texture coordinates
};

Receiver read_receiver(ivec2 fragment) {
    Receiver receiver;
    receiver.pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
    if (kIsHalfResolution) {
        HalfPixel selected = read_half_pixel(selection_texture, fragment);
        receiver.pixel = selected.pixel;
        receiver.depth = selected.depth;
    } else {
        receiver.pixel = fragment;
        receiver.depth = texelFetch(eye_depth_texture, fragment, 0).r;
    }
    vec2 uv = (vec2(receiver.pixel) + 0.5) * receiver.pixel_size;
    receiver.position = reconstruct_view_position(uv, receiver.depth, tangents);
    receiver.normal = normalize(texelFetch(normal_texture, receiver.pixel, 0).xyz);
    return receiver;
}

// A kernel's place on the image.
struct Place {
    vec2 uv;     // centre of the pixel: what its depth was written for
    bool counts; // inside the image, or clamped to it
};

Place find_place(vec2 uv, vec2 pixel_size, bool is_clamped) {
    vec2 centre = (floor(uv / pixel_size) + 0.5) * pixel_size;
    bool is_inside = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    vec2 clamped = clamp(centre, 0.5 * pixel_size, 1.0 - 0.5 * pixel_size);
    return Place(is_clamped ? clamped : centre, is_inside || is_clamped);
}
