#include "core/base/environment.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr int kDirectionsAcross = 8; ///< of a texel

glm::dvec2 fold(const glm::dvec2& square) {
    return {(1.0 - std::abs(square.y)) * (square.x >= 0.0 ? 1.0 : -1.0),
            (1.0 - std::abs(square.x)) * (square.y >= 0.0 ? 1.0 : -1.0)};
}

bool is_light(const glm::vec3& value) {
    return value.x >= 0.0f && value.y >= 0.0f && value.z >= 0.0f && std::isfinite(value.x) &&
           std::isfinite(value.y) && std::isfinite(value.z);
}

void set_pixel(Image& image, int x, int y, const glm::vec3& value) {
    for (int channel = 0; channel < 3; ++channel) {
        image.at(x, y, channel) = value[channel];
    }
}

/// Directions that stand for the texels of an octahedral map, and how much of the sphere each
/// covers: the area of the two triangles of its corners, which sum to 4 pi within 1e-4.
struct Texel {
    glm::dvec3 direction;
    double solid_angle;
    glm::dvec3 radiance;
};

double compute_solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    // This work is based on: Van Oosterom, Strackee. The solid angle of a plane triangle. 1983.
    return 2.0 * std::abs(std::atan2(glm::dot(a, glm::cross(b, c)),
                                     1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a)));
}

std::vector<Texel> list_texels(const Image& map) {
    std::vector<Texel> texels;
    texels.reserve(map.size().pixel_count());
    const double side = map.width();
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const auto at = [&](double dx, double dy) {
                return decode_octahedral({(x + dx) / side, (y + dy) / side});
            };
            const double solid_angle = compute_solid_angle(at(0, 0), at(1, 0), at(1, 1)) +
                                       compute_solid_angle(at(0, 0), at(1, 1), at(0, 1));
            texels.push_back(
                {at(0.5, 0.5), solid_angle, {map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)}});
        }
    }
    return texels;
}

Image prefilter(const Image& map) {
    const std::vector<Texel> texels = list_texels(map);
    Image mean({Environment::kPrefilteredSide, Environment::kPrefilteredSide}, 3);
    for (int y = 0; y < mean.height(); ++y) {
        for (int x = 0; x < mean.width(); ++x) {
            const glm::dvec3 normal =
                decode_octahedral({(x + 0.5) / mean.width(), (y + 0.5) / mean.height()});
            glm::dvec3 sum(0.0);
            double weights = 0.0;
            for (const Texel& texel : texels) {
                const double weight =
                    std::max(glm::dot(normal, texel.direction), 0.0) * texel.solid_angle;
                sum += weight * texel.radiance;
                weights += weight;
            }
            set_pixel(mean, x, y, glm::vec3(sum / weights));
        }
    }
    return mean;
}

/// Box means of a map that is finer than the directions which a texel is sampled at, so that no
/// small light falls between them.
Image shrink(const Image& image) {
    constexpr int kMostColumns = 4 * Environment::kSide * kDirectionsAcross / 2;
    const int factor = (image.width() + kMostColumns - 1) / kMostColumns;
    Image means({(image.width() + factor - 1) / factor, (image.height() + factor - 1) / factor}, 3);
    for (int y = 0; y < means.height(); ++y) {
        for (int x = 0; x < means.width(); ++x) {
            glm::dvec3 sum(0.0);
            int count = 0;
            for (int v = factor * y; v < std::min(factor * (y + 1), image.height()); ++v) {
                for (int u = factor * x; u < std::min(factor * (x + 1), image.width()); ++u) {
                    sum += glm::dvec3(image.at(u, v, 0), image.at(u, v, 1), image.at(u, v, 2));
                    ++count;
                }
            }
            set_pixel(means, x, y, glm::vec3(sum / double(count)));
        }
    }
    return means;
}

} // namespace

glm::dvec2 encode_octahedral(const glm::dvec3& direction) {
    const double length = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    const glm::dvec2 upper(direction.x / length, direction.z / length);
    return 0.5 + 0.5 * (direction.y >= 0.0 ? upper : fold(upper));
}

glm::dvec3 decode_octahedral(const glm::dvec2& coordinates) {
    glm::dvec2 square = 2.0 * coordinates - 1.0;
    const double height = 1.0 - std::abs(square.x) - std::abs(square.y);
    if (height < 0.0) {
        square = fold(square);
    }
    return glm::normalize(glm::dvec3(square.x, height, square.y));
}

glm::ivec2 wrap_octahedral(const glm::ivec2& texel, int side) {
    glm::ivec2 wrapped = texel;
    if (texel.x < 0 || texel.x >= side) {
        wrapped = {texel.x < 0 ? 0 : side - 1, side - 1 - wrapped.y};
    }
    if (wrapped.y < 0 || wrapped.y >= side) {
        wrapped = {side - 1 - wrapped.x, wrapped.y < 0 ? 0 : side - 1};
    }
    return wrapped;
}

Environment::Environment(const std::function<glm::vec3(const glm::dvec3&)>& radiance,
                         std::string_view where)
    : m_radiance({kSide, kSide}, 3) {
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            glm::vec3 sum(0.0f);
            for (int i = 0; i < kDirectionsAcross * kDirectionsAcross; ++i) {
                const int column = i % kDirectionsAcross;
                const int row = i / kDirectionsAcross;
                const double dx = (column + 0.5) / kDirectionsAcross;
                const double dy = (row + 0.5) / kDirectionsAcross;
                const glm::vec3 value =
                    radiance(decode_octahedral({(x + dx) / kSide, (y + dy) / kSide}));
                if (!is_light(value)) {
                    throw InputError(where, "holds a value that is no light",
                                     format_number(value.x) + " " + format_number(value.y) + " " +
                                         format_number(value.z),
                                     "finite numbers that are not negative");
                }
                sum += value;
            }
            set_pixel(m_radiance, x, y, sum / float(kDirectionsAcross * kDirectionsAcross));
        }
    }
    m_prefiltered = prefilter(m_radiance);
    m_hash = to_hex(hash_image(m_radiance));
}

Environment Environment::from_equirectangular(const Image& image, std::string_view where) {
    if (std::abs(image.width() - 2 * image.height()) > 1 || image.channels() < 3) {
        throw InputError(where, "is no equirectangular map",
                         std::to_string(image.width()) + "x" + std::to_string(image.height()) +
                             " with " + std::to_string(image.channels()) + " channels",
                         "twice as wide as high, with three channels or more");
    }
    const Image means = shrink(image);
    const auto look = [&means](const glm::dvec3& direction) {
        const double longitude = std::atan2(direction.x, -direction.z);
        const double latitude = std::acos(std::clamp(direction.y, -1.0, 1.0));
        const double u = 0.5 + longitude * 0.5 * std::numbers::inv_pi;
        const double v = latitude * std::numbers::inv_pi;
        const int x = std::clamp(static_cast<int>(u * means.width()), 0, means.width() - 1);
        const int y = std::clamp(static_cast<int>(v * means.height()), 0, means.height() - 1);
        return glm::vec3(means.at(x, y, 0), means.at(x, y, 1), means.at(x, y, 2));
    };
    return Environment(look, where);
}

glm::vec3 Environment::interpolate(const glm::dvec3& direction) const {
    const glm::dvec2 place = encode_octahedral(direction) * double(kSide) - 0.5;
    const glm::ivec2 corner(glm::floor(place));
    const glm::dvec2 share = glm::fract(place);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 step(i % 2, i / 2);
        const glm::ivec2 texel = wrap_octahedral(corner + step, kSide);
        const glm::dvec2 weight = glm::mix(1.0 - share, share, glm::dvec2(step));
        sum += weight.x * weight.y *
               glm::dvec3(m_radiance.at(texel.x, texel.y, 0), m_radiance.at(texel.x, texel.y, 1),
                          m_radiance.at(texel.x, texel.y, 2));
    }
    return glm::vec3(sum);
}

glm::vec3 Environment::look_up(const glm::dvec3& direction) const {
    const glm::dvec2 coordinates = encode_octahedral(direction);
    const int x = std::min(static_cast<int>(coordinates.x * kSide), kSide - 1);
    const int y = std::min(static_cast<int>(coordinates.y * kSide), kSide - 1);
    return {m_radiance.at(x, y, 0), m_radiance.at(x, y, 1), m_radiance.at(x, y, 2)};
}

} // namespace alcove
