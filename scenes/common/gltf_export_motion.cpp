#include "scenes/common/gltf_export_motion.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/glb_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

namespace alcove {

std::optional<NodePlace> split_transform(const glm::dmat4& matrix) {
    constexpr double kShear = 1e-9;
    NodePlace place;
    place.translation = glm::dvec3(matrix[3]);
    glm::dmat3 axes(matrix);
    const bool is_mirrored = glm::determinant(axes) < 0.0;
    for (int i = 0; i < 3; ++i) {
        place.scale[i] = glm::length(axes[i]);
        if (!(place.scale[i] > 0.0) || !std::isfinite(place.scale[i])) {
            return std::nullopt;
        }
        axes[i] /= place.scale[i];
    }
    const double shear = std::abs(glm::dot(axes[0], axes[1])) +
                         std::abs(glm::dot(axes[1], axes[2])) +
                         std::abs(glm::dot(axes[2], axes[0]));
    if (!(shear < kShear)) {
        return std::nullopt;
    }
    if (is_mirrored) {
        place.scale[0] = -place.scale[0];
        axes[0] = -axes[0];
    }
    place.rotation = glm::normalize(glm::quat_cast(axes));
    return place;
}

struct MotionExporter::State {
    GlbBuilder& glb;
    std::size_t frames = 0;
    double step_s = 0.0;
    std::optional<std::size_t> times; ///< accessor
    nlohmann::json channels = nlohmann::json::array();
    nlohmann::json samplers = nlohmann::json::array();

    void add_channel(std::size_t node, const char* path, std::vector<float> values,
                     std::size_t components) {
        // The last frame holds until the clip repeats.
        const std::vector<float> last(values.end() - static_cast<std::ptrdiff_t>(components),
                                      values.end());
        values.insert(values.end(), last.begin(), last.end());
        samplers.push_back({{"input", find_times()},
                            {"output", glb.add_floats(values, components)},
                            {"interpolation", "LINEAR"}});
        channels.push_back(
            {{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    }

    [[nodiscard]] std::size_t find_times() {
        if (!times) {
            std::vector<float> seconds;
            for (std::size_t frame = 0; frame <= frames; ++frame) {
                seconds.push_back(static_cast<float>(static_cast<double>(frame) * step_s));
            }
            times = glb.add_floats(seconds, 1);
        }
        return *times;
    }
};

MotionExporter::MotionExporter(GlbBuilder& glb, std::size_t frames, double step_s)
    : m_state(new State{glb, frames, step_s, {}, {}, {}}) {}

MotionExporter::~MotionExporter() = default;

void MotionExporter::add(std::size_t node, const std::vector<NodePlace>& places) {
    ALCOVE_ASSERT(places.size() == m_state->frames && !places.empty(), "one place a frame");
    std::vector<float> translations;
    std::vector<float> rotations;
    std::vector<float> scales;
    for (const NodePlace& place : places) {
        for (int i = 0; i < 3; ++i) {
            translations.push_back(static_cast<float>(place.translation[i]));
            scales.push_back(static_cast<float>(place.scale[i]));
        }
        for (const double value :
             {place.rotation.x, place.rotation.y, place.rotation.z, place.rotation.w}) {
            rotations.push_back(static_cast<float>(value));
        }
    }
    m_state->add_channel(node, "translation", std::move(translations), 3);
    m_state->add_channel(node, "rotation", std::move(rotations), 4);
    if (std::adjacent_find(places.begin(), places.end(), [](const auto& a, const auto& b) {
            return a.scale != b.scale;
        }) != places.end()) {
        m_state->add_channel(node, "scale", std::move(scales), 3);
    }
}

void MotionExporter::finish() {
    if (!m_state->channels.empty()) {
        m_state->glb.add("animations", {{"name", "walkthrough"},
                                        {"channels", std::move(m_state->channels)},
                                        {"samplers", std::move(m_state->samplers)}});
    }
}

} // namespace alcove
