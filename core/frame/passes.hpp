#pragma once
// Named, timed GPU steps. A method wraps every pass in a scope; what is timed is the recorder's
// business.

#include "core/gl/timer.hpp"

#include <string>
#include <utility>
#include <vector>

namespace alcove {

/// none: nothing is timed (capture and warm-up). divided: each pass is one interval. envelope: the
/// caller times the whole, passes are only named. Dividing perturbs: intervals and gates use the
/// envelope.
enum class PassTiming { none, divided, envelope };

/// Collects the passes of one method in one frame.
class PassRecorder {
  public:
    explicit PassRecorder(PassTiming timing, gl::IntervalTimer* timer = nullptr)
        : m_timing(timing), m_timer(timer) {
        ALCOVE_ASSERT(timing != PassTiming::divided || timer != nullptr, "a timer to divide with");
    }

    /// One pass, from construction to destruction. Passes do not nest.
    class Scope {
      public:
        Scope(PassRecorder& recorder, std::string name) : m_recorder(recorder) {
            recorder.begin(std::move(name));
        }
        ~Scope() { m_recorder.end(); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PassRecorder& m_recorder;
    };
    /// `name` is "method/pass", e.g. "hemisphere_ssao/occlusion".
    [[nodiscard]] Scope scope(std::string name) { return {*this, std::move(name)}; }

    /// The passes that ran, in order.
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return m_names; }

  private:
    void begin(std::string name) {
        m_names.push_back(std::move(name));
        if (m_timing == PassTiming::divided) {
            m_timer->begin();
        }
    }
    void end() {
        if (m_timing == PassTiming::divided) {
            m_timer->end();
        }
    }

    PassTiming m_timing;
    gl::IntervalTimer* m_timer;
    std::vector<std::string> m_names;
};

} // namespace alcove
