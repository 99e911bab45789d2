#include "methods/common/traced_scene.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"

#include <algorithm>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace alcove {

void TracedScene::DeviceDeleter::operator()(RTCDeviceTy* device) const {
    rtcReleaseDevice(device);
}

void TracedScene::SceneDeleter::operator()(RTCSceneTy* scene) const {
    rtcReleaseScene(scene);
}

TracedScene::TracedScene(std::size_t instances_from)
    : m_instances_from(instances_from), m_device(rtcNewDevice(nullptr)) {
    if (!m_device) {
        throw FailureError("Embree", "no device", std::to_string(rtcGetDeviceError(nullptr)));
    }
}

TracedScene::Surface TracedScene::place(const PosedObject& object) {
    Surface surface;
    const glm::mat4 matrix = object.origin_from_object;
    const glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(matrix)));
    surface.mesh = object.mesh;
    const std::span<const glm::vec3> positions = object.positions();
    const std::span<const glm::vec3> normals = object.normals();
    surface.positions.reserve(positions.size());
    surface.normals.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        surface.positions.emplace_back(matrix * glm::vec4(positions[i], 1.0f));
        surface.normals.push_back(glm::normalize(normal_matrix * normals[i]));
    }
    return surface;
}

TracedScene::SceneHandle TracedScene::make_tree() const {
    SceneHandle tree(rtcNewScene(m_device.get()));
    rtcSetSceneFlags(tree.get(), RTC_SCENE_FLAG_ROBUST);
    return tree;
}

void TracedScene::attach(RTCScene tree, const Surface& surface, unsigned id) const {
    const RTCGeometry mesh = rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), surface.positions.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), surface.mesh->indices.size() / 3));
    if (positions == nullptr || indices == nullptr) {
        rtcReleaseGeometry(mesh);
        throw FailureError("Embree", "out of memory for the scene's triangles");
    }
    std::copy(surface.positions.begin(), surface.positions.end(), positions);
    std::copy(surface.mesh->indices.begin(), surface.mesh->indices.end(), indices);
    rtcCommitGeometry(mesh);
    rtcAttachGeometryByID(tree, mesh, id);
    rtcReleaseGeometry(mesh);
}

void TracedScene::add_instance(const Shared& shared, const glm::mat4& origin_from_part) {
    const RTCGeometry instance = rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, shared.tree.get());
    rtcSetGeometryTimeStepCount(instance, 1);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            glm::value_ptr(origin_from_part));
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(m_top.get(), instance, static_cast<unsigned>(m_instances.size()));
    rtcReleaseGeometry(instance);
    m_instances.push_back(
        {&shared, origin_from_part, glm::transpose(glm::inverse(glm::mat3(origin_from_part)))});
}

void TracedScene::commit(RTCScene tree) const {
    rtcCommitScene(tree);
    const RTCError error = rtcGetDeviceError(m_device.get());
    if (error != RTC_ERROR_NONE) {
        throw FailureError("Embree", "the tree cannot be built", std::to_string(error));
    }
}

void TracedScene::forget_other_scenes(const PosedGeometry& geometry) {
    if (m_built_for != geometry.scene || m_origin != geometry.origin) {
        m_top.reset();
        m_still.reset();
        m_meshes.clear();
    }
    m_built_for = geometry.scene;
    m_origin = geometry.origin;
}

std::vector<bool> TracedScene::choose_instances(const PosedGeometry& geometry) const {
    std::map<const Mesh*, std::size_t> uses;
    std::size_t triangles = 0;
    for (const PosedObject& object : geometry.objects) {
        triangles += object.mesh->indices.size() / 3;
        ++uses[object.mesh];
    }
    std::vector<bool> chosen(geometry.objects.size(), false);
    for (std::size_t i = 0; i < chosen.size() && triangles >= m_instances_from; ++i) {
        const PosedObject& object = geometry.objects[i];
        chosen[i] = !object.deformation && uses.at(object.mesh) > 1;
    }
    return chosen;
}

const TracedScene::Shared& TracedScene::get_mesh(const Mesh& mesh) {
    const auto known = m_meshes.find(&mesh);
    if (known != m_meshes.end()) {
        return known->second;
    }
    Shared& shared = m_meshes[&mesh];
    shared.tree = make_tree();
    shared.surfaces.push_back({mesh.positions, mesh.normals, &mesh});
    attach(shared.tree.get(), shared.surfaces.front(), 0);
    commit(shared.tree.get());
    return shared;
}

void TracedScene::build_still(const PosedGeometry& geometry, const std::vector<bool>& is_instance) {
    m_still = std::make_unique<Shared>();
    for (std::size_t i = 0; i < geometry.objects.size(); ++i) {
        if (!is_instance[i] && geometry.objects[i].motion == ObjectMotion::still) {
            m_still->surfaces.push_back(place(geometry.objects[i]));
        }
    }
    m_still->tree = make_tree();
    for (unsigned i = 0; i < m_still->surfaces.size(); ++i) {
        attach(m_still->tree.get(), m_still->surfaces[i], i);
    }
    commit(m_still->tree.get());
}

void TracedScene::update(const PosedGeometry& geometry) {
    if (m_top && geometry.is_static && m_is_static && m_built_for == geometry.scene &&
        m_origin == geometry.origin) {
        return;
    }
    forget_other_scenes(geometry);
    m_is_static = geometry.is_static;
    const std::vector<bool> is_instance = choose_instances(geometry);
    m_top = make_tree();
    m_instances.clear();
    m_direct.clear();
    // A scene that stands still as a whole is built once anyway, and without a level in between.
    const bool keeps_still = !geometry.is_static;
    if (keeps_still && !m_still) {
        build_still(geometry, is_instance);
    }
    if (m_still && !m_still->surfaces.empty()) {
        add_instance(*m_still, glm::mat4(1.0f));
    }
    for (std::size_t i = 0; i < geometry.objects.size(); ++i) {
        const PosedObject& object = geometry.objects[i];
        if (is_instance[i]) {
            add_instance(get_mesh(*object.mesh), object.origin_from_object);
        } else if (!(keeps_still && object.motion == ObjectMotion::still)) {
            m_direct.push_back(place(object));
        }
    }
    for (std::size_t i = 0; i < m_direct.size(); ++i) {
        attach(m_top.get(), m_direct[i], static_cast<unsigned>(m_instances.size() + i));
    }
    commit(m_top.get());
}

TracedTriangle TracedScene::get_triangle(const TracedHit& hit) const {
    const bool is_instance = hit.instance != RTC_INVALID_GEOMETRY_ID;
    const Instance* instance = is_instance ? &m_instances[hit.instance] : nullptr;
    const Surface& surface = is_instance ? instance->shared->surfaces[hit.geometry]
                                         : m_direct[hit.geometry - m_instances.size()];
    TracedTriangle triangle;
    triangle.mesh = surface.mesh;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = surface.mesh->indices[std::size_t{3} * hit.primitive + i];
        triangle.vertices[i] = vertex;
        triangle.corners[i] = surface.positions[vertex];
        triangle.normals[i] = surface.normals[vertex];
        if (is_instance) {
            triangle.corners[i] =
                glm::vec3(instance->origin_from_part * glm::vec4(triangle.corners[i], 1.0f));
            triangle.normals[i] = glm::normalize(instance->normal_matrix * triangle.normals[i]);
        }
    }
    return triangle;
}

} // namespace alcove
