// What follows from the blog's numbers alone, in whole numbers and in double, with the parameters
// that the cells ran with.
#include "core/base/text.hpp"
#include "reports/papers/artifacts/artifacts_parts.hpp"
#include "reports/papers/estimates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/core.h>

namespace alcove {
namespace {

using Pair = std::pair<int, int>;

constexpr const char* kLiteral = "decoupled, one number";
/// Vectors that the blog draws, and the bins in which angles are counted.
constexpr int kDrawnVectors = 8;

/// "Know your SSAO artifacts": Direction[((j + q) 1) % 11] Scale[((j + q) 7) % 11].
struct Indexing {
    int size = 0;
    int direction_multiplier = 0;
    int length_multiplier = 0;
    int offsets = 0;

    [[nodiscard]] Pair find(int sample, int q) const {
        return {(sample + q) * direction_multiplier % size,
                (sample + q) * length_multiplier % size};
    }
    [[nodiscard]] std::vector<Pair> list(int samples, int q) const {
        std::vector<Pair> pairs;
        for (int sample = 0; sample < samples; ++sample) {
            pairs.push_back(find(sample, q));
        }
        return pairs;
    }
    [[nodiscard]] std::size_t count_pairs(int samples) const {
        std::set<Pair> pairs;
        for (int q = 0; q < offsets; ++q) {
            for (const Pair& pair : list(samples, q)) {
                pairs.insert(pair);
            }
        }
        return pairs.size();
    }
};

int read_number(const Evidence& evidence, const char* parameter) {
    return static_cast<int>(
        parse_number(evidence.find_parameter({"corner", 0, kLiteral}, parameter), parameter));
}

Indexing read_indexing(const Evidence& evidence) {
    return {read_number(evidence, "kernel_size"), read_number(evidence, "direction_multiplier"),
            read_number(evidence, "length_multiplier"), read_number(evidence, "offsets")};
}

std::string describe(const std::vector<Pair>& pairs) {
    std::string text;
    for (const auto& [direction, length] : pairs) {
        text += fmt::format("{}({},{})", text.empty() ? "" : " ", direction, length);
    }
    return text;
}

Finding judge_equal(bool holds, const std::string& tested, double measured,
                    const std::string& why) {
    return {holds ? Outcome::holds : Outcome::fails, tested, make_single(measured), why};
}

/// Angles about a normal that leans `tilt` radians, by which Gram-Schmidt turns evenly spaced
/// vectors (cos a, sin a, 0): their projections onto the tangent plane, whose axes are x and the
/// steepest line, are (cos a, sin a cos tilt).
std::vector<double> list_angles(int count, double tilt) {
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) {
        const double a = 2.0 * std::numbers::pi * i / count;
        const double angle = std::atan2(std::sin(a) * std::cos(tilt), std::cos(a));
        angles.push_back(angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle);
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

/// Largest over smallest gap between neighbours; 1 for even spacing.
double measure_gaps(double tilt) {
    std::vector<double> angles = list_angles(kDrawnVectors, tilt);
    angles.push_back(angles.front() + 2.0 * std::numbers::pi);
    double smallest = 10.0;
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        smallest = std::min(smallest, angles[i + 1] - angles[i]);
        largest = std::max(largest, angles[i + 1] - angles[i]);
    }
    return largest / smallest;
}

double to_radians(int degrees) {
    return degrees * std::numbers::pi / 180.0;
}

void judge_indices(const Evidence& evidence, Judge& judge) {
    const Indexing indexing = read_indexing(evidence);
    const int samples = read_number(evidence, "samples");
    const bool is_subset = samples == 4 || samples == 5;
    judge.set("BLOG-017",
              judge_equal(indexing.size == 11 && is_subset, "a set of 11 of which 4 or 5 are used",
                          samples, std::string("parameters of ") + kLiteral));
    const std::size_t reached = indexing.count_pairs(samples);
    judge.set("BLOG-018",
              judge_equal(reached == 11, "pairs that the printed form reaches: 11 of 121",
                          static_cast<double>(reached),
                          "counted; a random number each reaches all, which "
                          "methods_crytek_ssao_kernel_test counts"));
    std::vector<int> uses(static_cast<std::size_t>(indexing.size), 0);
    for (int q = 0; q < indexing.offsets; ++q) {
        ++uses.at(static_cast<std::size_t>(q % indexing.size));
    }
    const auto [least, most] = std::minmax_element(uses.begin(), uses.end());
    judge.set("BLOG-019", judge_equal(indexing.offsets == 18 && *most != *least,
                                      "18 values modulo 11 are not uniform: most over fewest uses",
                                      static_cast<double>(*most) / *least, "counted"));
    judge.set("BLOG-020",
              judge_equal(indexing.direction_multiplier == 1 && indexing.length_multiplier == 7,
                          "multipliers 1 and 7", indexing.length_multiplier,
                          std::string("parameters of ") + kLiteral));
    const auto judge_vector = [&](const char* id, int q, const std::string& printed) {
        const std::string found = describe(indexing.list(4, q));
        judge.set(id, judge_equal(found == printed, fmt::format("q = {}: {}", q, printed), q,
                                  "computed: " + found));
    };
    judge_vector("BLOG-021", 12, "(1,7) (2,3) (3,10) (4,6)");
    judge_vector("BLOG-022", 5, "(5,2) (6,9) (7,5) (8,1)");
}

} // namespace

void judge_artifact_formulas(const Evidence& evidence, Judge& judge) {
    judge_indices(evidence, judge);
    const double least = parse_number(
        evidence.find_parameter({"depth", 0, "least cosine 0.15"}, "min_cosine"), "min_cosine");
    judge.set("BLOG-006",
              {judge_within(make_single(1.0 - least), 0.8499, 0.8501),
               "of uniform directions a share of 0.85 is accepted", make_single(1.0 - least),
               "1 - the least cosine that ran; methods_crytek_ssao_kernel_test counts "
               "0.85 of 512 points about three normals"});
    judge.set("BLOG-012", {judge_within(make_single(measure_gaps(0.0)), 0.999, 1.001),
                           "8 vectors in the plane z = 0: evenly spaced about a normal that faces "
                           "the viewer (largest over smallest gap)",
                           make_single(measure_gaps(0.0)), "computed"});
}

double measure_angle_chi_square(double tilt) {
    constexpr int kVectors = 4096;
    std::array<double, 16> counts{};
    constexpr double kExpected = kVectors / 16.0;
    for (const double angle : list_angles(kVectors, tilt)) {
        // A vector on the border between two bins belongs to the upper one.
        const double bin = angle / (2.0 * std::numbers::pi) * 16.0 + 1e-9;
        ++counts.at(static_cast<std::size_t>(bin) % 16);
    }
    double chi_square = 0.0;
    for (const double count : counts) {
        chi_square += (count - kExpected) * (count - kExpected) / kExpected;
    }
    return chi_square;
}

PaperTable make_angles_table() {
    PaperTable table{"angles",
                     "4.4: how Gram-Schmidt spreads evenly spaced vectors about a tilted normal",
                     "computed; a fixed frame turned by a uniform angle has 1 and 0 at every tilt",
                     {"tilt in degrees", "8 vectors: largest over smallest gap",
                      "4096 vectors in 16 bins: chi square (15 degrees of freedom)"},
                     {}};
    for (const int degrees : {0, 30, 45, 60, 75, 80}) {
        table.rows.push_back(
            {std::to_string(degrees), fmt::format("{:.3g}", measure_gaps(to_radians(degrees))),
             fmt::format("{:.4g}", measure_angle_chi_square(to_radians(degrees)))});
    }
    return table;
}

PaperTable make_indices_table(const Evidence& evidence) {
    const Indexing indexing = read_indexing(evidence);
    PaperTable table{"indices",
                     "4.5: (direction, length) of four samples by the pixel's random number",
                     "computed from the parameters that ran; 12 and 5 are printed in the text",
                     {"q", "pairs"},
                     {}};
    for (int q = 0; q < indexing.offsets; ++q) {
        table.rows.push_back({std::to_string(q), describe(indexing.list(4, q))});
    }
    return table;
}

} // namespace alcove
