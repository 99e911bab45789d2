#include "core/frame/scene_culler.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

/// The cosine of a cone's test is trusted to this much: cones come in single precision.
constexpr double kConeMargin = 1e-3;

void grow(std::span<const glm::vec3> positions, glm::vec3& low, glm::vec3& high) {
    low = glm::vec3(std::numeric_limits<float>::infinity());
    high = -low;
    for (const glm::vec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
}

bool faces_away(const Cluster& cluster, const glm::dvec3& eye) {
    if (!(cluster.cone_cutoff < 1.0f)) {
        return false;
    }
    const glm::dvec3 way = glm::dvec3(cluster.cone_apex) - eye;
    const double length = glm::length(way);
    return length > 0.0 && glm::dot(way, glm::dvec3(cluster.cone_axis)) >=
                               (cluster.cone_cutoff + kConeMargin) * length;
}

} // namespace

SceneCuller::SceneCuller(const Scene& scene)
    : m_scene(scene), m_items(scene.get_objects().size()), m_tree({}) {
    for (const Mesh& mesh : scene.get_meshes()) {
        MeshBox& box = m_mesh_boxes.emplace_back();
        grow(mesh.positions, box.low, box.high);
    }
    const Pose pose = scene.compute_pose(0.0);
    std::vector<OrientedBox> boxes;
    for (std::uint32_t i = 0; i < m_items.size(); ++i) {
        if (scene.get_objects()[i].motion == ObjectMotion::still) {
            place(i, pose.object_to_world[i]);
            m_still.push_back(i);
            boxes.push_back(m_items[i].box);
        } else {
            m_moving.push_back(i);
        }
    }
    m_tree = BoxTree(boxes);
}

void SceneCuller::place(std::size_t object, const glm::dmat4& world_from_object) {
    const std::size_t mesh = m_scene.get_objects()[object].mesh;
    m_items[object] = {
        place_box(m_mesh_boxes[mesh].low, m_mesh_boxes[mesh].high, world_from_object),
        m_scene.get_meshes()[mesh].closed && glm::determinant(glm::dmat3(world_from_object)) > 0.0};
}

void SceneCuller::set_frame(const FramePose& pose) {
    m_pose = &pose;
    for (const std::uint32_t object : m_moving) {
        place(object, pose.now.object_to_world[object]);
    }
    for (const FramePose::Deformed& deformed : pose.deformed) {
        glm::vec3 low;
        glm::vec3 high;
        grow(deformed.now.positions, low, high);
        // Folds may turn a deformed solid inside out.
        m_items[deformed.object] = {place_box(low, high, pose.now.object_to_world[deformed.object]),
                                    false};
    }
}

bool SceneCuller::is_kept(const OrientedBox& box, const ViewVolume& volume, const Tests& tests) {
    if (tests.tests_frustum && !volume.may_show(box)) {
        return false;
    }
    const std::optional<ScreenBounds> bounds =
        tests.hider ? volume.project(box) : std::optional<ScreenBounds>();
    if (!bounds) {
        return true;
    }
    const double margin =
        compute_depth_margin(volume.camera(), tests.hider->precision, bounds->nearest_m);
    return !tests.hider->pyramid.is_nearer(*bounds, bounds->nearest_m - margin);
}

void SceneCuller::add(std::uint32_t object, const ViewVolume& volume, const Tests& tests,
                      VisibleSet& visible) const {
    const Item& item = m_items[object];
    if (!is_kept(item.box, volume, tests)) {
        return;
    }
    const Object& placed = m_scene.get_objects()[object];
    const Mesh& mesh = m_scene.get_meshes()[placed.mesh];
    const bool culls_back_faces = item.is_one_sided && volume.is_beyond_near(item.box);
    const std::size_t first = visible.ranges.size();
    if (!tests.tests_frustum || mesh.clusters.empty() || placed.motion == ObjectMotion::deforming) {
        visible.ranges.push_back({0, static_cast<std::uint32_t>(mesh.indices.size())});
    } else {
        Tests of_clusters = tests;
        of_clusters.tests_cones = tests.tests_cones && culls_back_faces;
        add_clusters(mesh, object, volume, of_clusters, visible);
    }
    if (visible.ranges.size() == first) {
        return;
    }
    for (std::size_t i = first; i < visible.ranges.size(); ++i) {
        visible.triangles += visible.ranges[i].count / 3;
    }
    visible.objects.push_back({object, culls_back_faces, static_cast<std::uint32_t>(first),
                               static_cast<std::uint32_t>(visible.ranges.size() - first)});
}

void SceneCuller::add_clusters(const Mesh& mesh, std::uint32_t object, const ViewVolume& volume,
                               const Tests& tests, VisibleSet& visible) const {
    const glm::dmat4& world_from_object = m_pose->now.object_to_world[object];
    const glm::dvec3 eye(glm::inverse(world_from_object) *
                         glm::dvec4(volume.camera().position, 1.0));
    const std::size_t first = visible.ranges.size();
    for (const Cluster& cluster : mesh.clusters) {
        if ((tests.tests_cones && faces_away(cluster, eye)) ||
            !is_kept(place_box(cluster.low, cluster.high, world_from_object), volume, tests)) {
            continue;
        }
        const bool goes_on =
            visible.ranges.size() > first &&
            visible.ranges.back().first + visible.ranges.back().count == cluster.first_index;
        if (goes_on) {
            visible.ranges.back().count += cluster.index_count;
        } else {
            visible.ranges.push_back({cluster.first_index, cluster.index_count});
        }
    }
}

VisibleSet SceneCuller::find_all(const ViewVolume& volume) const {
    VisibleSet visible;
    for (std::uint32_t i = 0; i < m_items.size(); ++i) {
        add(i, volume, {false, false, std::nullopt}, visible);
    }
    return visible;
}

VisibleSet SceneCuller::find(const ViewVolume& volume, const Tests& tests) const {
    ALCOVE_ASSERT(m_pose != nullptr, "set_frame before a question about the frame");
    std::vector<std::uint32_t> candidates = m_moving;
    m_tree.visit([&](const OrientedBox& box) { return is_kept(box, volume, tests); },
                 [&](std::uint32_t item) { candidates.push_back(m_still[item]); });
    std::sort(candidates.begin(), candidates.end());
    VisibleSet visible;
    for (const std::uint32_t object : candidates) {
        add(object, volume, tests, visible);
    }
    return visible;
}

VisibleSet SceneCuller::find_visible(const ViewVolume& volume,
                                     const std::optional<Hider>& hider) const {
    return find(volume, {true, true, hider});
}

VisibleSet SceneCuller::find_in_frustum(const ViewVolume& volume) const {
    return find(volume, {true, false, std::nullopt});
}

VisibleSet SceneCuller::choose_hiders(const VisibleSet& visible, const ViewVolume& volume,
                                      std::size_t triangles) const {
    struct Candidate {
        double pixels_a_triangle;
        std::size_t index; ///< into visible.objects
        std::size_t triangles;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < visible.objects.size(); ++i) {
        const VisibleObject& object = visible.objects[i];
        std::size_t count = 0;
        for (std::uint32_t range = 0; range < object.range_count; ++range) {
            count += visible.ranges[object.first_range + range].count / 3;
        }
        const std::optional<ScreenBounds> bounds = volume.project(m_items[object.object].box);
        // A box at the near plane may fill the image.
        const double pixels =
            bounds ? bounds->pixel_count() : std::numeric_limits<double>::infinity();
        candidates.push_back({pixels / static_cast<double>(count), i, count});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.pixels_a_triangle > b.pixels_a_triangle ||
               (a.pixels_a_triangle == b.pixels_a_triangle && a.index < b.index);
    });
    std::vector<std::size_t> chosen;
    std::size_t used = 0;
    for (const Candidate& candidate : candidates) {
        if (used + candidate.triangles <= triangles) {
            used += candidate.triangles;
            chosen.push_back(candidate.index);
        }
    }
    std::sort(chosen.begin(), chosen.end());
    VisibleSet hiders;
    hiders.triangles = used;
    for (const std::size_t index : chosen) {
        VisibleObject object = visible.objects[index];
        const auto first = visible.ranges.begin() + object.first_range;
        object.first_range = static_cast<std::uint32_t>(hiders.ranges.size());
        hiders.ranges.insert(hiders.ranges.end(), first, first + object.range_count);
        hiders.objects.push_back(object);
    }
    return hiders;
}

} // namespace alcove
