#include "reports/html/heat_legend.hpp"

#include <array>
#include <cmath>
#include <span>

#include <fmt/core.h>

namespace alcove {
namespace {

struct Color {
    float r, g, b;
};

// The colours and ranges of harness/run/heatmap.cpp and of the film that round_capture.cpp writes;
// error maps are those of error_map.cpp. Stated here again because a report includes no harness: a
// change there is a change here.
constexpr Color kBlack{0.0f, 0.0f, 0.0f};
constexpr Color kWhite{1.0f, 1.0f, 1.0f};
constexpr Color kLostNow{1.0f, 0.1f, 0.08f};
constexpr Color kAgeBackground{0.5f, 0.5f, 0.5f};
constexpr Color kNoHistory{0.62f, 0.62f, 0.62f};
constexpr Color kOffScreen{0.13f, 0.40f, 0.75f};
constexpr Color kDisocclusion{0.80f, 0.08f, 0.14f};
constexpr Color kNeighbourhood{0.98f, 0.62f, 0.10f};
constexpr std::array<Color, 5> kScale{
    {kBlack, {0.31f, 0.11f, 0.44f}, {0.83f, 0.34f, 0.30f}, {0.99f, 0.78f, 0.40f}, kWhite}};
constexpr std::array<Color, 2> kAgeScale{{kLostNow, kBlack}};
constexpr std::array<Color, 3> kErrorScale{
    {{0.70f, 0.06f, 0.14f}, {0.92f, 0.92f, 0.92f}, {0.08f, 0.28f, 0.72f}}};
constexpr int kAgeOfBlack = 32;
constexpr int kSamplesRange = 64;
constexpr const char* kErrorRange = "0.5";
constexpr const char* kFlickerRange = "0.1";

std::string write_color(const Color& color) {
    const auto code = [](float value) { return std::lround(255.0f * value); };
    return fmt::format("rgb({},{},{})", code(color.r), code(color.g), code(color.b));
}

std::string make_chip(const Color& color, std::string_view text) {
    return fmt::format(
        "<span class=\"heat\"><span class=\"chip\" style=\"background:{}\"></span>{}</span>",
        write_color(color), text);
}

std::string make_ramp(std::span<const Color> stops, std::string_view low, std::string_view high) {
    std::string colors;
    for (const Color& stop : stops) {
        colors += "," + write_color(stop);
    }
    return fmt::format("<span class=\"heat\">{}<span class=\"ramp\" "
                       "style=\"background:linear-gradient(to right{})\"></span>{}</span>",
                       low, colors, high);
}

} // namespace

std::string make_heat_legend(std::string_view kind, int film_frames) {
    if (kind == "error") {
        return make_ramp(kErrorScale, fmt::format("too dark by {}", kErrorRange),
                         fmt::format("too bright by {}", kErrorRange));
    }
    if (kind == "flicker" || kind == "flicker_p95") {
        return make_ramp(kScale, "0", kFlickerRange);
    }
    if (kind == "age") {
        return make_ramp(kAgeScale, "lost just now",
                         fmt::format("{} frames ago or more", kAgeOfBlack)) +
               make_chip(kWhite, "converged") + make_chip(kAgeBackground, "background");
    }
    if (kind == "cause") {
        return make_chip(kWhite, "kept") + make_chip(kNoHistory, "no history") +
               make_chip(kOffScreen, "off screen") + make_chip(kDisocclusion, "disocclusion") +
               make_chip(kNeighbourhood, "neighbourhood moved") + make_chip(kBlack, "background");
    }
    if (kind == "convergence") {
        return make_ramp(kScale, "0", "1 = converged");
    }
    if (kind == "samples") {
        return make_ramp(kScale, "0", fmt::format("{} in the frame", kSamplesRange));
    }
    if (kind == "missed") {
        return make_chip(kWhite, "stale history was kept");
    }
    if (kind == "false") {
        return make_chip(kWhite, "good history was dropped");
    }
    if (kind == "invalidations") {
        return make_ramp(kScale, "never", "every frame");
    }
    if (kind == "all_samples") {
        return make_ramp(kScale, "0", fmt::format("{}", kSamplesRange * film_frames));
    }
    return {};
}

} // namespace alcove
