#include "tests/benchmark/recorded_bundles.hpp"

#include "methods/common/sobol.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr std::size_t kBundle = 16;

/// What of a bundle cannot be said once for all: 16 directions from one point. Kept small, so that
/// the loop is not one over memory.
struct Directions {
    std::array<float, kBundle> x;
    std::array<float, kBundle> y;
    std::array<float, kBundle> z;
};

struct Receiver {
    glm::vec3 origin;
    glm::vec3 normal;
};

glm::mat3 make_frame(const glm::vec3& n) {
    const glm::vec3 other = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 t = glm::normalize(glm::cross(other, n));
    return {t, glm::cross(n, t), n};
}

} // namespace

struct RecordedBundles::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<Receiver> receivers;
    std::vector<Directions> bundles; ///< as many a receiver as both halves have
    std::size_t bundles_per_receiver = 0;
    float radius = 0.0f;
};

RecordedBundles::RecordedBundles(const PosedGeometry& geometry, const Camera& camera,
                                 ImageSize size, double radius_m, int rays_per_half)
    : m_state(std::make_unique<State>()) {
    State& state = *m_state;
    state.radius = static_cast<float>(radius_m);
    state.device = rtcNewDevice(nullptr);
    state.scene = rtcNewScene(state.device);
    rtcSetSceneFlags(state.scene, RTC_SCENE_FLAG_ROBUST);
    for (const PosedObject& object : geometry.objects) {
        const RTCGeometry mesh = rtcNewGeometry(state.device, RTC_GEOMETRY_TYPE_TRIANGLE);
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
        rtcAttachGeometry(state.scene, mesh);
        rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(state.scene);

    const glm::vec3 eye(camera.position - geometry.origin);
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
            rtcIntersect1(state.scene, &context, &query);
            if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
                continue;
            }
            glm::vec3 normal =
                glm::normalize(glm::vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z));
            normal *= glm::dot(normal, d) > 0.0f ? -1.0f : 1.0f;
            const glm::vec3 point = eye + query.ray.tfar * d;
            state.receivers.push_back({point + normal * (query.ray.tfar * 0x1p-16f), normal});
        }
    }
    state.bundles_per_receiver = 2 * static_cast<std::size_t>(rays_per_half) / kBundle;
    state.bundles.reserve(state.receivers.size() * state.bundles_per_receiver);
    for (std::size_t r = 0; r < state.receivers.size(); ++r) {
        const glm::mat3 frame = make_frame(state.receivers[r].normal);
        const std::size_t per_half = state.bundles_per_receiver / 2;
        for (std::size_t b = 0; b < state.bundles_per_receiver; ++b) {
            const auto seed = static_cast<std::uint32_t>(2 * r + b / per_half);
            Directions& bundle = state.bundles.emplace_back();
            for (std::size_t lane = 0; lane < kBundle; ++lane) {
                const glm::vec2 u = compute_scrambled_sobol(
                    static_cast<std::uint32_t>(b % per_half * kBundle + lane), seed);
                const float azimuth = 2.0f * std::numbers::pi_v<float> * u.y;
                const float z = std::sqrt(1.0f - u.x);
                const float horizontal = std::sqrt(std::max(0.0f, 1.0f - z * z));
                const glm::vec3 d = frame * glm::vec3(horizontal * std::cos(azimuth),
                                                      horizontal * std::sin(azimuth), z);
                bundle.x[lane] = d.x;
                bundle.y[lane] = d.y;
                bundle.z[lane] = d.z;
            }
        }
    }
}

RecordedBundles::~RecordedBundles() {
    rtcReleaseScene(m_state->scene);
    rtcReleaseDevice(m_state->device);
}

std::size_t RecordedBundles::receiver_count() const {
    return m_state->receivers.size();
}

std::uint64_t RecordedBundles::ray_count() const {
    return m_state->bundles.size() * kBundle;
}

void RecordedBundles::run() const {
    constexpr std::size_t kBlock =
        384; // receivers a thread takes at a time: a row of the default image
    const State& state = *m_state;
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        alignas(64) std::array<int, kBundle> valid;
        valid.fill(-1);
        alignas(64) RTCRay16 rays{};
        for (std::size_t lane = 0; lane < kBundle; ++lane) {
            rays.mask[lane] = 0xffffffffu;
        }
        for (std::size_t first = next.fetch_add(kBlock); first < state.receivers.size();
             first = next.fetch_add(kBlock)) {
            const std::size_t end = std::min(first + kBlock, state.receivers.size());
            for (std::size_t r = first; r < end; ++r) {
                std::fill_n(rays.org_x, kBundle, state.receivers[r].origin.x);
                std::fill_n(rays.org_y, kBundle, state.receivers[r].origin.y);
                std::fill_n(rays.org_z, kBundle, state.receivers[r].origin.z);
                for (std::size_t b = 0; b < state.bundles_per_receiver; ++b) {
                    const Directions& bundle = state.bundles[r * state.bundles_per_receiver + b];
                    std::copy_n(bundle.x.data(), kBundle, rays.dir_x);
                    std::copy_n(bundle.y.data(), kBundle, rays.dir_y);
                    std::copy_n(bundle.z.data(), kBundle, rays.dir_z);
                    std::fill_n(rays.tfar, kBundle, state.radius);
                    rtcOccluded16(valid.data(), state.scene, &context, &rays);
                }
            }
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back(work);
    }
    work();
}

} // namespace alcove
