#pragma once
// A cell of the plan with its living method.

#include "core/frame/compose.hpp"
#include "harness/run/plan.hpp"

#include <memory>

namespace alcove {

/// One frame's times of one cell.
struct CellTimes {
    std::vector<std::string> passes;
    std::vector<std::int64_t> pass_ns;  ///< as many as passes (divided), or one (envelope), or none
    std::vector<std::uint64_t> fetches; ///< as many as passes where they are counted, else none
};

class MethodCell {
  public:
    /// Creates the method (compiles its shaders) and allocates for the size. With a counter, which
    /// must outlive it, its passes are counted and never timed.
    MethodCell(gl::Context& context, const MethodUnit& unit, const CellRecord& record,
               ImageSize size, gl::FetchCounter* counter = nullptr);

    [[nodiscard]] const CellRecord& record() const noexcept { return m_record; }
    [[nodiscard]] bool has_passes() const noexcept { return m_record.has_passes; }
    [[nodiscard]] Method& method() noexcept { return *m_method; }
    /// The base, without light buffers where no effect of the cell calls for them, and what the
    /// method declares beyond it.
    [[nodiscard]] ChannelSet channels() const;
    /// Is there light to compose a picture of?
    [[nodiscard]] bool has_light() const { return m_effects.contains(Effect::light_buffers); }
    /// Of its G-buffer, in pixels.
    [[nodiscard]] Border border() const { return make_border(m_size, m_requests.border); }
    [[nodiscard]] const MethodRequests& requests() const noexcept { return m_requests; }
    [[nodiscard]] bool needs_geometry() const noexcept { return m_requests.posed_geometry; }

    /// Resets GL state, waits for the device, renders. Times are empty for PassTiming::none.
    [[nodiscard]] MethodOutput render(const MethodInputs& inputs, PassTiming timing,
                                      gl::IntervalTimer& timer, CellTimes& times);

  private:
    gl::Context& m_context;
    const CellRecord& m_record;
    ImageSize m_size;
    gl::FetchCounter* m_counter;
    std::unique_ptr<Method> m_method;
    EffectSet m_effects;
    MethodRequests m_requests;
};

} // namespace alcove
