#include "methods/common/ray_tracer.hpp"

#include "core/base/error.hpp"
#include "methods/common/sobol.hpp"
#include "methods/common/traced_scene.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <thread>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

/// Rays a bundle. All of a bundle start at one point, which is what makes 16 at once worth it.
constexpr unsigned kBundle = SobolBundles::kPoints;

/// Where rays of a pixel start, and around what.
struct Receiver {
    glm::vec3 origin;
    glm::vec3 normal;
};

/// An orthonormal frame (Duff et al. Building an orthonormal basis, revisited. 2017).
glm::mat3 make_frame(const glm::vec3& n) {
    const float s = std::copysign(1.0f, n.z);
    const float a = -1.0f / (s + n.z);
    const float b = n.x * n.y * a;
    return {glm::vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x),
            glm::vec3(b, s + n.y * n.y * a, -n.y), n};
}

/// cos and sin of 2 pi u for u in [0,1], within 1e-7: polynomials over an eighth of a turn to
/// either side of the nearest quarter. Without branches, so that a loop over lanes becomes one over
/// vectors.
void compute_turn(float u, float& cosine, float& sine) {
    // floor(4 u + 1/2)
    const std::int32_t quarter = static_cast<std::int32_t>(8.0f * u + 1.0f) >> 1;
    const float a = (4.0f * u - static_cast<float>(quarter)) * (0.5f * std::numbers::pi_v<float>);
    const float b = a * a;
    const float s =
        a * (1.0f + b * (-1.0f / 6 + b * (1.0f / 120 + b * (-1.0f / 5040 + b * (1.0f / 362880)))));
    const float c = 1.0f + b * (-0.5f + b * (1.0f / 24 + b * (-1.0f / 720 + b * (1.0f / 40320))));
    const bool is_odd = (quarter & 1) != 0;
    const float x = is_odd ? s : c;
    const float y = is_odd ? c : s;
    cosine = ((quarter + 1) & 2) != 0 ? -x : x;
    sine = (quarter & 2) != 0 ? -y : y;
}

/// Directions of one bundle about the frame's third axis.
void make_directions(const SobolBundles::Points& points, Weighting weighting,
                     const glm::mat3& frame, RTCRayHit16& bundle) {
    alignas(64) std::array<float, kBundle> z;
    alignas(64) std::array<float, kBundle> horizontal;
    for (unsigned lane = 0; lane < kBundle; ++lane) {
        // Density cos / pi needs z = sqrt(1 - u), uniform density z = 1 - u; neither reaches the
        // horizon's z = 0.
        const float rest = 1.0f - points.x[lane];
        z[lane] = weighting == Weighting::cosine ? std::sqrt(rest) : rest;
        horizontal[lane] = std::sqrt(std::max(0.0f, 1.0f - z[lane] * z[lane]));
    }
    for (unsigned lane = 0; lane < kBundle; ++lane) {
        float cosine = 0.0f;
        float sine = 0.0f;
        compute_turn(points.y[lane], cosine, sine);
        const float x = horizontal[lane] * cosine;
        const float y = horizontal[lane] * sine;
        bundle.ray.dir_x[lane] = frame[0].x * x + frame[1].x * y + frame[2].x * z[lane];
        bundle.ray.dir_y[lane] = frame[0].y * x + frame[1].y * y + frame[2].y * z[lane];
        bundle.ray.dir_z[lane] = frame[0].z * x + frame[1].z * y + frame[2].z * z[lane];
    }
}

float compute_weight(Falloff falloff, float relative_distance) {
    switch (falloff) {
    case Falloff::none:
        return 1.0f;
    case Falloff::linear:
        return 1.0f - relative_distance;
    case Falloff::quadratic:
        break;
    }
    return 1.0f - relative_distance * relative_distance;
}

/// Moves the point off the planes that the vertex normals span, so that shading normals do not
/// start rays below facets that are only facets. This work is based on: Hanika. Hacking the shadow
/// terminator. Ray Tracing Gems II. 2021.
glm::vec3 lift_off_terminator(const glm::vec3& point, const std::array<glm::vec3, 3>& corners,
                              const std::array<glm::vec3, 3>& normals,
                              const std::array<float, 3>& barycentric) {
    glm::vec3 lifted = point;
    for (std::size_t i = 0; i < 3; ++i) {
        const float below = std::min(0.0f, glm::dot(point - corners[i], normals[i]));
        lifted -= barycentric[i] * below * normals[i];
    }
    return lifted;
}

/// `work` on this thread and on others; 0: as many as there are cores.
void run_on_threads(int threads, const std::function<void()>& work) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const unsigned count = threads > 0 ? static_cast<unsigned>(threads) : cores;
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < count; ++i) {
        others.emplace_back(work);
    }
    work();
}

/// 32 units in the last place of the largest number that took part in placing a point.
float compute_lift(const glm::vec3& point, float farthest) {
    return 0x1p-18f * std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), farthest});
}

} // namespace

struct RayTracer::State {
    TracedScene scene;

    [[nodiscard]] bool find_receiver(const glm::vec3& eye, const glm::vec3& direction,
                                     const Camera& camera, const TraceSettings& settings,
                                     Receiver& receiver) const;
    [[nodiscard]] float trace_half(const Receiver& receiver, std::uint32_t seed,
                                   const SobolBundles& points, const TraceSettings& settings) const;
};

bool RayTracer::State::find_receiver(const glm::vec3& eye, const glm::vec3& direction,
                                     const Camera& camera, const TraceSettings& settings,
                                     Receiver& receiver) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = eye.x;
    query.ray.org_y = eye.y;
    query.ray.org_z = eye.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    // The direction has unit length along the view axis: ray distances are eye depths.
    query.ray.tnear = static_cast<float>(camera.near_m);
    query.ray.tfar = static_cast<float>(camera.far_m);
    query.ray.mask = 0xffffffffu;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene.top(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return false;
    }
    TracedTriangle triangle =
        scene.get_triangle({query.hit.instID[0], query.hit.geomID, query.hit.primID});
    const std::array<glm::vec3, 3>& corners = triangle.corners;
    std::array<glm::vec3, 3>& normals = triangle.normals;
    const std::array<float, 3> barycentric{1.0f - query.hit.u - query.hit.v, query.hit.u,
                                           query.hit.v};
    glm::vec3 point(0.0f);
    glm::vec3 shading(0.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        point += barycentric[i] * corners[i];
        shading += barycentric[i] * normals[i];
    }
    glm::vec3 geometric =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    // Counter-clockwise is the front, as for the rasteriser: seen from behind, both normals turn
    // over.
    const float side = glm::dot(geometric, direction) > 0.0f ? -1.0f : 1.0f;
    geometric *= side;
    const bool uses_shading = settings.target.normals == Normals::shading;
    receiver.normal = uses_shading ? side * glm::normalize(shading) : geometric;
    if (uses_shading && settings.terminator_safe) {
        for (glm::vec3& normal : normals) {
            normal *= side;
        }
        point = lift_off_terminator(point, corners, normals, barycentric);
    }
    receiver.origin = point + geometric * compute_lift(point, query.ray.tfar);
    return true;
}

float RayTracer::State::trace_half(const Receiver& receiver, std::uint32_t seed,
                                   const SobolBundles& points,
                                   const TraceSettings& settings) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const glm::mat3 frame = make_frame(receiver.normal);
    const auto radius = static_cast<float>(settings.target.radius_m);
    const auto rays = static_cast<unsigned>(settings.rays_per_half);
    const bool needs_distance = settings.target.falloff != Falloff::none;
    float blocked = 0.0f;
    // A query changes tfar and, where it hits, the hit: all else stands from bundle to bundle.
    alignas(64) RTCRayHit16 bundle;
    alignas(64) std::array<int, kBundle> valid;
    for (unsigned lane = 0; lane < kBundle; ++lane) {
        bundle.ray.org_x[lane] = receiver.origin.x;
        bundle.ray.org_y[lane] = receiver.origin.y;
        bundle.ray.org_z[lane] = receiver.origin.z;
        bundle.ray.tnear[lane] = 0.0f;
        bundle.ray.time[lane] = 0.0f;
        bundle.ray.mask[lane] = 0xffffffffu;
        bundle.ray.id[lane] = lane;
        bundle.ray.flags[lane] = 0;
        bundle.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    SobolBundles::Points sobol;
    for (unsigned first = 0; first < rays; first += kBundle) {
        points.scramble(first, seed, sobol);
        make_directions(sobol, settings.target.weighting, frame, bundle);
        for (unsigned lane = 0; lane < kBundle; ++lane) {
            valid[lane] = first + lane < rays ? -1 : 0;
            bundle.ray.tfar[lane] = radius;
            bundle.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        }
        if (needs_distance) {
            // Most rays meet nothing: the closest hit is searched for those alone that meet
            // something.
            rtcOccluded16(valid.data(), scene.top(), &context, &bundle.ray);
            bool any = false;
            for (unsigned lane = 0; lane < kBundle; ++lane) {
                const bool is_blocked = valid[lane] != 0 && bundle.ray.tfar[lane] < 0.0f;
                valid[lane] = is_blocked ? -1 : 0;
                bundle.ray.tfar[lane] = radius;
                any = any || is_blocked;
            }
            if (!any) {
                continue;
            }
            rtcIntersect16(valid.data(), scene.top(), &context, &bundle);
        } else {
            rtcOccluded16(valid.data(), scene.top(), &context, &bundle.ray);
        }
        for (unsigned lane = 0; lane < kBundle; ++lane) {
            const bool hit = needs_distance ? bundle.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID
                                            : bundle.ray.tfar[lane] < 0.0f;
            if (valid[lane] != 0 && hit) {
                blocked += compute_weight(settings.target.falloff, bundle.ray.tfar[lane] / radius);
            }
        }
    }
    return 1.0f - blocked / static_cast<float>(rays);
}

RayTracer::RayTracer() : m_state(std::make_unique<State>()) {}

RayTracer::~RayTracer() = default;

void RayTracer::update(const PosedGeometry& geometry) {
    m_state->scene.update(geometry);
}

ReferencePair RayTracer::trace(const Camera& camera, ImageSize size,
                               const TraceSettings& settings) const {
    const State& state = *m_state;
    ALCOVE_ASSERT(state.scene.is_built(), "update before trace");
    ALCOVE_ASSERT(settings.rays_per_half >= 1 && settings.target.radius_m > 0.0, "trace settings");
    ReferencePair pair{Image(size, 1, 1.0f), Image(size, 1, 1.0f), 0};
    const glm::vec3 eye(camera.position - state.scene.origin());
    const SobolBundles points(static_cast<unsigned>(settings.rays_per_half));
    std::atomic<int> next_row{0};
    std::atomic<std::uint64_t> receivers{0};
    const auto work = [&] {
        std::uint64_t found = 0;
        for (int y = next_row++; y < size.height; y = next_row++) {
            for (int x = 0; x < size.width; ++x) {
                const glm::vec3 direction(
                    compute_pixel_direction(camera, size, {x + 0.5, y + 0.5}));
                Receiver receiver{};
                if (!state.find_receiver(eye, direction, camera, settings, receiver)) {
                    continue;
                }
                const auto pixel = static_cast<std::uint32_t>(y * size.width + x);
                const std::uint32_t seed = hash_words(settings.seed, pixel);
                pair.a.at(x, y) =
                    state.trace_half(receiver, hash_words(seed, 0xau), points, settings);
                pair.b.at(x, y) =
                    state.trace_half(receiver, hash_words(seed, 0xbu), points, settings);
                ++found;
            }
        }
        receivers += found;
    };
    run_on_threads(settings.threads, work);
    pair.ray_count = receivers * 2 * static_cast<std::uint64_t>(settings.rays_per_half);
    return pair;
}

std::vector<float> RayTracer::trace_points(std::span<const SurfacePoint> points,
                                           const TraceSettings& settings) const {
    const State& state = *m_state;
    ALCOVE_ASSERT(state.scene.is_built(), "update before trace");
    ALCOVE_ASSERT(settings.rays_per_half >= 1 && settings.target.radius_m > 0.0, "trace settings");
    constexpr std::size_t kBatch = 256;
    std::vector<float> visibility(points.size(), 1.0f);
    const SobolBundles sobol(static_cast<unsigned>(settings.rays_per_half));
    std::atomic<std::size_t> next{0};
    run_on_threads(settings.threads, [&] {
        for (std::size_t first = next.fetch_add(kBatch); first < points.size();
             first = next.fetch_add(kBatch)) {
            for (std::size_t i = first; i < std::min(first + kBatch, points.size()); ++i) {
                const glm::vec3& position = points[i].position;
                const Receiver receiver{position + points[i].normal * compute_lift(position, 0.0f),
                                        points[i].normal};
                const std::uint32_t seed = hash_words(settings.seed, static_cast<std::uint32_t>(i));
                visibility[i] =
                    0.5f * (state.trace_half(receiver, hash_words(seed, 0xau), sobol, settings) +
                            state.trace_half(receiver, hash_words(seed, 0xbu), sobol, settings));
            }
        }
    });
    return visibility;
}

Image compute_mean(const ReferencePair& pair) {
    Image mean = pair.a;
    const std::span<const float> b = pair.b.values();
    for (std::size_t i = 0; i < b.size(); ++i) {
        mean.values()[i] = 0.5f * (mean.values()[i] + b[i]);
    }
    return mean;
}

double compute_noise(const ReferencePair& pair) {
    double sum = 0.0;
    const std::span<const float> a = pair.a.values();
    const std::span<const float> b = pair.b.values();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return 0.5 * std::sqrt(sum / static_cast<double>(a.size()));
}

} // namespace alcove
