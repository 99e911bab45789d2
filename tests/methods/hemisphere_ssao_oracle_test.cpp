// The shader at 512 samples against the same estimator in double precision.
#include "tests/methods/depth_image_rig.hpp"
#include "tests/methods/hemisphere_ssao_oracle.hpp"

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{48, 36};
constexpr std::uint32_t kNoiseSeed = 12345;
// Reach and distances of a few metres alike: the more of the image a sample may cross, the fewer of
// 512 samples lie within 1e-5 of a surface. At 0.5 m and 5 m every tenth pixel has one.
constexpr const char* kRadius = "2.5";

/// The nearest of a set of surfaces along each pixel's ray, with its normal.
class RayCaster {
  public:
    explicit RayCaster(const glm::dvec3& direction) : m_direction(direction) {}
    void add_plane(const glm::dvec3& point, const glm::dvec3& normal) {
        const glm::dvec3 n = glm::normalize(normal);
        add_hit(glm::dot(point, n) / glm::dot(m_direction, n), n);
    }
    void add_sphere(const glm::dvec3& center, double radius) {
        const double a = glm::dot(m_direction, m_direction);
        const double b = glm::dot(m_direction, center);
        const double root = b * b - a * (glm::dot(center, center) - radius * radius);
        if (root > 0.0) {
            const double t = (b - std::sqrt(root)) / a;
            add_hit(t, (t * m_direction - center) / radius);
        }
    }
    [[nodiscard]] double depth() const { return m_depth; }
    [[nodiscard]] const glm::dvec3& normal() const { return m_normal; }

  private:
    void add_hit(double depth, const glm::dvec3& normal) {
        if (depth > 0.0 && depth < m_depth) {
            m_depth = depth;
            m_normal = normal;
        }
    }
    glm::dvec3 m_direction;
    glm::dvec3 m_normal{0.0, 0.0, 1.0};
    double m_depth = INFINITY;
};

void write_hit(DepthImage& image, int x, int y, const RayCaster& ray) {
    image.depth.at(x, y) = static_cast<float>(ray.depth());
    for (int c = 0; c < 3; ++c) {
        image.normal.at(x, y, c) = static_cast<float>(ray.normal()[c]);
    }
}

/// A tilted wall at 3.4 m and before its left half a block that ends at 1.9 m.
DepthImage make_step() {
    DepthImage image = make_wall_image(kSize, 1.9f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = kSize.width / 2; x < kSize.width; ++x) {
            RayCaster ray(compute_pixel_direction(image.camera, kSize, {x + 0.5, y + 0.5}));
            ray.add_plane({0.0, 0.0, -3.4}, {0.25, 0.15, 1.0});
            write_hit(image, x, y, ray);
        }
    }
    return image;
}

/// A floor, two walls, none along an axis, and two spheres before them.
DepthImage make_corner_with_spheres() {
    DepthImage image = make_wall_image(kSize, 1.0f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            RayCaster ray(compute_pixel_direction(image.camera, kSize, {x + 0.5, y + 0.5}));
            ray.add_plane({0.0, -1.1, -3.0}, {0.1, 1.0, 0.15});
            ray.add_plane({-0.3, 0.0, -3.6}, {0.5, 0.1, 1.0});
            ray.add_plane({1.4, 0.0, -3.0}, {-1.0, 0.05, 0.4});
            ray.add_sphere({-0.5, -0.5, -2.7}, 0.45);
            ray.add_sphere({0.6, 0.4, -2.4}, 0.3);
            write_hit(image, x, y, ray);
        }
    }
    return image;
}

/// Blocks of 6 x 6 pixels with random depths, slopes and normals, every seventh of them background.
/// Without the slopes one sample near its switch would flag a whole block.
DepthImage make_random_blocks() {
    DepthImage image = make_wall_image(kSize, 1.0f);
    std::minstd_rand random(7);
    const auto draw = [&random] { return static_cast<double>(random() % 10007u) / 10007.0; };
    for (int row = 0; row < kSize.height; row += 6) {
        for (int column = 0; column < kSize.width; column += 6) {
            const double depth = draw() < 1.0 / 7.0 ? INFINITY : 2.0 + 2.0 * draw();
            const glm::dvec3 n =
                glm::normalize(glm::dvec3(2.0 * draw() - 1.0, 2.0 * draw() - 1.0, 0.3 + draw()));
            const glm::dvec2 slope(0.1 * draw() - 0.05, 0.1 * draw() - 0.05);
            for (int y = row; y < row + 6; ++y) {
                for (int x = column; x < column + 6; ++x) {
                    image.depth.at(x, y) =
                        static_cast<float>(depth + slope.x * (x - column) + slope.y * (y - row));
                    for (int c = 0; c < 3; ++c) {
                        image.normal.at(x, y, c) = static_cast<float>(n[c]);
                    }
                }
            }
        }
    }
    return image;
}

struct Comparison {
    int pixels = 0;
    int unflagged = 0;
    int occluded = 0; ///< visibility below 0.95
    double largest_unflagged = 0.0;
    double largest_excess = -1.0; ///< over all: deviation less the weight of flagged samples
};

class HemisphereSsaoOracleTest : public DepthImageTest {
  protected:
    Comparison compare(const DepthImage& input,
                       const std::vector<std::pair<std::string, std::string>>& forms) {
        const MethodUnit unit = hemisphere_ssao_unit();
        std::vector<std::pair<std::string, std::string>> overrides = forms;
        overrides.insert(overrides.end(),
                         {{"samples", "512"}, {"blur_radius", "0"}, {"radius", kRadius}});
        const ResolvedParameters resolved = resolve(unit, "default", overrides);
        const RigResult result = run(unit, resolved, input, kNoiseSeed);
        const std::vector<OraclePixel> oracle =
            evaluate_oracle(input.depth, result.normal, input.camera,
                            unit.parameters.bind<HemisphereSsaoParams>(resolved), kNoiseSeed);
        Comparison comparison;
        for (std::size_t i = 0; i < oracle.size(); ++i) {
            const OraclePixel& pixel = oracle[i];
            const double deviation =
                std::abs(static_cast<double>(result.visibility.values()[i]) - pixel.visibility);
            ++comparison.pixels;
            comparison.occluded += pixel.visibility < 0.95 ? 1 : 0;
            if (pixel.flagged_weight == 0.0) {
                ++comparison.unflagged;
                comparison.largest_unflagged = std::max(comparison.largest_unflagged, deviation);
            }
            comparison.largest_excess =
                std::max(comparison.largest_excess, deviation - pixel.flagged_weight);
        }
        return comparison;
    }

    void expect_equal_in_all_forms(const std::string& name, const std::string& cut,
                                   const DepthImage& input) {
        double smallest_share = 1.0;
        double largest = 0.0;
        for (const char* directions : {"uniform", "cosine"}) {
            for (const char* border : {"open", "clamp"}) {
                for (const char* rotation : {"false", "true"}) {
                    for (const char* bias : {"0", "1"}) {
                        SCOPED_TRACE(std::string(directions) + " " + border + " " + rotation + " " +
                                     bias);
                        const Comparison comparison = compare(input, {{"directions", directions},
                                                                      {"border", border},
                                                                      {"rotation", rotation},
                                                                      {"bias", bias},
                                                                      {"cut", cut}});
                        const double pixels = comparison.pixels;
                        EXPECT_GE(comparison.unflagged / pixels, 0.9);
                        // Far above the rounding of a sum of 512 floats, half of one sample's 1 /
                        // 512.
                        EXPECT_LE(comparison.largest_unflagged, 1e-4);
                        EXPECT_LE(comparison.largest_excess, 1e-4);
                        // There is something to compare.
                        EXPECT_GE(comparison.occluded / pixels, 0.05);
                        smallest_share = std::min(smallest_share, comparison.unflagged / pixels);
                        largest = std::max(largest, comparison.largest_unflagged);
                    }
                }
            }
        }
        RecordProperty(name + "_smallest_unflagged_share", std::to_string(smallest_share));
        RecordProperty(name + "_largest_unflagged_deviation", std::to_string(largest));
    }
};

TEST_F(HemisphereSsaoOracleTest, AStepMatchesTheDoubleEvaluation) {
    expect_equal_in_all_forms("step", "1", make_step());
}

TEST_F(HemisphereSsaoOracleTest, ACornerWithSpheresMatchesTheDoubleEvaluation) {
    expect_equal_in_all_forms("corner", "2", make_corner_with_spheres());
}

TEST_F(HemisphereSsaoOracleTest, RandomBlocksWithBackgroundMatchTheDoubleEvaluation) {
    expect_equal_in_all_forms("blocks", "1.2", make_random_blocks());
}

} // namespace
} // namespace alcove
