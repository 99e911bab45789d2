#include "tests/benchmark/recorded_paths.hpp"

#include "methods/common/sobol.hpp"
#include "tests/benchmark/bare_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr std::size_t kBundle = 16;

/// Directions of 16 rays from one point.
struct Fan {
    glm::vec3 origin;
    std::array<glm::vec3, kBundle> directions;
};

/// 16 rays from anywhere.
struct Scattered {
    std::array<glm::vec3, kBundle> origins;
    std::array<glm::vec3, kBundle> directions;
    std::array<float, kBundle> lengths;
    std::size_t count = 0;
};

/// What one thread takes at a time: the rays of a row of pixels.
struct Row {
    std::vector<Fan> fans;
    std::vector<Scattered> scattered;

    void add(const glm::vec3& origin, const glm::vec3& direction, float length) {
        if (scattered.empty() || scattered.back().count == kBundle) {
            scattered.emplace_back();
        }
        Scattered& bundle = scattered.back();
        bundle.origins[bundle.count] = origin;
        bundle.directions[bundle.count] = direction;
        bundle.lengths[bundle.count] = length;
        ++bundle.count;
    }
};

/// A bundle and its context, as Embree wants them.
struct Query {
    RTCIntersectContext context;
    alignas(64) std::array<int, kBundle> valid;
    alignas(64) RTCRayHit16 rays{};

    Query() {
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        valid.fill(-1);
        std::fill_n(rays.ray.mask, kBundle, 0xffffffffu);
    }

    void set_direction(std::size_t lane, const glm::vec3& d) {
        rays.ray.dir_x[lane] = d.x;
        rays.ray.dir_y[lane] = d.y;
        rays.ray.dir_z[lane] = d.z;
    }

    void find_nearest(RTCScene tree, const Fan& fan, float reach) {
        valid.fill(-1);
        std::fill_n(rays.ray.org_x, kBundle, fan.origin.x);
        std::fill_n(rays.ray.org_y, kBundle, fan.origin.y);
        std::fill_n(rays.ray.org_z, kBundle, fan.origin.z);
        std::fill_n(rays.ray.tfar, kBundle, reach);
        std::fill_n(rays.hit.geomID, kBundle, RTC_INVALID_GEOMETRY_ID);
        for (std::size_t lane = 0; lane < kBundle; ++lane) {
            set_direction(lane, fan.directions[lane]);
        }
        rtcIntersect16(valid.data(), tree, &context, &rays);
    }

    void find_occluded(RTCScene tree, const Scattered& bundle) {
        for (std::size_t lane = 0; lane < kBundle; ++lane) {
            valid[lane] = lane < bundle.count ? -1 : 0;
            rays.ray.org_x[lane] = bundle.origins[lane].x;
            rays.ray.org_y[lane] = bundle.origins[lane].y;
            rays.ray.org_z[lane] = bundle.origins[lane].z;
            rays.ray.tfar[lane] = bundle.lengths[lane];
            set_direction(lane, bundle.directions[lane]);
        }
        rtcOccluded16(valid.data(), tree, &context, &rays.ray);
    }
};

} // namespace

struct RecordedPaths::State {
    explicit State(const PosedGeometry& geometry) : scene(geometry) {}

    BareScene scene;
    float reach = 0.0f;
    std::vector<Row> rows;

    /// Rays from where lane `lane` of the answered query hit.
    void add_scattered(Row& row, const Query& query, std::size_t lane, std::uint32_t seed,
                       const glm::vec3& to_light) const;
};

void RecordedPaths::State::add_scattered(Row& row, const Query& query, std::size_t lane,
                                         std::uint32_t seed, const glm::vec3& to_light) const {
    const RTCRay16& ray = query.rays.ray;
    const RTCHit16& hit = query.rays.hit;
    const glm::vec3 d(ray.dir_x[lane], ray.dir_y[lane], ray.dir_z[lane]);
    glm::vec3 normal = glm::normalize(glm::vec3(hit.Ng_x[lane], hit.Ng_y[lane], hit.Ng_z[lane]));
    normal *= glm::dot(normal, d) > 0.0f ? -1.0f : 1.0f;
    const glm::vec3 origin = glm::vec3(ray.org_x[lane], ray.org_y[lane], ray.org_z[lane]) +
                             ray.tfar[lane] * d + normal * (ray.tfar[lane] * 0x1p-16f);
    row.add(origin, make_bare_direction(make_bare_frame(normal), compute_scrambled_sobol(0, seed)),
            reach);
    if (glm::dot(normal, to_light) > 0.0f) {
        row.add(origin, to_light, std::numeric_limits<float>::infinity());
    }
}

RecordedPaths::RecordedPaths(const PosedGeometry& geometry, const Camera& camera, ImageSize size,
                             const PathRecording& recording)
    : m_state(std::make_unique<State>(geometry)) {
    State& state = *m_state;
    state.reach = recording.reach_m;
    const std::vector<BareReceiver> receivers =
        state.scene.find_receivers(camera, size, geometry.origin);
    const auto width = static_cast<std::size_t>(size.width);
    const auto per_half = static_cast<std::size_t>(recording.rays_per_half) / kBundle;
    Query query;
    for (std::size_t r = 0; r < receivers.size(); ++r) {
        if (r % width == 0) {
            state.rows.emplace_back();
        }
        Row& row = state.rows.back();
        if (glm::dot(receivers[r].normal, recording.to_light) > 0.0f) {
            row.add(receivers[r].origin, recording.to_light,
                    std::numeric_limits<float>::infinity());
        }
        const glm::mat3 frame = make_bare_frame(receivers[r].normal);
        for (std::size_t b = 0; b < 2 * per_half; ++b) {
            const auto seed = static_cast<std::uint32_t>(2 * r + b / per_half);
            Fan& fan = row.fans.emplace_back();
            fan.origin = receivers[r].origin;
            for (std::size_t lane = 0; lane < kBundle; ++lane) {
                fan.directions[lane] = make_bare_direction(
                    frame, compute_scrambled_sobol(
                               static_cast<std::uint32_t>(b % per_half * kBundle + lane), seed));
            }
            query.find_nearest(state.scene.tree(), fan, state.reach);
            for (std::size_t lane = 0; lane < kBundle; ++lane) {
                if (query.rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID) {
                    const auto number = static_cast<std::uint32_t>(b * kBundle + lane);
                    state.add_scattered(row, query, lane, hash_words(seed, number),
                                        recording.to_light);
                }
            }
        }
    }
}

RecordedPaths::~RecordedPaths() = default;

std::uint64_t RecordedPaths::ray_count() const {
    std::uint64_t count = scattered_count();
    for (const Row& row : m_state->rows) {
        count += row.fans.size() * kBundle;
    }
    return count;
}

std::uint64_t RecordedPaths::scattered_count() const {
    std::uint64_t count = 0;
    for (const Row& row : m_state->rows) {
        for (const Scattered& bundle : row.scattered) {
            count += bundle.count;
        }
    }
    return count;
}

void RecordedPaths::run() const {
    const State& state = *m_state;
    run_blocks(state.rows.size(), 1, [&](std::size_t first, std::size_t end) {
        Query query;
        for (std::size_t r = first; r < end; ++r) {
            for (const Fan& fan : state.rows[r].fans) {
                query.find_nearest(state.scene.tree(), fan, state.reach);
            }
            for (const Scattered& bundle : state.rows[r].scattered) {
                query.find_occluded(state.scene.tree(), bundle);
            }
        }
    });
}

} // namespace alcove
