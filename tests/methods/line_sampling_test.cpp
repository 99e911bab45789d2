// line_sampling against numeric integration of its chords in double precision.
#include "methods/line_sampling/line_sampling.hpp"
#include "tests/methods/depth_scenes.hpp"
#include "tests/methods/estimator_oracle.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct Chord {
    double possible = 0.0;
    double filled = 0.0;
    bool is_outlier = false;
    bool is_doubtful = false;
};

/// Steps along the view ray and asks of each point what the definition asks: is it in the ball,
/// above the plane, behind the depth buffer?
Chord integrate_chord(const OracleImage& image, const OracleImage::Receiver& receiver,
                      const OracleImage::Place& place, const LineSamplingParams& params) {
    constexpr int kSteps = 4000;
    const glm::dvec3 ray = image.get_ray(place.pixel);
    const double surface = place.is_inside ? image.get_depth(place.pixel) : INFINITY;
    const double first = receiver.depth - 1.5 * params.radius;
    const double length = 3.0 * params.radius / kSteps;
    Chord chord;
    double nearest = INFINITY;
    int steps_in_ball = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double depth = first + (i + 0.5) * length;
        const glm::dvec3 from_center = depth * ray - receiver.position;
        const bool is_in_ball = glm::dot(from_center, from_center) < params.radius * params.radius;
        if (!is_in_ball) {
            continue;
        }
        nearest = std::min(nearest, depth);
        ++steps_in_ball;
        if (params.domain == LineDomain::hemisphere &&
            glm::dot(from_center, receiver.normal) <= 0.0) {
            continue;
        }
        // A slice at this depth is as much larger than the disc as it lies farther.
        const double volume = length * depth * depth / (receiver.depth * receiver.depth);
        chord.possible += volume;
        chord.filled += depth > surface ? volume : 0.0;
    }
    chord.is_outlier = surface < nearest;
    chord.is_doubtful = steps_in_ball < 10 || std::abs(surface - nearest) < 2.0 * length;
    return chord;
}

OracleAnswer evaluate(const OracleImage& image, const OracleImage::Receiver& receiver,
                      const LineSamplingParams& params) {
    OracleAnswer answer;
    // The shader counts nothing below a normal that is turned away from the viewer.
    answer.is_doubtful = glm::dot(receiver.normal, receiver.position) > -1e-3;
    std::vector<Chord> chords;
    for (const glm::vec4& point : make_paired_disc_kernel(params.samples)) {
        const glm::dvec3 q = receiver.position + params.radius * glm::dvec3(point.x, point.y, 0.0);
        const OracleImage::Place place = image.find_place(q);
        answer.is_doubtful = answer.is_doubtful || place.is_near_edge;
        chords.push_back(integrate_chord(image, receiver, place, params));
        answer.is_doubtful = answer.is_doubtful || chords.back().is_doubtful;
    }
    double filled = 0.0;
    double possible = 0.0;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const Chord* chord = &chords[i];
        if (params.outliers == LineOutliers::paired && chord->is_outlier) {
            const std::size_t partner = i ^ 1u;
            chord = partner < chords.size() ? &chords[partner] : chord;
        }
        if (params.outliers == LineOutliers::solid || !chord->is_outlier) {
            filled += chord->filled;
            possible += chord->possible;
        }
    }
    const double obscurance = possible > 0.0 ? filled / possible : 0.0;
    // Too little of the ball is left to integrate by steps.
    answer.is_doubtful = answer.is_doubtful || possible < 0.5 * params.radius;
    answer.visibility = std::clamp(1.0 - obscurance, 0.0, 1.0);
    return answer;
}

class LineSamplingTest : public DepthImageTest {
  protected:
    void expect_equal(const std::vector<std::pair<std::string, std::string>>& settings,
                      const DepthImage& input) {
        const MethodUnit unit = line_sampling_unit();
        std::vector<std::pair<std::string, std::string>> all{
            {"radius", "1"}, {"rotation", "off"}, {"samples", "8"}};
        all.insert(all.end(), settings.begin(), settings.end());
        const ResolvedParameters resolved = resolve(unit, "unfiltered", all);
        const auto params = unit.parameters.bind<LineSamplingParams>(resolved);
        // Steps of 1/4000 of 3 m at both ends of each chord, against lengths of half a metre.
        expect_oracle(
            input, run(unit, resolved, input),
            [&params](const OracleImage& image, const OracleImage::Receiver& receiver) {
                return evaluate(image, receiver, params);
            },
            6e-3);
    }
};

TEST_F(LineSamplingTest, EqualsNumericIntegrationInTheHalfBall) {
    for (const char* outliers : {"solid", "skipped", "paired"}) {
        SCOPED_TRACE(outliers);
        expect_equal({{"outliers", outliers}}, make_corner_with_spheres_image());
    }
}

TEST_F(LineSamplingTest, EqualsNumericIntegrationInTheWholeBall) {
    expect_equal({{"domain", "ball"}, {"outliers", "paired"}}, make_step_image());
}

TEST_F(LineSamplingTest, APlaneFillsHalfOfTheBallAndNothingOfItsUpperHalf) {
    const MethodUnit unit = line_sampling_unit();
    const DepthImage wall = make_wall_image({64, 48}, 3.0f);
    for (const auto& [domain, expected] : {std::pair{"hemisphere", 1.0f}, {"ball", 0.5f}}) {
        const RigResult result =
            run(unit, resolve(unit, "unfiltered", {{"domain", domain}, {"samples", "64"}}), wall);
        // 64 lines of one Halton set.
        EXPECT_NEAR(result.visibility.at(32, 24), expected, 0.01f) << domain;
    }
}

} // namespace
} // namespace alcove
