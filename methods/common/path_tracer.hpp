#pragma once
// Ray-traced light with one diffuse bounce: truth for the light that methods gather, in world
// space, over the same posed triangles that are rasterised, with two independent randomisations
// that tell its own noise. No OpenGL.
// This work is based on: Kajiya. The rendering equation. 1986, cut after one bounce.

#include "core/base/camera.hpp"
#include "core/base/target.hpp"
#include "core/frame/posed_geometry.hpp"
#include "methods/common/reference_pair.hpp"

#include <cstdint>
#include <memory>

namespace alcove {

/// What a ray that hits something at the distance d brings. Beyond the reach there are the
/// surroundings alone, as if nothing stood there.
enum class PathReach {
    near, ///< up to the radius r: weight(d/r) of the sender, the rest of the surroundings
    full  ///< the sender, however far it is
};

struct PathSettings {
    double radius_m = 1.0;              ///< r, > 0; of PathReach::near
    Falloff falloff = Falloff::linear;  ///< the weight; of PathReach::near
    PathReach reach = PathReach::near;  ///< of rays at the receiver and at the sender alike
    Normals normals = Normals::shading; ///< of receivers and senders
    int bounces = 1;                    ///< 0: senders are black; 1: lit by lights and environment
    int rays_per_half = 64; ///< a pixel and half, >= 1; multiples of 16 fill the bundles
    std::uint32_t seed = 0;
    /// Start rays of shading normals where no neighbouring facet cuts them off.
    bool terminator_safe = true;
    int threads = 0; ///< 0: all cores. The image does not depend on it
    /// Leave TracedRadiance::environment and bounce.
    bool wants_parts = false;
};

/// Radiance towards the eye, linear Rec. 709, three channels.
struct TracedRadiance {
    /// From directional and point lights straight on, with shadow rays for those that cast shadows.
    /// Exact, so one image; background 0.
    Image direct;
    /// Environment and bounce; background: what compute_background_radiance gives along the pixel's
    /// ray. Counts rays of every kind, those of the camera and of shadows as well.
    ReferencePair indirect;
    /// 1 - mean weight of the hits of the same rays (cosine): one channel, background 1.
    Image visibility;
    Image environment; ///< the surroundings' part of indirect's mean; empty unless asked for
    Image bounce;      ///< the senders' part; empty unless asked for
};

class PathTracer {
  public:
    PathTracer();
    ~PathTracer();
    PathTracer(const PathTracer&) = delete;
    PathTracer& operator=(const PathTracer&) = delete;

    /// Builds the tree and decodes textures, unless they already are those of this static scene.
    /// The scene must outlive its use. Throws FailureError if Embree fails.
    void update(const PosedGeometry& geometry);

    /// Evaluated where the ray through the pixel centre hits; both sides of a surface block,
    /// receive and send; near and far clip camera rays only. Asserts that update was called.
    [[nodiscard]] TracedRadiance trace(const Camera& camera, ImageSize size, const Lights& lights,
                                       const PathSettings& settings) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace alcove
