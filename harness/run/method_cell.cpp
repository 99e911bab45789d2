#include "harness/run/method_cell.hpp"

namespace alcove {

MethodCell::MethodCell(gl::Context& context, const MethodUnit& unit, const CellRecord& record,
                       ImageSize size, gl::FetchCounter* counter)
    : m_context(context), m_record(record), m_size(size), m_counter(counter),
      m_method(unit.create(context, read_parameters(unit, record))),
      m_effects(parse_effects(record.effects)) {
    m_method->set_effects(m_effects);
    m_requests = m_method->get_requests();
    m_method->resize(size);
}

ChannelSet MethodCell::channels() const {
    constexpr ChannelSet kWithoutLight{Channel::eye_depth, Channel::normal};
    return m_requests.channels | (has_light() ? kBaseChannels : kWithoutLight);
}

MethodOutput MethodCell::render(const MethodInputs& inputs, PassTiming timing,
                                gl::IntervalTimer& timer, CellTimes& times) {
    m_context.reset_state();
    m_context.functions().Finish();
    ALCOVE_ASSERT(m_counter == nullptr || timing == PassTiming::none, "what counts is not timed");
    PassRecorder recorder =
        m_counter != nullptr ? PassRecorder(*m_counter) : PassRecorder(timing, &timer);
    if (timing == PassTiming::envelope) {
        timer.begin();
    }
    const MethodOutput output = m_method->render(inputs, recorder);
    if (timing == PassTiming::envelope) {
        timer.end();
    }
    times.passes = recorder.names();
    times.fetches = recorder.fetches();
    times.pass_ns.clear();
    if (timing != PassTiming::none) {
        times.pass_ns = timer.collect();
    }
    return output;
}

} // namespace alcove
