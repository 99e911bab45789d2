// One bounce of light from the surfaces that block samples.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// section 3: L_ind = sum over N of rho / pi L_pixel (1 - V) A_s cos theta_s cos theta_r / d^2 with A_s = pi r_max^2 / N.
// The albedo rho is multiplied on after the blur.
#include "parameters.glsl"
float get_bias() {
    return param_bias;
}
float get_thickness() {
    return param_thickness;
}
#include "methods/common/set_sampling.glsl"
layout(binding = 2) uniform sampler2D sent_texture;     // of the nearest layer, direct light and that of the surroundings
layout(binding = 3) uniform sampler2D incoming_texture; // of the direct pass
layout(binding = 12) uniform sampler2D layer_normal_texture[3];
layout(binding = 15) uniform sampler2D layer_sent_texture[3];
layout(binding = 18) uniform sampler2D view_normal_texture[4];
layout(binding = 22) uniform sampler2D view_sent_texture[4];
layout(location = 0) out vec4 incoming; // rgb: mean incoming radiance, direct and bounced; a: eye depth

struct Sender {
    vec3 position; // view space
    vec3 normal;   // to the side that sends
    vec3 radiance;
};

// A surface of a deeper layer sends from its outside, which for its back is the side away from the viewer.
vec3 turn_outward(vec4 normal) {
    return normal.a > 0.5 ? -normal.xyz : normal.xyz;
}

// Textures are chosen by loops over constants: a fragment's own index must not choose between them.
Sender read_layer_sender(int layer, vec2 uv, vec3 position) {
    Sender sender = Sender(position, textureLod(normal_texture, uv, 0.0).xyz, textureLod(sent_texture, uv, 0.0).rgb);
    for (int i = 1; i < kLayers; ++i) {
        if (i == layer) {
            sender.normal = turn_outward(textureLod(layer_normal_texture[i - 1], uv, 0.0));
            sender.radiance = textureLod(layer_sent_texture[i - 1], uv, 0.0).rgb;
        }
    }
    return sender;
}

Sender read_view_sender(int view, vec2 uv, vec3 position) {
    Sender sender = Sender(position, vec3(0.0), vec3(0.0));
    for (int i = 0; i < kViews; ++i) {
        if (i == view) {
            // Rotations: the transposed matrix leads back.
            sender.normal = textureLod(view_normal_texture[i], uv, 0.0).xyz * mat3(other_from_view[i]);
            sender.radiance = textureLod(view_sent_texture[i], uv, 0.0).rgb;
        }
    }
    return sender;
}

// cos theta_s cos theta_r / d^2, 0 for what faces away.
float compute_exchange(Receiver receiver, Sender sender) {
    vec3 to_sender = sender.position - receiver.position;
    float distance = length(to_sender);
    vec3 direction = to_sender / max(distance, 1e-12);
    float cosines = max(dot(receiver.normal, direction), 0.0) * max(-dot(sender.normal, direction), 0.0);
    float clamped = max(distance, param_distance_clamp);
    return cosines / (clamped * clamped);
}

vec3 bounce_from_viewer(Receiver receiver, Blocker blocker) {
    Sender front = read_layer_sender(blocker.source, blocker.uv, blocker.position);
    float best = compute_exchange(receiver, front);
    vec3 light = best * front.radiance;
    if (kLayers > 1 && !isinf(blocker.behind)) {
        // The other side of the solid: what faces the receiver more counts, once a sample.
        vec3 position = reconstruct_view_position(blocker.uv, blocker.behind, tangents);
        Sender back = read_layer_sender(blocker.source + 1, blocker.uv, position);
        float exchange = compute_exchange(receiver, back);
        light = exchange > best ? exchange * back.radiance : light;
    }
    return light;
}

void main() {
    Receiver receiver = read_receiver();
    vec4 direct = texelFetch(incoming_texture, receiver.pixel, 0);
    vec3 sum = vec3(0.0);
    if (!isinf(receiver.depth)) {
        for (int i = 0; i < kSamples; ++i) {
            Blocker blocker = test_sample(receiver, kernel[receiver.first_sample + i]);
            float weight = weigh_blocker(blocker);
            if (kViews > 0 && blocker.source >= 4) {
                Sender sender = read_view_sender(blocker.source - 4, blocker.uv, blocker.position);
                sum += weight * compute_exchange(receiver, sender) * sender.radiance;
            } else {
                sum += weight * bounce_from_viewer(receiver, blocker);
            }
        }
        // 1 / pi of the reflection and pi of the patch's area cancel.
        sum *= param_bounce_strength * param_radius * param_radius / float(kSamples);
    }
    incoming = vec4(direct.rgb + sum, receiver.depth);
}
