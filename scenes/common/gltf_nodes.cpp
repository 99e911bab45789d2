#include "scenes/common/gltf_nodes.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr int kDeepestNode = 256;

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) {
                return false;
            }
        }
    }
    return true;
}

/// Throws unless the values are missing or `size` finite ones. Returns whether they are there.
bool check_values(const std::vector<double>& values, std::size_t size, const std::string& where,
                  const char* name) {
    if (!values.empty() && values.size() != size) {
        throw InputError(where + "." + name, "wrong number of elements",
                         std::to_string(values.size()), std::to_string(size));
    }
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
        throw InputError(where + "." + name, "transform is not finite and affine");
    }
    return !values.empty();
}

TreeNode read_transform(const tinygltf::Node& source, const std::string& where) {
    TreeNode node;
    if (check_values(source.matrix, 16, where, "matrix")) {
        glm::dmat4 matrix(1.0);
        for (int i = 0; i < 16; ++i) {
            matrix[i / 4][i % 4] = source.matrix[static_cast<std::size_t>(i)];
        }
        const glm::dvec4 last(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
        if (last != glm::dvec4(0.0, 0.0, 0.0, 1.0)) {
            throw InputError(where, "transform is not finite and affine");
        }
        node.matrix = matrix;
        return node;
    }
    if (check_values(source.rotation, 4, where, "rotation")) {
        const std::vector<double>& r = source.rotation;
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        if (!(glm::length(rotation) > 1e-6)) {
            throw InputError(where + ".rotation", "is not a rotation", {}, "a unit quaternion");
        }
        node.rotation = glm::normalize(rotation);
    }
    if (check_values(source.scale, 3, where, "scale")) {
        node.scale = {source.scale[0], source.scale[1], source.scale[2]};
    }
    if (check_values(source.translation, 3, where, "translation")) {
        node.translation = {source.translation[0], source.translation[1], source.translation[2]};
    }
    return node;
}

std::vector<int> find_roots(const GltfDocument& document, GltfWarnings& warnings) {
    const tinygltf::Model& model = *document.model;
    if (!model.scenes.empty()) {
        const int index = std::max(model.defaultScene, 0);
        if (static_cast<std::size_t>(index) >= model.scenes.size()) {
            throw InputError(document.file + ": scene", "no such scene", std::to_string(index),
                             "less than " + std::to_string(model.scenes.size()));
        }
        if (model.scenes.size() > 1) {
            warnings.insert("only scenes[" + std::to_string(index) + "] of " +
                            std::to_string(model.scenes.size()) + " scenes is shown");
        }
        return model.scenes[static_cast<std::size_t>(index)].nodes;
    }
    warnings.insert("the file has no scene: every node without a parent is shown");
    std::set<int> children;
    for (const tinygltf::Node& node : model.nodes) {
        children.insert(node.children.begin(), node.children.end());
    }
    std::vector<int> roots;
    for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
        if (!children.contains(i)) {
            roots.push_back(i);
        }
    }
    return roots;
}

void visit(const GltfDocument& document, int index, std::optional<std::size_t> parent, int depth,
           GltfTree& tree) {
    const std::vector<tinygltf::Node>& nodes = document.model->nodes;
    const std::string where = document.name("nodes", index);
    if (index < 0 || static_cast<std::size_t>(index) >= nodes.size()) {
        throw InputError(where, "no such node", {}, "less than " + std::to_string(nodes.size()));
    }
    if (depth > kDeepestNode) {
        throw InputError(where, "nodes nested too deeply", {},
                         "at most " + std::to_string(kDeepestNode));
    }
    std::optional<std::size_t>& place = tree.places[static_cast<std::size_t>(index)];
    if (place) {
        throw InputError(where, "is reached twice", {}, "nodes that form trees, without cycles");
    }
    const tinygltf::Node& source = nodes[static_cast<std::size_t>(index)];
    TreeNode node = read_transform(source, where);
    node.parent = parent;
    place = tree.nodes.size();
    tree.nodes.push_back(node);
    tree.indices.push_back(index);
    for (const int child : source.children) {
        visit(document, child, tree.places[static_cast<std::size_t>(index)], depth + 1, tree);
    }
}

} // namespace

std::string GltfTree::name(const GltfDocument& document, std::size_t node) const {
    return document.name("nodes", indices[node]);
}

GltfTree read_nodes(const GltfDocument& document, GltfWarnings& warnings) {
    GltfTree tree;
    tree.places.resize(document.model->nodes.size());
    for (const int root : find_roots(document, warnings)) {
        visit(document, root, std::nullopt, 0, tree);
    }
    const std::vector<glm::dmat4> rest = compute_nodes(tree.nodes, 0.0);
    for (std::size_t i = 0; i < rest.size(); ++i) {
        if (!is_finite(rest[i])) {
            throw InputError(tree.name(document, i), "transform is not finite");
        }
    }
    return tree;
}

} // namespace alcove
