#include "metrics/halo_width/halo_width.hpp"

#include "metrics/common/pooled_region.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace alcove {
namespace {

constexpr int kSmallestSide = 2;
/// How far walks go, in pixels.
constexpr int kReach = 16;
/// Of the nearer depth: a larger difference between neighbours is an edge.
constexpr float kEdge = 0.1f;
/// In values: less error than this is no halo.
constexpr double kThreshold = 0.01;

bool is_edge(float a, float b) {
    return std::abs(a - b) > kEdge * std::min(a, b);
}

/// The mean error by distance from depth edges on their far side.
struct Profile {
    std::array<double, kReach> sums{};
    std::array<std::size_t, kReach> counts{};
    std::size_t edges = 0;   ///< with a counted pixel
    std::size_t samples = 0; ///< of all walks, counted or not
    std::size_t counted = 0;
    [[nodiscard]] double mean(std::size_t i) const {
        return counts.at(i) == 0 ? 0.0 : sums.at(i) / static_cast<double>(counts.at(i));
    }
};

/// Walks from the far pixel (x, y) of an edge straight away from it, as far as the surface goes on.
void walk(const MetricInput& input, const PooledRegion& region, int x, int y, int dx, int dy,
          Profile& profile, Image& map) {
    const Image& depth = *input.depth;
    bool is_counted = false;
    for (std::size_t i = 0; i < profile.sums.size(); ++i, x += dx, y += dy) {
        const bool is_inside = x >= 0 && y >= 0 && x < depth.width() && y < depth.height();
        if (!is_inside || (i > 0 && is_edge(depth.at(x - dx, y - dy), depth.at(x, y)))) {
            break;
        }
        ++profile.samples;
        const float error = input.test.at(x, y) - input.reference.at(x, y);
        map.at(x, y) = std::abs(error);
        if (region.is_counted(x, y)) {
            ++profile.counted;
            profile.sums.at(i) += static_cast<double>(error);
            ++profile.counts.at(i);
            is_counted = true;
        }
    }
    profile.edges += is_counted ? 1 : 0;
}

/// Between (x, y) and its neighbour along (dx, dy), both inside; the background is no surface that
/// a halo could lie on.
void follow_edge(const MetricInput& input, const PooledRegion& region, int x, int y, int dx, int dy,
                 Profile& profile, Image& map) {
    const float here = input.depth->at(x, y);
    const float there = input.depth->at(x + dx, y + dy);
    if (!is_edge(here, there) || std::isinf(std::max(here, there))) {
        return;
    }
    if (there > here) {
        walk(input, region, x + dx, y + dy, dx, dy, profile, map);
    } else {
        walk(input, region, x, y, -dx, -dy, profile, map);
    }
}

Profile collect_profile(const MetricInput& input, const PooledRegion& region, Image& map) {
    Profile profile;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (x + 1 < map.width()) {
                follow_edge(input, region, x, y, 1, 0, profile, map);
            }
            if (y + 1 < map.height()) {
                follow_edge(input, region, x, y, 0, 1, profile, map);
            }
        }
    }
    return profile;
}

/// Where the profile, joined by straight lines between pixel centres, falls to the threshold, in
/// pixels from the edge; and the mean error up to there.
struct Halo {
    double width = 0.0;
    double error = 0.0;
};

Halo measure_halo(const Profile& profile) {
    const double sign = profile.mean(0) < 0.0 ? -1.0 : 1.0;
    Halo halo;
    double sum = 0.0;
    for (std::size_t i = 0; i < profile.sums.size(); ++i) {
        const double here = sign * profile.mean(i);
        if (here <= kThreshold) {
            return halo;
        }
        sum += profile.mean(i);
        halo.error = sum / static_cast<double>(i + 1);
        const double next = i + 1 < profile.sums.size() ? sign * profile.mean(i + 1) : 0.0;
        halo.width = static_cast<double>(i) + 0.5;
        if (i + 1 == profile.sums.size()) {
            halo.width = kReach;
        } else if (next <= kThreshold) {
            halo.width += (here - kThreshold) / (here - next);
        }
    }
    return halo;
}

class HaloWidth final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "halo_width", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        MetricResult result;
        const PooledRegion region(input.mask, input.test.size());
        region.report(result);
        if (input.depth == nullptr) {
            result.undefined_reason = "no eye depth is given, so that depth edges are not known";
            return result;
        }
        Image map(input.test.size(), 1);
        const Profile profile = collect_profile(input, region, map);
        if (input.mask != nullptr) {
            result.counted_pixels = profile.counted;
            result.ignored_pixels = profile.samples - profile.counted;
        }
        if (profile.edges == 0) {
            result.undefined_reason = profile.samples == 0
                                          ? "no depth edge with a surface behind it"
                                          : "the mask counts none of the pixels behind depth edges";
            return result;
        }
        const Halo halo = measure_halo(profile);
        result.value = halo.width;
        result.extras = {{"halo_error", halo.error}, {"edges", static_cast<double>(profile.edges)}};
        result.map = std::move(map);
        return result;
    }
};

/// The upper half is two metres away, the lower half four.
Image make_plates(ImageSize size) {
    Image depth(size, 1, 4.0f);
    for (int y = 0; y < size.height / 2; ++y) {
        for (int x = 0; x < size.width; ++x) {
            depth.at(x, y) = 2.0f;
        }
    }
    return depth;
}

/// Darkened below the plates' edge by 0.5 there, less with distance, 0 from `reach` pixels on.
Image darken(const Image& reference, double reach) {
    Image image = reference;
    for (int y = image.height() / 2; y < image.height(); ++y) {
        const double distance = y - image.height() / 2 + 0.5;
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y) -= static_cast<float>(0.5 * std::max(0.0, 1.0 - distance / reach));
        }
    }
    return image;
}

constexpr ImageSize kCheckSize{64, 64};

Image make_reference(ImageSize size) {
    return Image(size, 1, 0.75f);
}

} // namespace

MetricUnit halo_width_unit() {
    MetricUnit unit;
    unit.name = "halo_width";
    unit.title = "Halo width";
    unit.unit = "px";
    unit.definition =
        "Ours. A depth edge lies between neighbours whose eye depths differ by more than 10 % of "
        "the nearer. On its far side, where that is a surface, the error test - reference is "
        "followed straight away from the edge for up to 16 pixels, until the next depth edge, and "
        "averaged over all edges by distance. The value is the distance from the edge at which "
        "this profile, joined by straight lines between pixel centres, falls to 0.01 in its first "
        "value's sign; 0 where it begins below, 16 where it does not end. halo_error: its mean up "
        "to there, with its sign; edges: how many.";
    unit.blind_to = "halos on the near side, halos of both signs that cancel over the edges, all "
                    "that lies further than 16 pixels from an edge, and whether the error has to "
                    "do with the edge: a constant bias gives 16.";
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = kSmallestSide;
    unit.maximum = kReach;
    unit.best = 0.0;
    unit.parameters = describe_parameters("halo_width", {});
    unit.needs_depth = true;
    unit.canary = MetricCanary{make_reference,
                               [](const Image& reference, float amount) {
                                   return darken(reference, 40.0 * static_cast<double>(amount));
                               },
                               make_plates};
    unit.checks = {
        {"dark halo of 10 pixels",
         [] { return darken(make_reference(kCheckSize), 10.0); },
         [] { return make_reference(kCheckSize); },
         9.0 + 0.5 + (0.025 - 0.01) / 0.025,
         1e-5,
         "by hand: 0.5 (1 - d / 10) is 0.025 at the tenth pixel and 0 at the next",
         {},
         [] { return make_plates(kCheckSize); }},
        {"no halo",
         [] { return make_reference(kCheckSize); },
         [] { return make_reference(kCheckSize); },
         0.0,
         1e-12,
         "by definition",
         {},
         [] { return make_plates(kCheckSize); }},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<HaloWidth>(); };
    return unit;
}

} // namespace alcove
