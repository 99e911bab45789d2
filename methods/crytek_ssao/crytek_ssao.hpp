#pragma once
// Points in a sphere around the pixel's position, compared with the depth buffer, with the kernels,
// random numbers and switches that a catalogue of artefacts asks for: each artefact is provoked and
// removed by parameters. Step lengths are uniform in [0, r], so that an occluder at distance d is
// counted with probability 1 - d/r: linear falloff.
// This work is based on: Mittring. Finding next gen: CryEngine 2. 2007; and on the blog "Know your
// SSAO artifacts", 2013.

#include "methods/common/estimator_method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

/// sphere: all of it, half of which lies behind an open plane. The others keep to the normal's
/// side: points of the sphere reflected about the pixel's random vector and flipped, or points of
/// the hemisphere in a frame from that vector by Gram-Schmidt, or in a fixed frame turned by a
/// random angle.
enum class CrytekKernel {
    sphere,
    sphere_reflected,
    hemisphere_gram_schmidt,
    hemisphere_frame,
};
/// off: every pixel alike. tile: 4x4 random vectors, evenly spread, repeated. pixel: a hash.
enum class CrytekRandomisation { off, tile, pixel };
/// constant: sample j takes point j. The others take direction and length of two points of a set of
/// `kernel_size`, chosen by the pixel: with one random number for both, or with one each.
enum class CrytekIndexing { constant, decoupled_literal, decoupled };
enum class CrytekWeighting { uniform, cosine };
/// How the picture is composed, over 4 samples a pixel: with the pixel's visibility for all of
/// them, or for each with that of the nearest depth around.
enum class CrytekMsaa { off, pixel, nearest_depth };

struct CrytekSsaoParams {
    double radius = 0.5; ///< metres
    int samples = 16;    ///< a pixel
    CrytekKernel kernel = CrytekKernel::sphere_reflected;
    CrytekWeighting weighting = CrytekWeighting::cosine;
    bool normalise = true; ///< sphere: an open plane is open, not half open
    CrytekRandomisation randomisation = CrytekRandomisation::tile;
    double min_cosine = 0.15; ///< of a sample's direction and the normal, in [0, 0.5]
    double range = 1.0; ///< in radii of depth before the sample; inf: occluders at any distance
    CrytekIndexing indexing = CrytekIndexing::constant;
    int kernel_size = 11;         ///< points of the set that decoupled samples are chosen from
    int direction_multiplier = 1; ///< of the sample's index
    int length_multiplier = 7;    ///< of the sample's index
    int offsets = 18;             ///< values of the literal form's random number
    double bias = 1.0;            ///< in half pixel footprints along the surface
    KernelBorder border = KernelBorder::open;
    double strength = 1.0; ///< factor on occlusion
    EstimatorResolution resolution = EstimatorResolution::full;
    int upsample_width = 8; ///< pixels of the full resolution
    int blur_radius = 3;    ///< pixels on each side; 0: no blur
    double blur_edge = 0.1; ///< in radii off the tangent plane
    CrytekMsaa msaa = CrytekMsaa::off;
};

/// The points that samples are made of: xyz = unit direction, w = length in radii, in [0, 1).
/// Halton points 1..n in bases 2 (elevation), 3 (azimuth), 5 (length). Of the sphere in view space;
/// of the hemisphere with z along the normal and at least `min_cosine`. The whole sphere takes its
/// samples in opposite pairs and has half as many points.
[[nodiscard]] std::vector<glm::vec4> make_crytek_kernel(const CrytekSsaoParams& params);

/// Of pixel offsets q and sample j the direction's and the length's place in the set. Literal:
/// both of one offset. Mirrors the shader; for tests and for who wants to count pairs.
struct CrytekIndices {
    int direction = 0;
    int length = 0;
};
[[nodiscard]] CrytekIndices compute_crytek_indices(int sample, int direction_offset,
                                                   int length_offset,
                                                   const CrytekSsaoParams& params);

[[nodiscard]] MethodUnit crytek_ssao_unit();

} // namespace alcove
