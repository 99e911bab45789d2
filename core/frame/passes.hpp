#pragma once
// Named GPU steps. A method wraps every pass in a scope; what is timed or counted is the recorder's
// business.

#include "core/gl/fetch_counter.hpp"
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
    /// Untimed: counts what each pass fetches. The counter must outlive the recorder.
    explicit PassRecorder(gl::FetchCounter& counter) : m_counter(&counter) {}

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
    /// Fetches of each of names(), of all pixels; empty unless they are counted.
    [[nodiscard]] const std::vector<std::uint64_t>& fetches() const noexcept { return m_fetches; }

  private:
    void begin(std::string name) {
        m_names.push_back(std::move(name));
        if (m_timing == PassTiming::divided) {
            m_timer->begin();
        }
        if (m_counter != nullptr) {
            m_counter->begin();
        }
    }
    void end() {
        if (m_timing == PassTiming::divided) {
            m_timer->end();
        }
        if (m_counter != nullptr) {
            m_fetches.push_back(m_counter->read());
        }
    }

    PassTiming m_timing = PassTiming::none;
    gl::IntervalTimer* m_timer = nullptr;
    gl::FetchCounter* m_counter = nullptr;
    std::vector<std::string> m_names;
    std::vector<std::uint64_t> m_fetches;
};

} // namespace alcove
