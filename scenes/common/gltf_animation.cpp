#include "scenes/common/gltf_animation.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scenes/common/gltf_accessor.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <tiny_gltf.h>

namespace alcove {
namespace {

/// Longest clip, seconds: a week. Times beyond are nonsense, and float cannot tell frames apart.
constexpr double kLongestClip = 604'800.0;

class ClipReader {
  public:
    ClipReader(const GltfDocument& document, int index, GltfTree& tree, GltfWarnings& warnings)
        : m_document(document),
          m_source(document.model->animations[static_cast<std::size_t>(index)]),
          m_where(document.name("animations", index)), m_tree(tree), m_warnings(warnings) {}

    [[nodiscard]] GltfClip read() {
        for (std::size_t i = 0; i < m_source.channels.size(); ++i) {
            read_channel(m_source.channels[i], m_where + ".channels[" + std::to_string(i) + "]");
        }
        return std::move(m_clip);
    }

  private:
    void read_channel(const tinygltf::AnimationChannel& channel, const std::string& where) {
        if (channel.target_node < 0) {
            m_warnings.insert("animation channel without a node is ignored: " + where);
            return;
        }
        const auto node = static_cast<std::size_t>(channel.target_node);
        if (node >= m_tree.places.size()) {
            throw InputError(where + ".target.node", "no such node",
                             std::to_string(channel.target_node),
                             "less than " + std::to_string(m_tree.places.size()));
        }
        if (!m_tree.places[node]) {
            return; // moves what is not shown
        }
        const std::size_t place = *m_tree.places[node];
        const std::string& path = channel.target_path;
        if (path == "weights") {
            read_weights(channel, node, place, where);
        } else if (path == "translation" || path == "rotation" || path == "scale") {
            read_transform(channel, m_tree.nodes[place], where);
        } else {
            m_warnings.insert("animation channel is ignored, unknown path: " + where);
        }
    }

    void read_transform(const tinygltf::AnimationChannel& channel, TreeNode& node,
                        const std::string& where) {
        if (node.matrix) {
            m_warnings.insert("animation channel is ignored, its node has a matrix: " + where);
            return;
        }
        const std::string& path = channel.target_path;
        std::optional<Keyframes>& place = path == "translation" ? node.moving_translation
                                          : path == "rotation"  ? node.moving_rotation
                                                                : node.moving_scale;
        if (place) {
            throw InputError(where, "a second channel of one target", path, "one channel a target");
        }
        const std::size_t components = path == "rotation" ? 4 : 3;
        place = read_keys(channel, components, where);
        if (place && components == 4) {
            check_rotations(*place, where);
        }
    }

    void read_weights(const tinygltf::AnimationChannel& channel, std::size_t node,
                      std::size_t place, const std::string& where) {
        const int mesh = m_document.model->nodes[node].mesh;
        const auto& meshes = m_document.model->meshes;
        const bool is_morphed =
            mesh >= 0 && static_cast<std::size_t>(mesh) < meshes.size() &&
            !meshes[static_cast<std::size_t>(mesh)].primitives.empty() &&
            !meshes[static_cast<std::size_t>(mesh)].primitives[0].targets.empty();
        if (!is_morphed) {
            m_warnings.insert("animation channel is ignored, its node has no morph targets: " +
                              where);
            return;
        }
        const std::size_t targets =
            meshes[static_cast<std::size_t>(mesh)].primitives[0].targets.size();
        if (m_clip.weights.contains(place)) {
            throw InputError(where, "a second channel of one target", "weights",
                             "one channel a target");
        }
        if (auto keys = read_keys(channel, targets, where)) {
            m_clip.weights.emplace(place, std::move(*keys));
        }
    }

    [[nodiscard]] std::optional<Keyframes> read_keys(const tinygltf::AnimationChannel& channel,
                                                     std::size_t components,
                                                     const std::string& where) {
        if (channel.sampler < 0 ||
            static_cast<std::size_t>(channel.sampler) >= m_source.samplers.size()) {
            throw InputError(where + ".sampler", "no such sampler", std::to_string(channel.sampler),
                             "less than " + std::to_string(m_source.samplers.size()));
        }
        const tinygltf::AnimationSampler& sampler =
            m_source.samplers[static_cast<std::size_t>(channel.sampler)];
        Keyframes keys;
        keys.components = components;
        if (sampler.interpolation == "STEP") {
            keys.interpolation = KeyInterpolation::step;
        } else if (sampler.interpolation == "CUBICSPLINE") {
            keys.interpolation = KeyInterpolation::cubic;
        } else if (sampler.interpolation != "LINEAR") {
            m_warnings.insert("animation channel is ignored, unknown interpolation: " + where);
            return std::nullopt;
        }
        keys.times_s = read_times(sampler.input);
        // A weight is a scalar; all weights of a key follow each other.
        const std::size_t width = channel.target_path == "weights" ? 1 : components;
        keys.values = read_numbers(m_document, sampler.output, width, GltfNumbers::normalised);
        const std::size_t parts = keys.interpolation == KeyInterpolation::cubic ? 3 : 1;
        const std::size_t expected = keys.times_s.size() * components * parts;
        if (keys.values.size() != expected) {
            throw InputError(m_document.name("accessors", sampler.output),
                             "does not have a value a key of " + where,
                             std::to_string(keys.values.size()) + " numbers",
                             std::to_string(expected));
        }
        m_clip.duration_s = std::max(m_clip.duration_s, keys.times_s.back());
        return keys;
    }

    [[nodiscard]] std::vector<double> read_times(int accessor) const {
        const auto numbers = read_numbers(m_document, accessor, 1, GltfNumbers::real);
        std::vector<double> times(numbers.begin(), numbers.end());
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (!(times[i] >= 0.0 && times[i] <= kLongestClip) ||
                (i > 0 && !(times[i] > times[i - 1]))) {
                throw InputError(m_document.name("accessors", accessor),
                                 "time " + std::to_string(i) +
                                     " does not ascend or is out of range",
                                 format_number(times[i]),
                                 "seconds that ascend, 0 to " + format_number(kLongestClip));
            }
        }
        return times;
    }

    static void check_rotations(const Keyframes& keys, const std::string& where) {
        const bool is_cubic = keys.interpolation == KeyInterpolation::cubic;
        for (std::size_t i = 0; i < keys.times_s.size(); ++i) {
            const float* value = keys.values.data() + 4 * (is_cubic ? 3 * i + 1 : i);
            const double length =
                std::hypot(std::hypot(value[0], value[1]), std::hypot(value[2], value[3]));
            if (!(length > 1e-6)) {
                throw InputError(where, "key " + std::to_string(i) + " is not a rotation", {},
                                 "a unit quaternion");
            }
        }
    }

    const GltfDocument& m_document;
    const tinygltf::Animation& m_source;
    std::string m_where;
    GltfTree& m_tree;
    GltfWarnings& m_warnings;
    GltfClip m_clip;
};

/// True if no two clips move the same property of the same node.
bool are_apart(const tinygltf::Model& model) {
    std::map<std::pair<int, std::string>, std::size_t> owners;
    for (std::size_t i = 0; i < model.animations.size(); ++i) {
        for (const tinygltf::AnimationChannel& channel : model.animations[i].channels) {
            const auto [owner, is_new] =
                owners.emplace(std::pair(channel.target_node, channel.target_path), i);
            if (!is_new && owner->second != i) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

GltfClip read_clip(const GltfDocument& document, std::optional<int> index, GltfTree& tree,
                   GltfWarnings& warnings) {
    const std::size_t count = document.model->animations.size();
    const int chosen = index.value_or(0);
    if (index && (*index < 0 || static_cast<std::size_t>(*index) >= count)) {
        throw InputError(document.name("animations", *index), "no such animation", {},
                         count == 0 ? "a file with animations"
                                    : "less than " + std::to_string(count));
    }
    if (count == 0) {
        return {};
    }
    if (!index && count > 1 && are_apart(*document.model)) {
        GltfClip all;
        for (int i = 0; i < static_cast<int>(count); ++i) {
            GltfClip clip = ClipReader(document, i, tree, warnings).read();
            all.duration_s = std::max(all.duration_s, clip.duration_s);
            all.weights.merge(clip.weights);
        }
        return all;
    }
    if (count > 1) {
        warnings.insert("only animations[" + std::to_string(chosen) + "] of " +
                        std::to_string(count) + " animations is played");
    }
    return ClipReader(document, chosen, tree, warnings).read();
}

} // namespace alcove
