#pragma once
// Ambient occlusion in two parts: near, by spheres around the pixels about the receiver, on several
// depth layers; far, by spheres that stand for the geometry and are drawn as billboards over all
// receivers that they reach.

#include "core/contract/method.hpp"

#include <limits>

namespace alcove {

enum class OcclusionPart { combined, near, far };
enum class SecondSurface { peeled, back_faces };
enum class NeighbourPattern { logarithmic, random, square };
enum class OcclusionNorm { one, pi, two_pi };
enum class RadiusRule { covering, rms_ball, rms_disc, silhouette };
enum class SphereMembers { surface, vertices };
enum class OcclusionBlending { additive, multiplicative };

struct ShanmugamArikanParams {
    OcclusionPart part = OcclusionPart::combined;
    double r_far = 0.5; ///< metres
    int samples = 32;   ///< most neighbours of a pixel on each layer
    NeighbourPattern pattern = NeighbourPattern::logarithmic;
    bool rotation = true;
    int layers = 2; ///< depth layers of the near part
    SecondSurface second = SecondSurface::peeled;
    double push_back = 1.0; ///< in radii of a neighbour's sphere
    double epsilon = 0.05;  ///< steradians
    /// Metres; farthest centre of a sphere that counts.
    double reach = std::numeric_limits<double>::infinity();
    int spheres = 2000; ///< over all objects
    SphereMembers members = SphereMembers::surface;
    RadiusRule radius_rule = RadiusRule::rms_disc;
    double sphere_push_back = 1.0; ///< in radii times the length of the members' mean normal
    bool far_from_r_far = true;    ///< nearer spheres are left to the near part
    OcclusionNorm norm = OcclusionNorm::pi;
    double inside_value = 0.0; ///< steradians
    OcclusionBlending blending = OcclusionBlending::additive;
    double strength = 1.0; ///< factor on occlusion
};

[[nodiscard]] MethodUnit shanmugam_arikan_unit();

} // namespace alcove
