#include "scenes/common/pedestal.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/polygon.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace alcove {
namespace {

/// (how far it stands out, height) from the ground up.
Contour make_profile(double height, int rounds) {
    Contour profile{{0.1, -0.05}, {0.1, 0.06}};
    const auto add_arc = [&profile, rounds](double out, double y, double size, double from,
                                            double to) {
        for (int i = 0; i <= rounds; ++i) {
            const double angle = std::numbers::pi * (from + (to - from) * i / rounds);
            profile.emplace_back(out + size * std::cos(angle), y + size * std::sin(angle));
        }
    };
    add_arc(0.065, 0.085, 0.025, -0.5, 0.5); // torus
    profile.emplace_back(0.05, 0.112);
    add_arc(0.05, 0.15, 0.035, 1.5, 1.0); // hollow
    profile.emplace_back(0.0, 0.158);
    profile.emplace_back(0.0, height - 0.125);
    profile.emplace_back(0.012, height - 0.12);
    profile.emplace_back(0.012, height - 0.105);
    add_arc(0.045, height - 0.09, 0.03, 1.0, 0.5); // hollow of the cornice
    profile.emplace_back(0.06, height - 0.058);
    profile.emplace_back(0.06, height - 0.012);
    profile.emplace_back(0.05, height);
    return profile;
}

} // namespace

Mesh make_pedestal(std::string name, const glm::vec3& albedo, double height, double half_x,
                   double half_z, int rounds) {
    ALCOVE_ASSERT(height >= 0.3 && half_x > 0.06 && half_z > 0.06 && rounds > 0,
                  "room for the mouldings");
    std::vector<Ring> rings;
    for (const glm::dvec2& point : make_profile(height, rounds)) {
        // The profile stands out from the dado, which is 0.05 m narrower than the top.
        const double x = half_x - 0.05 + point.x;
        const double z = half_z - 0.05 + point.x;
        rings.push_back({{-x, point.y, -z}, {-x, point.y, z}, {x, point.y, z}, {x, point.y, -z}});
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::capped);
    return builder.finish(std::move(name), albedo, 35.0);
}

} // namespace alcove
