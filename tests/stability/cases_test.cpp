// What every hard case must keep: it is described, its severities go one way, its bound has a
// reason, a sound method holds in it, and a method with the fault it looks for does not.
#include "harness/stability/stability_cases.hpp"
#include "reports/record/record_json.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/stability/planted_method.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace alcove {
namespace {

constexpr ImageSize kSize{48, 36};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The fault that each case is there to find.
const std::map<std::string, Plant>& list_plants() {
    const Plant sees_far_plane = [](const PlantedFrame& frame, Image& visibility) {
        const double decades = std::log10(frame.view.camera.far_m / 100.0);
        darken_surfaces(frame, visibility, static_cast<float>(1.0 - 0.1 * decades));
    };
    // By 7.6 codes: more than any tolerance of this plant.
    const Plant darkens_planes = [](const PlantedFrame& frame, Image& visibility) {
        darken_surfaces(frame, visibility, 0.97f);
    };
    const Plant has_a_left_side = [](const PlantedFrame&, Image& visibility) {
        for (int y = 0; y < visibility.height(); ++y) {
            for (int x = 0; x < visibility.width() / 2; ++x) {
                visibility.at(x, y) = std::min(visibility.at(x, y), 0.9f);
            }
        }
    };
    const auto darkens_left_surfaces = [has_a_left_side](const PlantedFrame& frame,
                                                         Image& visibility) {
        has_a_left_side(frame, visibility);
        for (std::size_t i = 0; i < visibility.values().size(); ++i) {
            if (std::isinf(frame.depth.values()[i])) {
                visibility.values()[i] = 1.0f;
            }
        }
    };
    static const std::map<std::string, Plant> kPlants{
        {"far_plane_eye_32f", sees_far_plane},
        {"far_plane_eye_16f", sees_far_plane},
        {"far_plane_raster_32f", sees_far_plane},
        {"far_plane_raster_24", sees_far_plane},
        {"far_plane_raster_16", sees_far_plane},
        {"radius_small",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, frame.params.radius < 1e-3 ? 0.9f : 1.0f);
         }},
        {"radius_large",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, frame.params.radius > 100.0 ? 0.9f : 1.0f);
         }},
        {"fov_narrow", darkens_planes},
        {"fov_wide", darkens_planes},
        {"surface_near", darkens_planes},
        {"plane_grazing", darkens_planes},
        {"size_odd",
         [](const PlantedFrame&, Image& visibility) {
             for (int y = 0; y < visibility.height() && visibility.width() % 2 == 1; ++y) {
                 visibility.at(visibility.width() / 2, y) = 0.9f;
             }
         }},
        {"nan_input",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, frame.has_seen_nan ? 0.5f : 1.0f);
         }},
        {"normals_zero",
         [](const PlantedFrame& frame, Image& visibility) {
             for (int y = 0; y < visibility.height(); ++y) {
                 for (int x = 0; x < visibility.width(); ++x) {
                     const bool is_zero = frame.normal.at(x, y, 0) == 0.0f &&
                                          frame.normal.at(x, y, 1) == 0.0f &&
                                          frame.normal.at(x, y, 2) == 0.0f;
                     visibility.at(x, y) =
                         is_zero && !std::isinf(frame.depth.at(x, y)) ? kNaN : 1.0f;
                 }
             }
         }},
        {"world_offset",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility,
                             std::abs(frame.view.camera.position.x) > 1e6 ? 0.9f : 1.0f);
         }},
        {"scale",
         [](const PlantedFrame& frame, Image& visibility) {
             for (std::size_t i = 0; i < visibility.values().size(); ++i) {
                 const float depth = frame.depth.values()[i]; // a constant in metres
                 visibility.values()[i] = depth > 3.0f && !std::isinf(depth) ? 0.9f : 1.0f;
             }
         }},
        {"sky_edges", darkens_planes},
        {"foreground", darkens_planes},
        {"mirror", darkens_left_surfaces},
        {"quarter_turn", darkens_left_surfaces},
        {"history_cap_low",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, frame.params.cap < 10.0 ? 0.9f : 1.0f);
         }},
        {"history_cap_high",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, std::isinf(frame.params.cap) ? 0.9f : 1.0f);
         }},
        {"few_samples",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, frame.params.samples < 4 ? 0.9f : 1.0f);
         }},
        {"camera_return",
         [](const PlantedFrame& frame, Image& visibility) {
             darken_surfaces(frame, visibility, frame.has_moved ? 0.9f : 1.0f);
         }},
        {"still_drift",
         [](const PlantedFrame& frame, Image& visibility) {
             const float lost = 0.001f * static_cast<float>(frame.frames_since_reset);
             darken_surfaces(frame, visibility, std::max(0.0f, 1.0f - lost));
         }},
    };
    return kPlants;
}

class StabilityCases : public GlTest, public testing::WithParamInterface<StabilityCase> {
  protected:
    static StabilityVerdict judge_plant(const StabilityCase& hard, const Plant& plant) {
        const MethodUnit unit = make_planted_unit(plant);
        const StabilitySubject subject(context(), unit, parse_method_spec("planted"));
        EXPECT_EQ(hard.find_obstacle(subject), "");
        std::vector<StabilityScoreRecord> scores;
        for (const StabilitySeverityRecord& severity : hard.about.severities) {
            const StabilityScore score = hard.measure(subject, kSize, severity.value);
            EXPECT_FALSE(score.picture.empty());
            scores.push_back({score.score, score.bound, score.fault, ""});
        }
        return judge(scores);
    }
};

TEST_P(StabilityCases, AreDescribed) {
    const StabilityCaseRecord& about = GetParam().about;
    EXPECT_TRUE(is_safe_id(about.name)) << about.name;
    for (const std::string& text : {about.title, about.trigger, about.source, about.axis,
                                    about.invariant, about.score, about.score_unit}) {
        EXPECT_FALSE(text.empty());
        EXPECT_EQ(text.find(".md"), std::string::npos) << text;
    }
    EXPECT_GT(about.bound_reason.size(), 40u) << "a bound has a reason: " << about.bound_reason;
}

TEST_P(StabilityCases, GoFromMildToHarshOneWay) {
    const std::vector<StabilitySeverityRecord>& severities = GetParam().about.severities;
    ASSERT_GE(severities.size(), 2u);
    const bool rises = severities.back().value > severities.front().value;
    for (std::size_t i = 1; i < severities.size(); ++i) {
        EXPECT_EQ(severities[i].value > severities[i - 1].value, rises);
        EXPECT_NE(severities[i].value, severities[i - 1].value);
        EXPECT_NE(severities[i].label, severities[i - 1].label);
    }
}

TEST_P(StabilityCases, HoldForASoundMethod) {
    const StabilityVerdict verdict = judge_plant(GetParam(), [](const PlantedFrame&, Image&) {});
    EXPECT_EQ(verdict.outcome, StabilityOutcome::holds) << verdict.worst_margin;
}

TEST_P(StabilityCases, FindTheFaultTheyLookFor) {
    const auto plant = list_plants().find(GetParam().about.name);
    ASSERT_NE(plant, list_plants().end()) << "plant a fault for the new case";
    const StabilityVerdict verdict = judge_plant(GetParam(), plant->second);
    EXPECT_LT(verdict.worst_margin, 0.0);
    EXPECT_NE(verdict.outcome, StabilityOutcome::holds);
}

TEST_P(StabilityCases, CallANaNAFaultWhateverTheScore) {
    const StabilityVerdict verdict = judge_plant(
        GetParam(), [](const PlantedFrame&, Image& visibility) { visibility.at(0, 0) = kNaN; });
    EXPECT_EQ(verdict.outcome, StabilityOutcome::fails);
    EXPECT_TRUE(std::isinf(verdict.worst_margin));
}

INSTANTIATE_TEST_SUITE_P(All, StabilityCases, testing::ValuesIn(list_stability_cases()),
                         [](const auto& name) { return name.param.about.name; });

TEST(StabilityCaseList, NamesAreUnique) {
    std::set<std::string> names;
    for (const StabilityCase& hard : list_stability_cases()) {
        EXPECT_TRUE(names.insert(hard.about.name).second) << hard.about.name;
    }
}

} // namespace

void PrintTo(const StabilityCase& hard, std::ostream* stream) {
    *stream << hard.about.name;
}

} // namespace alcove
