// Mean visibility of the samples times one lookup of the prefiltered surroundings.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009, table 1.
#include "parameters.glsl"
float get_bias() {
    return param_bias;
}
float get_thickness() {
    return 1.0 / 0.0;
}
#include "methods/common/set_sampling.glsl"
#include "core/frame/octahedral.glsl"
#include "direct_outputs.glsl"
layout(binding = 4) uniform sampler2D prefiltered_texture;
uniform mat3 map_from_view;
layout(location = 0) out vec4 incoming; // rgb: mean incoming radiance, a: eye depth

void main() {
    Receiver receiver = read_receiver();
    float sum = 0.0;
    vec3 light = vec3(1.0);
    if (!isinf(receiver.depth)) {
        for (int i = 0; i < kSamples; ++i) {
            vec4 s = kernel[receiver.first_sample + i];
            float open = 1.0 - weigh_blocker(test_sample(receiver, s));
            sum += param_weighting == param_weighting_cosine ? 2.0 * open * s.z : open;
        }
        if (!kGivesVisibility) {
            light = textureLod(prefiltered_texture, encode_octahedral(map_from_view * receiver.normal), 0.0).rgb;
        }
    }
    incoming = vec4(sum / float(kSamples) * light, receiver.depth);
}
