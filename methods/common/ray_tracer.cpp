#include "methods/common/ray_tracer.hpp"

#include "core/base/assert.hpp"
#include "methods/common/falloff_weight.hpp"
#include "methods/common/ray_directions.hpp"
#include "methods/common/run_on_threads.hpp"
#include "methods/common/sobol.hpp"
#include "methods/common/traced_scene.hpp"
#include "methods/common/traced_surface.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/mat3x3.hpp>

namespace alcove {
namespace {

/// Rays a bundle. All of a bundle start at one point, which is what makes 16 at once worth it.
constexpr unsigned kBundle = SobolBundles::kPoints;

/// Where rays of a pixel start, and around what.
struct Receiver {
    glm::vec3 origin;
    glm::vec3 normal;
};

} // namespace

struct RayTracer::State {
    TracedScene scene;

    [[nodiscard]] float trace_half(const Receiver& receiver, std::uint32_t seed,
                                   const SobolBundles& points, const TraceSettings& settings) const;
};

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
        const BundleDirections directions =
            make_directions(sobol, settings.target.weighting, frame);
        std::copy_n(directions.x.data(), kBundle, bundle.ray.dir_x);
        std::copy_n(directions.y.data(), kBundle, bundle.ray.dir_y);
        std::copy_n(directions.z.data(), kBundle, bundle.ray.dir_z);
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
                blocked +=
                    compute_falloff_weight(settings.target.falloff, bundle.ray.tfar[lane] / radius);
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
    const SurfaceRules rules{settings.target.normals, settings.terminator_safe};
    std::atomic<int> next_row{0};
    std::atomic<std::uint64_t> receivers{0};
    const auto work = [&] {
        std::uint64_t found = 0;
        for (int y = next_row++; y < size.height; y = next_row++) {
            for (int x = 0; x < size.width; ++x) {
                const glm::vec3 direction(
                    compute_pixel_direction(camera, size, {x + 0.5, y + 0.5}));
                const std::optional<TracedSurface> surface =
                    find_seen_surface(state.scene, eye, direction, camera, rules);
                if (!surface) {
                    continue;
                }
                const Receiver receiver{surface->origin, surface->normal};
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

} // namespace alcove
