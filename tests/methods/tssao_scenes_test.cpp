// What tssao's histories do on scenes: the orderings that the paper's figures 1, 6, 8 and 10 show.
// Truth here is the estimator itself with 480 samples in one frame: what it can do at most.

#include "core/base/history_state.hpp"
#include "core/base/statistics.hpp"
#include "tests/methods/scene_shots.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{192, 144};
constexpr int kWarmFrames = 95; ///< cap 1000 with 32 falling to 8

class TssaoScenesTest : public GlTest {};

float get(const Image& state, HistoryChannel channel, int x, int y) {
    return state.at(x, y, static_cast<int>(channel));
}

/// Lower end of the 95 % interval of the mean of `differences`.
double get_lower_end(const std::vector<double>& differences) {
    return estimate_across_repeats(differences).interval.value().lower;
}

struct StillCase {
    const char* name;
    const char* temporal;
    const char* weak;
    const char* strong;
    const char* reference;
};

class TssaoStill : public TssaoScenesTest, public testing::WithParamInterface<StillCase> {};

INSTANTIATE_TEST_SUITE_P(
    Estimators, TssaoStill,
    testing::Values(
        StillCase{"hemisphere", "tssao@paper_table2_vienna", "hemisphere_ssao@paper_weak_blur",
                  "hemisphere_ssao@paper_strong_blur",
                  "tssao@paper_table2_vienna:use_history=false,initial_samples=480,filter_radius=0,"
                  "rotation_off_conv=0"},
        // Blurred by tssao's own filter: within r/4 in the world, or far over it.
        StillCase{"fox_compton", "tssao@paper_stills", "tssao@paper_stills:use_history=false",
                  "tssao@paper_stills:use_history=false,filter_radius=4,filter_sigma=10",
                  "tssao@paper_stills:use_history=false,initial_samples=480,filter_radius=0,"
                  "rotation_off_conv=0"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(TssaoStill, ConvergedItIsCloserToTheReferenceThanSsaoWithEitherBlur) {
    SceneShots shots(context(), "cathedral", "detail=0.125", kSize);
    const auto temporal = shots.make_method(GetParam().temporal);
    const auto weak = shots.make_method(GetParam().weak);
    const auto strong = shots.make_method(GetParam().strong);
    const auto reference = shots.make_method(GetParam().reference);
    std::vector<double> gain_over_weak;
    std::vector<double> gain_over_strong;
    for (const int frame : {7, 22, 37, 52, 67, 82, 97, 112}) {
        const Image truth = shots.converge(*reference, frame, 1).visibility;
        const double error =
            compute_rms(shots.converge(*temporal, frame, kWarmFrames).visibility, truth);
        gain_over_weak.push_back(compute_rms(shots.converge(*weak, frame, 1).visibility, truth) -
                                 error);
        gain_over_strong.push_back(
            compute_rms(shots.converge(*strong, frame, 1).visibility, truth) - error);
        EXPECT_LT(error, 0.02) << frame;
    }
    EXPECT_GT(get_lower_end(gain_over_weak), 0.0);
    EXPECT_GT(get_lower_end(gain_over_strong), 0.0);
}

TEST_F(TssaoScenesTest, ConvergingIsFastThenSteady) {
    SceneShots shots(context(), "cathedral", "detail=0.125", kSize);
    const auto temporal = shots.make_method("tssao:filter_radius=0");
    const auto reference = shots.make_method("tssao@reference_480");
    const Image truth = shots.converge(*reference, 52, 1).visibility;
    std::vector<double> errors;
    for (const int frames : {1, 4, 16, kWarmFrames}) {
        errors.push_back(compute_rms(shots.converge(*temporal, 52, frames).visibility, truth));
    }
    EXPECT_GT(errors[0], 1.5 * errors[1]);
    EXPECT_GT(errors[1], 1.5 * errors[2]);
    EXPECT_GT(errors[2], errors[3]);
}

/// lifted_box at medium speed from a converged start; `frames` frames from kBegin - 1 on.
constexpr int kBegin = 58; ///< the box rests last on this frame

struct Ablation {
    double ghost = 0.0; ///< RMS error on the floor that the box has left, 4 frames after the start
    double noise = 0.0; ///< RMS of two noise seeds' difference there / sqrt 2
};

TEST_F(TssaoScenesTest, DisocclusionAloneLeavesAGhostFullInvalidationNoiseAndSmoothLittleOfBoth) {
    SceneShots shots(context(), "lifted_box", "", kSize);
    constexpr int kShown = kBegin + 6;
    const auto reference = shots.make_method("tssao@reference_480");
    const Image truth = shots.converge(*reference, kShown, 1).visibility;
    // Where truth has brightened since the box rested: its vacated contact shadow.
    const Image before = shots.converge(*reference, kBegin, 1).visibility;
    Image vacated(kSize, 1);
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
        vacated.values()[i] = truth.values()[i] > before.values()[i] + 0.1f ? 1.0f : 0.0f;
    }
    const auto measure = [&](const std::string& settings) {
        std::vector<Image> seeds;
        for (const std::uint32_t seed : {1u, 2u}) {
            const auto method = shots.make_method("tssao:filter_radius=0," + settings);
            const FrameView start = shots.get_view(kBegin, true);
            for (int i = 0; i < kWarmFrames; ++i) {
                static_cast<void>(shots.shoot(*method, i == 0 ? start : hold(start), seed));
            }
            Image last;
            for (int frame = kBegin + 1; frame <= kShown; ++frame) {
                last = shots.shoot(*method, shots.get_view(frame), seed).visibility;
            }
            seeds.push_back(last);
        }
        return Ablation{compute_rms(seeds[0], truth, &vacated),
                        compute_rms(seeds[0], seeds[1], &vacated) / std::sqrt(2.0)};
    };
    const Ablation disocclusion_only = measure("invalidation=none");
    const Ablation full = measure("invalidation=full");
    const Ablation smooth = measure("invalidation=smooth");
    EXPECT_GT(disocclusion_only.ghost, 2.0 * full.ghost);
    EXPECT_GT(disocclusion_only.ghost, 1.5 * smooth.ghost);
    EXPECT_GT(full.noise, 1.2 * smooth.noise);
}

/// Distance from a point to a box that stands on `low` to `high`; 0 inside.
double compute_distance(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high) {
    return glm::length(glm::max(glm::max(low - point, point - high), glm::dvec3(0.0)));
}

TEST_F(TssaoScenesTest, HistoriesAreLostWithinReachOfTheMovedBoxAndKeptBeyondTwiceThat) {
    SceneShots shots(context(), "lifted_box", "", kSize);
    const double r = shots.scene().get_ao_radius_m();
    constexpr std::size_t kBox = 1;
    ASSERT_EQ(shots.scene().get_objects()[kBox].name, "box");
    const auto method = shots.make_method("tssao");
    const FrameView start = shots.get_view(kBegin, true);
    for (int i = 0; i < kWarmFrames; ++i) {
        static_cast<void>(shots.shoot(*method, i == 0 ? start : hold(start)));
    }
    for (int frame = kBegin + 1; frame <= kBegin + 4; ++frame) {
        const FrameView view = shots.get_view(frame);
        const Image state = shots.shoot(*method, view).history_state.value();
        const Image depth = shots.read_depth(view);
        int lost = 0;
        int lost_near = 0;
        int far = 0;
        int far_converged = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                if (get(state, HistoryChannel::surface, x, y) == 0.0f) {
                    continue;
                }
                const glm::dvec3 point =
                    view.camera.position +
                    static_cast<double>(depth.at(x, y)) *
                        compute_pixel_direction(view.camera, kSize, {x + 0.5, y + 0.5});
                // The box, 1 m wide, now and one frame ago.
                double distance = 1e9;
                for (const double time_s : {view.time_s, view.previous_time_s}) {
                    const glm::dvec3 lift(
                        shots.scene().compute_pose(time_s).object_to_world[kBox][3]);
                    distance = std::min(distance,
                                        compute_distance(point, lift + glm::dvec3(-0.5, 0.0, -0.5),
                                                         lift + glm::dvec3(0.5, 1.0, 0.5)));
                }
                const auto cause = get(state, HistoryChannel::cause, x, y);
                if (cause != static_cast<float>(HistoryCause::kept)) {
                    ++lost;
                    lost_near += distance <= r ? 1 : 0;
                }
                if (distance > 2.0 * r) {
                    ++far;
                    far_converged += get(state, HistoryChannel::convergence, x, y) >= 1.0f ? 1 : 0;
                }
            }
        }
        ASSERT_GT(lost, 100) << frame;
        EXPECT_GE(lost_near, 0.9 * lost) << frame;
        EXPECT_GE(far_converged, 0.98 * far) << frame;
    }
}

TEST_F(TssaoScenesTest, AGuardBandMendsTheBorder) {
    SceneShots shots(context(), "cathedral", "detail=0.125", kSize);
    const auto plain = shots.make_method("tssao:border=clamp");
    const auto guarded = shots.make_method("tssao:border=clamp,guard=7.5");
    const auto wide = shots.make_method("tssao@reference_480:border=clamp,guard=10");
    Image border(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const int edge =
                std::min(std::min(x, kSize.width - 1 - x), std::min(y, kSize.height - 1 - y));
            border.at(x, y) = edge < 6 ? 1.0f : 0.0f;
        }
    }
    for (const int frame : {22, 67, 97}) {
        const Image truth = shots.converge(*wide, frame, 1).visibility;
        const double without =
            compute_rms(shots.converge(*plain, frame, 20).visibility, truth, &border);
        const double with =
            compute_rms(shots.converge(*guarded, frame, 20).visibility, truth, &border);
        EXPECT_LT(with, 0.7 * without) << frame;
    }
}

TEST_F(TssaoScenesTest, HalfResolutionKeepsToTheFullOne) {
    SceneShots shots(context(), "lifted_box", "", kSize);
    const auto full = shots.make_method("tssao");
    const auto half = shots.make_method("tssao:resolution=half");
    const auto none = shots.make_method("none");
    const Image image = shots.converge(*full, 20, kWarmFrames).visibility;
    const double loss = compute_rms(shots.converge(*half, 20, kWarmFrames).visibility, image);
    EXPECT_LT(loss, 0.35 * compute_rms(shots.converge(*none, 20, 1).visibility, image));
}

} // namespace
} // namespace alcove
