// A pixel's sample points and what blocks them, for shaders with the parameters radius and fade (their text is
// included before this file), get_bias() in half pixel footprints, and get_thickness() for solids whose back is not known.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// sections 3 and 7.2.
#include "methods/common/layered_surfaces.glsl"
#include "methods/common/sample_sets.glsl"
#include "methods/common/tangent_frame.glsl"
layout(binding = 1) uniform sampler2D normal_texture;
uniform uint noise_seed;

struct Receiver {
    ivec2 pixel;
    float depth; // infinite on the background: the rest is undefined then
    vec3 position;
    vec3 normal;
    vec3 tangent;
    vec3 bitangent;
    float bias;
    int first_sample;
};

Receiver read_receiver() {
    Receiver receiver;
    receiver.pixel = ivec2(gl_FragCoord.xy);
    receiver.depth = texelFetch(eye_depth_texture, receiver.pixel, 0).r;
    vec2 pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
    receiver.position = reconstruct_view_position(gl_FragCoord.xy * pixel_size, receiver.depth, tangents);
    receiver.normal = normalize(texelFetch(normal_texture, receiver.pixel, 0).xyz);
    compute_tangent_frame(receiver.normal, receiver.tangent, receiver.bitangent);
    receiver.bias =
        compute_footprint_bias(receiver.position, receiver.normal, 2.0 * tangents * pixel_size, get_bias());
    receiver.first_sample = find_sample_set(receiver.pixel, noise_seed);
    return receiver;
}

vec3 place_sample(Receiver receiver, vec4 s) {
    return receiver.position +
           param_radius * s.w * (s.x * receiver.tangent + s.y * receiver.bitangent + s.z * receiver.normal);
}

Blocker test_sample(Receiver receiver, vec4 s) {
    return find_blocker(receiver.position, place_sample(receiver, s), receiver.bias, get_thickness(), param_radius);
}

// 1 - V of a sample: fades towards the border of the hemisphere, so that a blocker that is partly inside leaves no crack.
float weigh_blocker(Blocker blocker) {
    float fade = 1.0 - smoothstep(param_fade * param_radius, param_radius, blocker.distance);
    return blocker.is_there ? fade : 0.0;
}
