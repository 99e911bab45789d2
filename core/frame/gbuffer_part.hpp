#pragma once
// The G-buffers beside the ordinary one that a method may declare: deeper layers, back faces, other
// views, more samples a pixel. Each is drawn only if declared and charged as input cost.

#include "core/frame/frame_view.hpp"

#include <string>

namespace alcove {

inline constexpr int kMostLayers = 4;
inline constexpr std::size_t kMostViews = 4;
inline constexpr int kMostSamples = 8;

/// A camera beside the viewer's that looks at the same point. This work is based on: Ritschel,
/// Grosch, Seidel. Approximating dynamic global illumination in image space. 2009, section on
/// multiple cameras: position = viewer + displacement x the scene's bounding radius.
struct ExtraView {
    /// Right, up and backward of the viewer, in bounding radii.
    glm::dvec3 displacement{0.0};
    double resolution = 1.0; ///< of its sides against the viewer's, in (0, 1]
    friend bool operator==(const ExtraView&, const ExtraView&) = default;
};

enum class PartKind {
    nearest,     ///< the ordinary G-buffer: what the viewer sees
    layer,       ///< the k-th surface along each pixel's ray, front or back, k in 2..kMostLayers
    back_faces,  ///< the nearest surface that is seen from behind
    view,        ///< the nearest surface of an extra view
    multisampled ///< the ordinary one with 2, 4 or 8 samples a pixel
};

struct GBufferPart {
    PartKind kind = PartKind::nearest;
    int index = 0;  ///< k of a layer, number of a view from 1, samples a pixel
    ExtraView view; ///< of an extra view
    friend bool operator==(const GBufferPart&, const GBufferPart&) = default;
    /// Any total order: parts are keys.
    friend bool operator<(const GBufferPart& a, const GBufferPart& b);
};

/// "layer2", "back_faces", "view1", "msaa4"; empty for the ordinary one.
[[nodiscard]] std::string to_text(const GBufferPart& part);

/// A sphere around all objects as they stand at time 0: of the box around their boxes.
struct BoundingSphere {
    glm::dvec3 centre{0.0};
    double radius_m = 0.0;
};
[[nodiscard]] BoundingSphere compute_bounding_sphere(const Scene& scene);

/// The pixels of a part of an image of `size`: with the border but for extra views, which have
/// their own resolution, and samples.
[[nodiscard]] ImageSize get_part_size(const GBufferPart& part, ImageSize size,
                                      const Border& border);

/// `view`, told without border, as the part is drawn: extended by the border, displaced, or as it
/// is. An extra view's viewer is taken to look at the
/// point of its view axis that is nearest to the scene's centre, and at least a tenth of its radius
/// ahead; the far plane is moved back by what the camera has been moved. Asserts a displacement
/// that does not put the camera into that point or upright above it.
[[nodiscard]] FrameView make_part_view(const GBufferPart& part, const FrameView& view,
                                       const Border& border, const BoundingSphere& scene);

} // namespace alcove
