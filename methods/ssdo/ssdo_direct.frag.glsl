// Direct light of the surroundings from the directions that nearby surfaces leave free.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// section 3: L_dir = sum over N of rho / pi L_in V cos theta 2 pi / N. The albedo rho is multiplied on after the blur.
#include "parameters.glsl"
float get_bias() {
    return param_bias;
}
float get_thickness() {
    return param_thickness;
}
#include "methods/common/set_sampling.glsl"
#include "core/frame/octahedral.glsl"
#include "direct_outputs.glsl"
layout(binding = 4) uniform sampler2D surroundings_texture;
uniform mat3 map_from_view;
layout(location = 0) out vec4 incoming; // rgb: mean incoming radiance, a: eye depth
#ifdef SENDS
layout(binding = 2) uniform sampler2D albedo_texture;
layout(binding = 3) uniform sampler2D direct_light_texture;
layout(location = 1) out vec4 sent; // what the pixel sends to others: radiance
#endif

void main() {
    Receiver receiver = read_receiver();
    vec3 sum = vec3(0.0);
    if (!isinf(receiver.depth)) {
        mat3 map_from_tangents = map_from_view * mat3(receiver.tangent, receiver.bitangent, receiver.normal);
        for (int i = 0; i < kSamples; ++i) {
            vec4 s = kernel[receiver.first_sample + i];
            float open = 1.0 - weigh_blocker(test_sample(receiver, s));
            vec3 light = vec3(1.0);
            if (!kGivesVisibility) {
                light = textureLod(surroundings_texture, encode_octahedral(map_from_tangents * s.xyz), 0.0).rgb;
            }
            sum += light * (open * s.z);
        }
        sum *= 2.0 / float(kSamples);
    }
    incoming = vec4(sum, receiver.depth);
#ifdef SENDS
    sent = vec4(texelFetch(direct_light_texture, receiver.pixel, 0).rgb +
                    sum * texelFetch(albedo_texture, receiver.pixel, 0).rgb,
                1.0);
#endif
}
