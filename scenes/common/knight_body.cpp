#include "scenes/common/figure_shapes.hpp"
#include "scenes/common/knight.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <glm/common.hpp>

namespace alcove {
namespace {

constexpr glm::vec3 kMail(0.3f, 0.31f, 0.33f);

/// Share of each limb in a place; those that are left out have none.
using Weights = std::vector<std::pair<Limb, double>>;

int scale(int at_one, double detail, int minimum) {
    return std::max(minimum, static_cast<int>(std::lround(at_one * std::sqrt(detail))));
}

class BodyBuilder {
  public:
    explicit BodyBuilder(double detail) : m_detail(detail) {}

    [[nodiscard]] int around(int at_one) const { return scale(at_one, m_detail, 8); }
    [[nodiscard]] int steps(int at_one) const { return scale(at_one, m_detail, 1); }

    /// One solid, with the weights of its places at rest.
    void add(const MeshBuilder& solid, const glm::vec3& colour,
             const std::function<Weights(const glm::dvec3&)>& weigh) {
        const Mesh mesh = solid.finish("", glm::vec3(1.0f), 60.0);
        const auto first = static_cast<std::uint32_t>(m_body.mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            m_body.mesh.positions.push_back(mesh.positions[i]);
            m_body.mesh.normals.push_back(mesh.normals[i]);
            m_body.mesh.colors.push_back(colour);
            Weights weights = weigh(glm::dvec3(mesh.positions[i]));
            weights.resize(m_body.influences.per_vertex, {kTorso, 0.0});
            for (const auto& [limb, weight] : weights) {
                m_body.influences.joints.push_back(static_cast<std::uint16_t>(limb));
                m_body.influences.weights.push_back(static_cast<float>(weight));
            }
        }
        for (const std::uint32_t index : mesh.indices) {
            m_body.mesh.indices.push_back(first + index);
        }
    }

    [[nodiscard]] SkinnedMesh take() {
        m_body.mesh.name = "knight_body";
        m_body.mesh.albedo = glm::vec3(1.0f);
        m_body.mesh.closed = true;
        return std::move(m_body);
    }

  private:
    double m_detail;
    SkinnedMesh m_body;
};

/// `slices` from a joint at `joint`, in world heights at rest.
std::vector<Slice> place_slices(std::vector<Slice> slices, const glm::dvec3& joint) {
    for (Slice& slice : slices) {
        slice.y += joint.y;
        slice.shift += joint.x;
        slice.aside += joint.z;
    }
    return slices;
}

glm::dvec3 get_place(const WalkPose& rest, std::size_t limb) {
    return glm::dvec3(rest[limb][3]);
}

void add_torso(BodyBuilder& body, const WalkPose& rest) {
    const glm::dvec3 hips = get_place(rest, kTorso);
    MeshBuilder solid;
    add_limb(solid,
             place_slices(smooth_slices({{-0.13, 0.04, 0.06},
                                         {-0.1, 0.09, 0.13},
                                         {0.0, 0.125, 0.17},
                                         {0.12, 0.11, 0.15},
                                         {0.28, 0.125, 0.165},
                                         {0.4, 0.13, 0.19, 0.01},
                                         {0.48, 0.115, 0.2, 0.005},
                                         {0.53, 0.085, 0.15},
                                         {0.57, 0.062, 0.075},
                                         {0.62, 0.052, 0.052, 0.01},
                                         {0.68, 0.045, 0.045, 0.015}},
                                        body.steps(4)),
                          hips),
             body.around(48));
    body.add(solid, kMail, [hips](const glm::dvec3& p) -> Weights {
        const double head = glm::smoothstep(0.54, 0.64, p.y - hips.y);
        return {{kTorso, 1.0 - head}, {kHead, head}};
    });
}

void add_arm(BodyBuilder& body, const WalkPose& rest, std::size_t side) {
    const glm::dvec3 shoulder = get_place(rest, kUpperArm + side);
    const glm::dvec3 elbow = get_place(rest, kForearm + side);
    MeshBuilder solid;
    add_limb(solid,
             place_slices(smooth_slices({{-0.58, 0.02, 0.02},
                                         {-0.56, 0.033, 0.036},
                                         {-0.45, 0.046, 0.043},
                                         {-0.36, 0.052, 0.048},
                                         {-0.3, 0.047, 0.047},
                                         {-0.24, 0.05, 0.05},
                                         {-0.12, 0.06, 0.056, 0.005},
                                         {0.0, 0.068, 0.062},
                                         {0.04, 0.055, 0.05},
                                         {0.06, 0.03, 0.03}},
                                        body.steps(4)),
                          shoulder),
             body.around(32));
    body.add(solid, kMail, [elbow, side](const glm::dvec3& p) -> Weights {
        const double upper = glm::smoothstep(-0.05, 0.05, p.y - elbow.y);
        return {{static_cast<Limb>(kUpperArm + side), upper},
                {static_cast<Limb>(kForearm + side), 1.0 - upper}};
    });
}

void add_leg(BodyBuilder& body, const WalkPose& rest, std::size_t side) {
    const glm::dvec3 hip = get_place(rest, kThigh + side);
    const glm::dvec3 knee = get_place(rest, kShin + side);
    MeshBuilder solid;
    add_limb(solid,
             place_slices(smooth_slices({{-0.9, 0.02, 0.02},
                                         {-0.87, 0.038, 0.036},
                                         {-0.78, 0.043, 0.042, -0.005},
                                         {-0.62, 0.06, 0.055, -0.015},
                                         {-0.53, 0.057, 0.054, -0.01},
                                         {-0.45, 0.058, 0.056},
                                         {-0.36, 0.066, 0.064, 0.005},
                                         {-0.15, 0.09, 0.083, 0.01},
                                         {0.0, 0.098, 0.088},
                                         {0.05, 0.075, 0.065},
                                         {0.07, 0.04, 0.035}},
                                        body.steps(4)),
                          hip),
             body.around(36));
    body.add(solid, kMail, [knee, side](const glm::dvec3& p) -> Weights {
        const double thigh = glm::smoothstep(-0.07, 0.07, p.y - knee.y);
        return {{static_cast<Limb>(kThigh + side), thigh},
                {static_cast<Limb>(kShin + side), 1.0 - thigh}};
    });
}

/// From the belt to above the knees: a skirt of cloth that the thighs push.
void add_surcoat(BodyBuilder& body, const WalkPose& rest, const glm::vec3& colour) {
    constexpr double kTop = 0.09; // over the hips
    constexpr double kHem = -0.36;
    constexpr double kCloth = 0.01;
    const glm::dvec3 hips = get_place(rest, kTorso);
    const int around = body.around(72);
    const int rows = body.steps(20) + 3;
    const auto make_ring = [&](double s, double inset) { // s: 0 at the hem, 1 on top
        const double y = kHem + s * (kTop - kHem);
        const double wide = 1.0 - s;
        Ring ring;
        for (int i = 0; i < around; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / around;
            const double pleat = 1.0 + 0.06 * wide * std::sin(9.0 * angle + 0.5);
            ring.emplace_back(
                hips.x + 0.01 + ((0.138 + 0.09 * wide) * pleat - inset) * std::cos(angle),
                hips.y + y, ((0.178 + 0.09 * wide) * pleat - inset) * std::sin(angle));
        }
        return ring;
    };
    std::vector<Ring> rings;
    for (int i = 0; i <= rows; ++i) {
        rings.push_back(make_ring(static_cast<double>(i) / rows, 0.0));
    }
    for (int i = rows; i >= 0; --i) {
        rings.push_back(make_ring(static_cast<double>(i) / rows, kCloth));
    }
    MeshBuilder solid;
    add_loft(solid, rings, LoftEnds::joined);
    body.add(solid, colour, [hips](const glm::dvec3& p) -> Weights {
        const double hang = 0.62 * glm::smoothstep(-0.04, 0.34, hips.y - p.y);
        const double right = glm::smoothstep(-0.13, 0.13, p.z);
        return {{kTorso, 1.0 - hang},
                {kThigh, hang * (1.0 - right)},
                {static_cast<Limb>(kThigh + 1), hang * right}};
    });
}

} // namespace

SkinnedMesh make_knight_body(double detail, const glm::vec3& surcoat) {
    const WalkPose rest = pose_rest(get_knight_body());
    BodyBuilder body(detail);
    add_torso(body, rest);
    add_surcoat(body, rest, surcoat);
    for (std::size_t side = 0; side < 2; ++side) {
        add_arm(body, rest, side);
        add_leg(body, rest, side);
    }
    return body.take();
}

} // namespace alcove
