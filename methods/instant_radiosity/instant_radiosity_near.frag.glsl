// Bounce of near surfaces that the screen shows: all of it, or the part that the clamped form factor of virtual lights lacks.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// sections 3 and 5. The part is ours: 1 / d^2 - 1 / clamp^2 for d < clamp in place of 1 / d^2.
// The albedo is multiplied on after the blur.
#include "parameters.glsl"
float get_bias() {
    return param_screen_bias;
}
float get_thickness() {
    return param_thickness;
}
#include "methods/common/set_sampling.glsl"
layout(binding = 2) uniform sampler2D direct_light_texture;
layout(location = 0) out vec4 incoming; // rgb: mean incoming radiance; a: eye depth

float compute_exchange(Receiver receiver, vec3 position, vec3 normal) {
    vec3 to_sender = position - receiver.position;
    float distance = length(to_sender);
    vec3 direction = to_sender / max(distance, 1e-12);
    float cosines = max(dot(receiver.normal, direction), 0.0) * max(-dot(normal, direction), 0.0);
    float least = max(distance, param_near_clamp);
    float strength = 1.0 / (least * least);
    if (param_near_bounce == param_near_bounce_clamped_part) {
        strength = max(strength - 1.0 / (param_clamp * param_clamp), 0.0);
    }
    return cosines * strength;
}

void main() {
    Receiver receiver = read_receiver();
    vec3 sum = vec3(0.0);
    if (!isinf(receiver.depth)) {
        for (int i = 0; i < kSamples; ++i) {
            Blocker blocker = test_sample(receiver, kernel[receiver.first_sample + i]);
            // Behind the first layer the light of surfaces is not known.
            if (blocker.is_there && blocker.source == 0) {
                vec3 normal = textureLod(normal_texture, blocker.uv, 0.0).xyz;
                vec3 sent = textureLod(direct_light_texture, blocker.uv, 0.0).rgb;
                sum += weigh_blocker(blocker) * compute_exchange(receiver, blocker.position, normal) * sent;
            }
        }
        // 1 / pi of the reflection and pi of the patch's area cancel.
        sum *= param_near_strength * param_radius * param_radius / float(kSamples);
    }
    incoming = vec4(sum, receiver.depth);
}
