// Truth some frames ago as seen from now, on a pan whose correspondence is known in closed form.
#include "harness/run/sequence_truth.hpp"

#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

namespace alcove {
namespace {

constexpr ImageSize kSize{64, 48};
constexpr int kFrames = 12;
/// How far the picture moves to the left a frame, in pixels.
constexpr double kPan = 1.25;
constexpr double kWallDistance = 5.0;
const double kTangent = std::tan(std::numbers::pi / 6.0);
/// Width of a pixel on the wall, metres.
const double kFootprint = 2.0 * kTangent * kWallDistance / kSize.height;
/// What truth brightens by each frame, so that it says which frame it is of.
constexpr double kStep = 0.01;
/// Half A is brighter than half B by twice this.
constexpr double kHalf = 0.003;

/// A wall of 400 m before a camera that moves along it.
TestScene make_wall_scene() {
    std::vector<Camera> cameras;
    for (int frame = 0; frame < kFrames; ++frame) {
        const double x = frame * kPan * kFootprint;
        cameras.push_back(make_look_at_camera({x, 0.0, 0.0}, {x, 0.0, -1.0}, {0.0, 1.0, 0.0},
                                              std::numbers::pi / 3.0, 0.1, 1000.0));
    }
    const auto z = static_cast<float>(-kWallDistance);
    return {{make_quad({-200, -200, z}, {200, -200, z}, {200, 200, z}, {-200, 200, z})},
            {glm::dmat4(1.0)},
            std::move(cameras),
            0.5};
}

/// A ramp over the wall, which a bilinear fetch gives back exactly, for what stands `x` pixels
/// from the left in a frame.
double shade(double x, int y, int frame) {
    return 0.3 + 0.001 * (x + kPan * frame) + 0.002 * y;
}

Truth make_truth(int frame) {
    Truth truth;
    truth.mean = Image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            truth.mean.at(x, y) = static_cast<float>(shade(x, y, frame) + kStep * frame);
        }
    }
    truth.halves = ReferencePair{truth.mean, truth.mean};
    for (std::size_t i = 0; i < truth.mean.values().size(); ++i) {
        truth.halves->a.values()[i] += static_cast<float>(kHalf);
        truth.halves->b.values()[i] -= static_cast<float>(kHalf);
    }
    return truth;
}

class SequenceTruthTest : public GlTest {
  protected:
    /// The stage of a round without cells.
    RoundStage& open(const Scene& scene, int frames) {
        m_round.width = kSize.width;
        m_round.height = kSize.height;
        m_round.precision = describe(Precision{});
        m_round.target = describe(Target{});
        m_round.segments = {{0, frames}};
        return m_stage.emplace(context(), gl::TimerMode::fenced_wall, m_units, m_plan, m_round,
                               scene);
    }
    void add(SequenceTruth& sequence, const FrameView& view) {
        m_stage->set_frame(view);
        sequence.add(view, make_truth(view.index));
    }
    const FrameView& get_view(int frame) const {
        return m_stage->frames().at(static_cast<std::size_t>(frame)).view;
    }
    static std::vector<int> list_steps(const SequenceTruth& sequence) {
        std::vector<int> steps;
        for (const EarlierFrame& earlier : sequence.earlier()) {
            steps.push_back(earlier.steps);
        }
        return steps;
    }

    Units m_units = get_units();
    PlanRecord m_plan;
    RoundRecord m_round;
    std::optional<RoundStage> m_stage;
};

/// What the sequence must reach back to when it has so many frames behind it.
std::vector<int> list_expected_steps(int behind) {
    std::vector<int> steps;
    for (const int step : kEarlierSteps) {
        if (step <= behind) {
            steps.push_back(step);
        }
    }
    return steps;
}

TEST_F(SequenceTruthTest, ReachesBackAsFarAsTheSequenceGoes) {
    const TestScene scene = make_wall_scene();
    SequenceTruth sequence(open(scene, kFrames));
    for (int frame = 0; frame < kFrames; ++frame) {
        add(sequence, get_view(frame));
        EXPECT_EQ(list_steps(sequence), list_expected_steps(frame)) << frame;
    }
}

TEST_F(SequenceTruthTest, EarlierTruthStandsWhereItsSurfaceStandsNow) {
    const TestScene scene = make_wall_scene();
    SequenceTruth sequence(open(scene, kFrames));
    for (int frame = 0; frame < kFrames; ++frame) {
        add(sequence, get_view(frame));
    }
    constexpr int kLast = kFrames - 1;
    ASSERT_EQ(sequence.earlier().size(), kEarlierSteps.size());
    for (const EarlierFrame& earlier : sequence.earlier()) {
        int compared = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                if (earlier.correspondence.valid.at(x, y) == 0.0f) {
                    EXPECT_EQ(earlier.reference.at(x, y), 0.0f);
                    continue;
                }
                ++compared;
                EXPECT_NEAR(earlier.correspondence.position.at(x, y, 0),
                            x + 0.5 + kPan * earlier.steps, 0.01);
                EXPECT_NEAR(earlier.correspondence.position.at(x, y, 1), y + 0.5, 0.01);
                // The wall's own shade is the same; the step says which frame it comes from.
                const double expected = shade(x, y, kLast) + kStep * (kLast - earlier.steps);
                EXPECT_NEAR(earlier.reference.at(x, y), expected, 5e-5);
                EXPECT_NEAR(earlier.reference_a->at(x, y), expected + kHalf, 5e-5);
                EXPECT_NEAR(earlier.reference_b->at(x, y), expected - kHalf, 5e-5);
            }
        }
        // All but what came in on the right, and a pixel of erosion a step.
        EXPECT_GT(compared, kSize.height * kSize.width * 6 / 10) << earlier.steps;
    }
}

TEST_F(SequenceTruthTest, WhatComesInOverTheBorderHasAppeared) {
    const TestScene scene = make_wall_scene();
    SequenceTruth sequence(open(scene, 2));
    add(sequence, get_view(0));
    add(sequence, get_view(1));
    const Correspondence& back = sequence.earlier().front().correspondence;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            EXPECT_EQ(back.appeared.at(x, y), x + 0.5 + kPan > kSize.width ? 1.0f : 0.0f) << x;
        }
    }
}

TEST_F(SequenceTruthTest, TruthWithoutHalvesHasNoneEarlier) {
    const TestScene scene = make_wall_scene();
    SequenceTruth sequence(open(scene, 2));
    for (int frame = 0; frame < 2; ++frame) {
        m_stage->set_frame(get_view(frame));
        Truth truth = make_truth(frame);
        truth.halves.reset();
        sequence.add(get_view(frame), truth);
    }
    EXPECT_FALSE(sequence.earlier().front().reference_a.has_value());
    EXPECT_FALSE(sequence.earlier().front().reference_b.has_value());
}

TEST_F(SequenceTruthTest, ResetForgetsTheSequence) {
    const TestScene scene = make_wall_scene();
    SequenceTruth sequence(open(scene, kFrames));
    for (int frame = 0; frame < 5; ++frame) {
        add(sequence, get_view(frame));
    }
    sequence.reset();
    EXPECT_TRUE(sequence.earlier().empty());
    for (int frame = 5; frame < kFrames; ++frame) {
        add(sequence, get_view(frame));
        EXPECT_EQ(list_steps(sequence), list_expected_steps(frame - 5)) << frame;
    }
}

TEST_F(SequenceTruthTest, NoStepReachesOverAFrameWithoutHistory) {
    const TestScene scene = make_wall_scene();
    SequenceTruth sequence(open(scene, kFrames));
    constexpr int kCut = 4;
    for (int frame = 0; frame < kFrames; ++frame) {
        FrameView view = get_view(frame);
        view.history_valid = frame != kCut && frame != 0;
        add(sequence, view);
        EXPECT_EQ(list_steps(sequence), list_expected_steps(frame < kCut ? frame : frame - kCut))
            << frame;
    }
}

TEST_F(SequenceTruthTest, TellsSurfacesAndWhatMovesApart) {
    const TestScene scene = make_box_scene();
    SequenceTruth sequence(open(scene, 2));
    /// Number of the box that rises from the floor, counted from 1.
    constexpr float kRising = 3.0f;
    for (int frame = 0; frame < 2; ++frame) {
        const FrameView& view = get_view(frame);
        add(sequence, view);
        const GBuffer gbuffer(gl(), kSize, {Channel::eye_depth, Channel::instance_id}, Precision{});
        m_stage->draw(gbuffer);
        const Image ids = gl::read_texture(gl(), gbuffer.texture(Channel::instance_id), 1);
        int moving = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const float id = ids.at(x, y);
                EXPECT_EQ(sequence.surface().at(x, y), id != 0.0f ? 1.0f : 0.0f);
                EXPECT_EQ(sequence.moves().at(x, y), frame == 1 && id == kRising ? 1.0f : 0.0f)
                    << "frame " << frame << ", object " << id;
                moving += id == kRising ? 1 : 0;
            }
        }
        EXPECT_GT(moving, 20);
        EXPECT_LT(moving, kSize.width * kSize.height / 2);
    }
}

} // namespace
} // namespace alcove
