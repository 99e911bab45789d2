#include "harness/run/sequence_truth.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr ChannelSet kMetricChannels{Channel::eye_depth, Channel::normal, Channel::motion,
                                     Channel::instance_id};

Precision make_full_precision() {
    Precision precision;
    precision.motion = MotionPrecision::float32;
    return precision;
}

EarlierFrame make_earlier_frame(int steps, Correspondence correspondence, const Truth& truth) {
    EarlierFrame earlier;
    earlier.steps = steps;
    earlier.reference = warp_image(truth.mean, correspondence);
    if (truth.halves) {
        earlier.reference_a = warp_image(truth.halves->a, correspondence);
        earlier.reference_b = warp_image(truth.halves->b, correspondence);
    }
    earlier.correspondence = std::move(correspondence);
    return earlier;
}

} // namespace

SequenceTruth::SequenceTruth(RoundStage& stage)
    : m_stage(stage), m_gbuffer(stage.gl(), stage.size(), kMetricChannels, make_full_precision()) {}

void SequenceTruth::reset() {
    m_newest.reset();
    m_past.clear();
    m_earlier.clear();
}

SurfaceImages SequenceTruth::read_surfaces() {
    m_stage.draw(m_gbuffer);
    const gl::Functions& gl = m_stage.gl();
    return {gl::read_texture(gl, m_gbuffer.texture(Channel::eye_depth), 1),
            gl::read_texture(gl, m_gbuffer.texture(Channel::normal), 3),
            gl::read_texture(gl, m_gbuffer.texture(Channel::motion), 3),
            gl::read_texture(gl, m_gbuffer.texture(Channel::instance_id), 1)};
}

const SurfaceImages& SequenceTruth::surfaces() const {
    ALCOVE_ASSERT(m_newest.has_value(), "a frame was added");
    return *m_newest;
}

void SequenceTruth::add(const FrameView& view, const Truth& truth) {
    SurfaceImages now = read_surfaces();
    m_surface = Image(view.size, 1);
    m_moves = Image(view.size, 1);
    for (int y = 0; y < view.size.height; ++y) {
        for (int x = 0; x < view.size.width; ++x) {
            const bool moves = now.motion.at(x, y, 0) != 0.0f || now.motion.at(x, y, 1) != 0.0f ||
                               now.motion.at(x, y, 2) != 0.0f;
            m_surface.at(x, y) = std::isinf(now.eye_depth.at(x, y)) ? 0.0f : 1.0f;
            m_moves.at(x, y) = moves ? 1.0f : 0.0f;
        }
    }
    m_earlier.clear();
    Past past;
    past.truth = truth;
    if (m_newest && view.history_valid) {
        past.back[0] = make_correspondence(view, now, *m_newest);
        // Twice as far: the way to half of it, and from there as far again.
        for (std::size_t i = 1; i < kEarlierSteps.size(); ++i) {
            const auto half = static_cast<std::size_t>(kEarlierSteps.at(i - 1));
            if (m_past.size() >= half && past.back.at(i - 1) &&
                m_past.at(m_past.size() - half).back.at(i - 1)) {
                past.back.at(i) = compose_correspondences(
                    *past.back.at(i - 1), *m_past.at(m_past.size() - half).back.at(i - 1));
            }
        }
        for (std::size_t i = 0; i < kEarlierSteps.size(); ++i) {
            const auto steps = static_cast<std::size_t>(kEarlierSteps.at(i));
            if (past.back.at(i)) {
                m_earlier.push_back(make_earlier_frame(kEarlierSteps.at(i), *past.back.at(i),
                                                       m_past.at(m_past.size() - steps).truth));
            }
        }
    }
    m_past.push_back(std::move(past));
    if (m_past.size() > static_cast<std::size_t>(kEarlierSteps.back())) {
        m_past.pop_front();
    }
    m_newest = std::move(now);
}

} // namespace alcove
