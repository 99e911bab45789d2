#include "scenes/common/constant_speed.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/arc_length.hpp"

#include <glm/geometric.hpp>

namespace alcove {

std::vector<CameraPose> sample_at_constant_speed(const std::vector<CameraPose>& keys, int frames) {
    ALCOVE_ASSERT(keys.size() > 1 && frames > 1, "two keys and two frames");
    std::vector<double> knots{0.0};
    for (std::size_t i = 1; i < keys.size(); ++i) {
        knots.push_back(knots.back() + glm::distance(keys[i].position, keys[i - 1].position));
    }
    const CameraCurve curve(knots, keys);
    const ArcLength way([&curve](double parameter) { return curve.compute_speed(parameter); },
                        knots);
    std::vector<CameraPose> poses;
    for (int frame = 0; frame < frames; ++frame) {
        const double share = static_cast<double>(frame) / (frames - 1);
        poses.push_back(curve.evaluate(way.find_parameter(share * way.total())));
    }
    return poses;
}

} // namespace alcove
