#include "tests/benchmark/recorded_bundles.hpp"

#include "methods/common/sobol.hpp"
#include "tests/benchmark/bare_scene.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <embree3/rtcore.h>

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

} // namespace

struct RecordedBundles::State {
    explicit State(const PosedGeometry& geometry) : scene(geometry) {}

    BareScene scene;
    std::vector<BareReceiver> receivers;
    std::vector<Directions> bundles; ///< as many a receiver as both halves have
    std::size_t bundles_per_receiver = 0;
    float radius = 0.0f;
};

RecordedBundles::RecordedBundles(const PosedGeometry& geometry, const Camera& camera,
                                 ImageSize size, double radius_m, int rays_per_half)
    : m_state(std::make_unique<State>(geometry)) {
    State& state = *m_state;
    state.radius = static_cast<float>(radius_m);
    state.receivers = state.scene.find_receivers(camera, size, geometry.origin);
    state.bundles_per_receiver = 2 * static_cast<std::size_t>(rays_per_half) / kBundle;
    state.bundles.reserve(state.receivers.size() * state.bundles_per_receiver);
    for (std::size_t r = 0; r < state.receivers.size(); ++r) {
        const glm::mat3 frame = make_bare_frame(state.receivers[r].normal);
        const std::size_t per_half = state.bundles_per_receiver / 2;
        for (std::size_t b = 0; b < state.bundles_per_receiver; ++b) {
            const auto seed = static_cast<std::uint32_t>(2 * r + b / per_half);
            Directions& bundle = state.bundles.emplace_back();
            for (std::size_t lane = 0; lane < kBundle; ++lane) {
                const glm::vec3 d = make_bare_direction(
                    frame, compute_scrambled_sobol(
                               static_cast<std::uint32_t>(b % per_half * kBundle + lane), seed));
                bundle.x[lane] = d.x;
                bundle.y[lane] = d.y;
                bundle.z[lane] = d.z;
            }
        }
    }
}

RecordedBundles::~RecordedBundles() = default;

std::size_t RecordedBundles::receiver_count() const {
    return m_state->receivers.size();
}

std::uint64_t RecordedBundles::ray_count() const {
    return m_state->bundles.size() * kBundle;
}

void RecordedBundles::run() const {
    // Receivers a thread takes at a time: a row of the default image.
    constexpr std::size_t kBlock = 384;
    const State& state = *m_state;
    run_blocks(state.receivers.size(), kBlock, [&](std::size_t first, std::size_t end) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        alignas(64) std::array<int, kBundle> valid;
        valid.fill(-1);
        alignas(64) RTCRay16 rays{};
        std::fill_n(rays.mask, kBundle, 0xffffffffu);
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
                rtcOccluded16(valid.data(), state.scene.tree(), &context, &rays);
            }
        }
    });
}

} // namespace alcove
