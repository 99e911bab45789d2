#include "tests/benchmark/bare_scene.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace alcove {

BareScene::BareScene(const PosedGeometry& geometry)
    : m_device(rtcNewDevice(nullptr)), m_tree(rtcNewScene(m_device)) {
    rtcSetSceneFlags(m_tree, RTC_SCENE_FLAG_ROBUST);
    for (const PosedObject& object : geometry.objects) {
        const RTCGeometry mesh = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t vertices = object.mesh->positions.size();
        auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), vertices));
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), object.mesh->indices.size() / 3));
        for (std::size_t i = 0; i < vertices; ++i) {
            positions[i] =
                glm::vec3(object.origin_from_object * glm::vec4(object.mesh->positions[i], 1.0f));
        }
        std::copy(object.mesh->indices.begin(), object.mesh->indices.end(), indices);
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(m_tree, mesh);
        rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(m_tree);
}

BareScene::~BareScene() {
    rtcReleaseScene(m_tree);
    rtcReleaseDevice(m_device);
}

std::vector<BareReceiver> BareScene::find_receivers(const Camera& camera, ImageSize size,
                                                    const glm::dvec3& origin) const {
    std::vector<BareReceiver> receivers;
    const glm::vec3 eye(camera.position - origin);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::vec3 d(compute_pixel_direction(camera, size, {x + 0.5, y + 0.5}));
            RTCRayHit query{};
            query.ray = {eye.x, eye.y, eye.z, static_cast<float>(camera.near_m), d.x,
                         d.y,   d.z,   0.0f,  static_cast<float>(camera.far_m),  0xffffffffu,
                         0,     0};
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(m_tree, &context, &query);
            if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
                continue;
            }
            glm::vec3 normal =
                glm::normalize(glm::vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z));
            normal *= glm::dot(normal, d) > 0.0f ? -1.0f : 1.0f;
            const glm::vec3 point = eye + query.ray.tfar * d;
            receivers.push_back({point + normal * (query.ray.tfar * 0x1p-16f), normal});
        }
    }
    return receivers;
}

glm::mat3 make_bare_frame(const glm::vec3& n) {
    const glm::vec3 other = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 t = glm::normalize(glm::cross(other, n));
    return {t, glm::cross(n, t), n};
}

glm::vec3 make_bare_direction(const glm::mat3& frame, const glm::vec2& u) {
    const float azimuth = 2.0f * std::numbers::pi_v<float> * u.y;
    const float z = std::sqrt(1.0f - u.x);
    const float horizontal = std::sqrt(std::max(0.0f, 1.0f - z * z));
    return frame * glm::vec3(horizontal * std::cos(azimuth), horizontal * std::sin(azimuth), z);
}

void run_blocks(std::size_t count, std::size_t block,
                const std::function<void(std::size_t, std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t first = next.fetch_add(block); first < count;
             first = next.fetch_add(block)) {
            work(first, std::min(first + block, count));
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back(run);
    }
    run();
}

} // namespace alcove
