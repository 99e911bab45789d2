// Where the samples of a texel lie: unit directions in view space and lengths in radii.
// This work is based on: "Know your SSAO artifacts", 2013: reflection, Gram-Schmidt, and direction and length indexed apart.
#include "methods/common/tangent_frame.glsl"

const bool kIsWholeSphere = param_kernel == param_kernel_sphere;
const bool kIsSphere = kIsWholeSphere || param_kernel == param_kernel_sphere_reflected;
const bool kIsConstant = param_indexing == param_indexing_constant;
const int kPairs = (param_samples + 1) / 2;
const int kPoints = kIsConstant ? (kIsWholeSphere ? kPairs : param_samples) : param_kernel_size;
layout(std140) uniform KernelBlock { vec4 points[kPoints]; };

// Direction's and length's place in the set, for sample j and the texel's two numbers.
ivec2 compute_indices(int j, vec2 offsets) {
    if (kIsConstant) {
        return ivec2(j);
    }
    ivec2 multipliers = ivec2(param_direction_multiplier, param_length_multiplier);
    if (param_indexing == param_indexing_decoupled_literal) {
        int q = int(offsets.x * float(param_offsets));
        return ((j + q) * multipliers) % param_kernel_size;
    }
    ivec2 q = ivec2(offsets * float(param_kernel_size));
    return (j * multipliers + q) % param_kernel_size;
}

vec4 read_point(int j, vec2 offsets) {
    ivec2 index = compute_indices(j, offsets);
    return vec4(points[index.x].xyz, points[index.y].w);
}

// The tangent plane's axes of a hemispherical kernel. Evenly spaced vectors of the plane z = 0 bunch up when they are
// projected onto a tangent plane that is tilted: that is Gram-Schmidt's artefact, kept as it is.
void compute_kernel_frame(vec3 n, float angle, out vec3 tangent, out vec3 bitangent) {
    vec3 random = vec3(cos(angle), sin(angle), 0.0);
    vec3 projected = random - n * dot(random, n);
    compute_tangent_frame(n, tangent, bitangent);
    if (param_kernel == param_kernel_hemisphere_gram_schmidt) {
        // A vector along the normal has no projection: the fixed frame stands in.
        if (dot(projected, projected) > 1e-10) {
            tangent = normalize(projected);
            bitangent = cross(n, tangent);
        }
        return;
    }
    vec3 turned = random.x * tangent + random.y * bitangent;
    bitangent = random.x * bitangent - random.y * tangent;
    tangent = turned;
}
