#include "tests/methods/estimator_oracle.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {

OracleImage::OracleImage(const DepthImage& input, const Image& normal)
    : m_depth(&input.depth), m_normal(&normal), m_size(input.depth.width(), input.depth.height()),
      m_tangents(compute_tangents(input.camera, input.depth.size())) {}

double OracleImage::get_depth(glm::ivec2 pixel) const {
    return static_cast<double>(m_depth->at(pixel.x, m_size.y - 1 - pixel.y));
}

glm::dvec3 OracleImage::get_ray(glm::ivec2 pixel) const {
    const glm::dvec2 uv = (glm::dvec2(pixel) + 0.5) / glm::dvec2(m_size);
    return {(2.0 * uv - 1.0) * m_tangents, -1.0};
}

OracleImage::Receiver OracleImage::get_receiver(int x, int y) const {
    const int row = m_size.y - 1 - y;
    Receiver receiver;
    receiver.pixel = {x, y};
    receiver.depth = get_depth(receiver.pixel);
    receiver.position = receiver.depth * get_ray(receiver.pixel);
    receiver.normal = glm::normalize(
        glm::dvec3(m_normal->at(x, row, 0), m_normal->at(x, row, 1), m_normal->at(x, row, 2)));
    return receiver;
}

OracleImage::Place OracleImage::find_place(const glm::dvec3& point) const {
    const glm::dvec2 uv = 0.5 + 0.5 * glm::dvec2(point) / -point.z / m_tangents;
    return find_place(uv * glm::dvec2(m_size));
}

OracleImage::Place OracleImage::find_place(const glm::dvec2& place) const {
    // Floats of a place of up to 64 pixels after a projection: a few 1e-5 of a pixel.
    constexpr double kMargin = 1e-4;
    Place found;
    found.pixel = glm::ivec2(glm::floor(place));
    found.is_inside = glm::all(glm::greaterThanEqual(found.pixel, glm::ivec2(0))) &&
                      glm::all(glm::lessThan(found.pixel, m_size));
    const glm::dvec2 off = glm::abs(place - glm::round(place));
    found.is_near_edge = std::min(off.x, off.y) < kMargin;
    return found;
}

void expect_oracle(const DepthImage& input, const RigResult& result, const PixelOracle& oracle,
                   double tolerance) {
    const OracleImage image(input, result.normal);
    OracleComparison comparison;
    for (int y = 0; y < image.size().y; ++y) {
        for (int x = 0; x < image.size().x; ++x) {
            const auto value = static_cast<double>(result.visibility.at(x, image.size().y - 1 - y));
            const OracleImage::Receiver receiver = image.get_receiver(x, y);
            if (std::isinf(receiver.depth)) {
                ASSERT_EQ(value, 1.0);
                continue;
            }
            ++comparison.pixels;
            const OracleAnswer answer = oracle(image, receiver);
            if (answer.is_doubtful) {
                continue;
            }
            ++comparison.compared;
            comparison.occluded += answer.visibility < 0.95 ? 1 : 0;
            const double deviation = std::abs(value - answer.visibility);
            EXPECT_LE(deviation, tolerance)
                << "pixel " << x << ", " << y << " from below: " << value << " against "
                << answer.visibility;
            comparison.largest_deviation = std::max(comparison.largest_deviation, deviation);
        }
    }
    EXPECT_GE(comparison.compared, 0.7 * comparison.pixels);
    EXPECT_GE(comparison.occluded, 0.04 * comparison.pixels);
    testing::Test::RecordProperty("largest_deviation",
                                  std::to_string(comparison.largest_deviation));
}

} // namespace alcove
