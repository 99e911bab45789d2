#include "scenes/toes/toes.hpp"

#include "scenes/common/round_solids.hpp"
#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Soles reach this deep into the floor, metres: in contact over an area, as a foot is.
constexpr double kSink = 0.002;
constexpr int kAround = 40;

/// A section of the foot across its length: how far it reaches to the inner and outer side and up.
struct Section {
    double z = 0.0; ///< from the heel forward
    double inner = 0.0;
    double outer = 0.0;
    double sole = 0.0; ///< height of its lowest point
    double top = 0.0;
};

/// Flat below, round above.
Ring make_section(const Section& section) {
    Ring ring;
    for (int i = 0; i < kAround; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kAround;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        // A superellipse of exponent 4 below the widest place and 2 above it.
        const double side = c < 0.0 ? section.inner : section.outer;
        const double power = s < 0.0 ? 0.5 : 1.0;
        const double low = 0.3 * (section.top - section.sole);
        const double x = side * std::copysign(std::pow(std::abs(c), power), c);
        const double y = section.sole + low +
                         std::copysign(std::pow(std::abs(s), power), s) *
                             (s < 0.0 ? low : section.top - section.sole - low);
        ring.emplace_back(x, y, section.z);
    }
    return ring;
}

void add_sole(MeshBuilder& builder) {
    // From the heel over the arch, which lifts off the floor on its inner side, to the ball.
    const std::array<Section, 11> sections{{{-0.004, 0.010, 0.010, 0.016, 0.032},
                                            {0.002, 0.022, 0.022, 0.004, 0.05},
                                            {0.015, 0.03, 0.03, -kSink, 0.075},
                                            {0.04, 0.033, 0.032, -kSink, 0.105},
                                            {0.07, 0.031, 0.033, 0.002, 0.115},
                                            {0.1, 0.029, 0.035, 0.009, 0.1},
                                            {0.13, 0.03, 0.038, 0.008, 0.08},
                                            {0.16, 0.037, 0.042, 0.001, 0.062},
                                            {0.185, 0.043, 0.043, -kSink, 0.047},
                                            {0.2, 0.042, 0.041, 0.0, 0.036},
                                            {0.209, 0.036, 0.034, 0.006, 0.028}}};
    std::vector<Ring> rings;
    for (const Section& section : sections) {
        rings.push_back(make_section(section));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

/// The ankle and a piece of the leg, cut off level.
void add_leg(MeshBuilder& builder) {
    add_tube(builder,
             {{0.0, 0.04, 0.054},
              {0.0, 0.07, 0.052},
              {0.0, 0.095, 0.049},
              {0.0, 0.14, 0.046},
              {0.0, 0.22, 0.044},
              {0.0, 0.32, 0.04}},
             {0.012, 0.029, 0.036, 0.034, 0.038, 0.048}, kAround);
    for (const double side : {-1.0, 1.0}) { // ankle bones
        add_ball(builder, 3, [side](const glm::dvec3& d) {
            return glm::dvec3(side * 0.031, 0.095 - 0.006 * side, 0.048) +
                   glm::dvec3(0.011, 0.014, 0.013) * d;
        });
    }
}

/// A toe: balls for its pad and knuckle, a tube between them and the foot, and its nail.
void add_toe(MeshBuilder& builder, double x, double z, double length, double radius) {
    const double spread = 0.12 * x / 0.04; // toes fan out
    const auto at = [&](double along, double height) {
        return glm::dvec3(x + spread * along, height, z + along);
    };
    const double pad = 0.92 * radius - kSink; // the pad is flattened by a twelfth
    add_tube(builder,
             {at(-0.03, 1.25 * radius + 0.005), at(0.2 * length, 1.5 * radius),
              at(0.6 * length, 1.25 * radius), at(length, pad + 0.1 * radius)},
             {0.8 * radius, 0.85 * radius, 0.82 * radius, 0.7 * radius}, 24);
    add_ball(builder, 3, [&](const glm::dvec3& d) {
        return at(0.35 * length, 1.45 * radius) + 0.9 * radius * d;
    });
    add_ball(builder, 3, [&](const glm::dvec3& d) {
        return at(length, pad) + radius * glm::dvec3(1.0, 0.92, 1.15) * d;
    });
    add_ball(builder, 2, [&](const glm::dvec3& d) { // nail
        return at(length + 0.42 * radius, pad + 0.62 * radius) +
               radius * glm::dvec3(0.55, 0.28, 0.6) * d;
    });
}

/// The left one.
Mesh make_foot() {
    MeshBuilder builder;
    add_sole(builder);
    add_leg(builder);
    // From the big toe on the inner side (-x) to the little one.
    add_toe(builder, -0.029, 0.203, 0.04, 0.0135);
    add_toe(builder, -0.0065, 0.207, 0.036, 0.0092);
    add_toe(builder, 0.0095, 0.203, 0.032, 0.0085);
    add_toe(builder, 0.0245, 0.195, 0.028, 0.008);
    add_toe(builder, 0.0375, 0.183, 0.022, 0.0078);
    return builder.finish("left foot", {0.72f, 0.5f, 0.4f}, 100.0);
}

/// Turned over in x: triangles too, so that they stay counter-clockwise from outside.
Mesh mirror(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i].x = -mesh.positions[i].x;
        mesh.normals[i].x = -mesh.normals[i].x;
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    return mesh;
}

std::unique_ptr<Scene> open_toes(const ResolvedParameters& /*resolved*/) {
    SceneKit kit;
    kit.add(make_box_mesh("floor", {0.66f, 0.62f, 0.56f}, {-1.0, -0.1, -1.0}, {1.0, 0.0, 1.0}));
    Mesh left = make_foot();
    Mesh right = mirror(left);
    right.name = "right foot";
    kit.add(std::move(left), make_place({0.085, 0.0, -0.03}, 0.12));
    kit.add(std::move(right), make_place({-0.085, 0.0, 0.03}, -0.16));
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.6, 1.0, 0.5)), glm::vec3(0.9f, 0.88f, 0.84f)});
    content.lights.ambient = glm::vec3(0.46f, 0.48f, 0.52f);
    content.walkthrough = get_embedded_walkthrough("scenes/toes/walkthrough.json");
    content.ao_radius_m = 0.05;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit toes_unit() {
    SceneUnit unit;
    unit.name = "toes";
    unit.title = "Feet on a floor";
    unit.stresses = "contacts of round shapes: shadow that vanishes into the contact within "
                    "millimetres, slits between toes, a sole that lifts off the floor";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = ParameterTable("toes", {});
    unit.open = open_toes;
    return unit;
}

} // namespace alcove
