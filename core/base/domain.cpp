#include "core/base/domain.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace alcove {
namespace {

constexpr std::array kDomains{"srgb", "linear", "visibility", "view"};
constexpr std::array kMetricDomains{"values", "view", "linear", "codes"};

template <class Function>
Image map_values(const Image& image, Function function) {
    Image result = image;
    for (float& value : result.values()) {
        value = function(value);
    }
    return result;
}

} // namespace

std::string_view to_text(Domain domain) {
    return kDomains.at(static_cast<std::size_t>(domain));
}

Domain parse_domain(std::string_view text) {
    const std::vector<std::string> names(kDomains.begin(), kDomains.end());
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) {
        throw InputError("--domain", "unknown domain", text, describe_choices(text, names));
    }
    return static_cast<Domain>(found - names.begin());
}

std::string_view to_text(MetricDomain domain) {
    return kMetricDomains.at(static_cast<std::size_t>(domain));
}

MetricDomain parse_metric_domain(std::string_view text, std::string_view where) {
    const std::vector<std::string> names(kMetricDomains.begin(), kMetricDomains.end());
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) {
        throw InputError(where, "unknown domain of a metric", text, describe_choices(text, names));
    }
    return static_cast<MetricDomain>(found - names.begin());
}

float encode_srgb(float linear) {
    const float value = std::clamp(linear, 0.0f, 1.0f);
    return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
}

float decode_srgb(float code) {
    const float value = std::clamp(code, 0.0f, 1.0f);
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

Image encode_view(const Image& linear) {
    return map_values(linear, encode_srgb);
}

Image convert_for_metric(const Image& image, Domain domain, MetricDomain wanted) {
    const bool is_encoded = domain == Domain::srgb || domain == Domain::view;
    switch (wanted) {
    case MetricDomain::values:
        return domain == Domain::view ? map_values(image, decode_srgb) : image;
    case MetricDomain::view:
        return is_encoded ? image : encode_view(image);
    case MetricDomain::linear:
        return is_encoded ? map_values(image, decode_srgb) : image;
    case MetricDomain::codes:
        break;
    }
    return image;
}

Image compute_luma(const Image& image) {
    Image luma(image.size(), 1);
    const auto channels = static_cast<std::size_t>(image.channels());
    const std::span<const float> in = image.values();
    const std::span<float> out = luma.values();
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float* pixel = in.data() + i * channels;
        out[i] =
            channels < 3 ? pixel[0] : 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
    }
    return luma;
}

} // namespace alcove
