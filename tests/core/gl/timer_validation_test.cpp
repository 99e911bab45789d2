// Lying clocks: the validator on simulated devices, without OpenGL and without waiting.
#include "core/gl/timer_validation.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alcove::gl {
namespace {

/// A device in virtual time whose timers lie in a chosen way in every mode but the last.
class SimulatedBench final : public TimerBench {
  public:
    enum class Lie { none, nonsense, moves_time, microsecond_tick };

    explicit SimulatedBench(Lie lie, double ns_per_iteration = 20000.0)
        : m_lie(lie), m_ns_per_iteration(ns_per_iteration) {}

    void set_iterations(LoadKind kind, std::int64_t iterations) override {
        (kind == LoadKind::draw ? m_draw : m_compute) = iterations;
    }
    double run_alone(LoadKind kind) override { return noisy(cost(kind)); }
    std::vector<double> run_sequence(TimerMode mode, std::span<const LoadKind> sequence) override {
        std::vector<double> times;
        for (const LoadKind kind : sequence) {
            times.push_back(noisy(cost(kind)));
        }
        if (mode != TimerMode::timestamp_finish) {
            lie(sequence, times);
        }
        return times;
    }
    double get_tick_ns(TimerMode) override { return m_lie == Lie::microsecond_tick ? 1000.0 : 1.0; }
    [[nodiscard]] double cost(LoadKind kind) const {
        // Draws and dispatches do not cost the same, as on real devices.
        return kind == LoadKind::draw ? static_cast<double>(m_draw) * m_ns_per_iteration
                                      : static_cast<double>(m_compute) * 1.3 * m_ns_per_iteration;
    }

  private:
    double noisy(double time) {
        return time * (1.0 + std::uniform_real_distribution(-0.01, 0.01)(m_random));
    }
    void lie(std::span<const LoadKind> sequence, std::vector<double>& times) {
        switch (m_lie) {
        case Lie::none:
            break;
        case Lie::nonsense:
            times.front() = -4.7e11;
            break;
        case Lie::moves_time:
            // A dispatch is charged to the draw before it: the sum stays right.
            for (std::size_t i = 1; i < times.size(); ++i) {
                if (sequence[i] == LoadKind::compute && sequence[i - 1] == LoadKind::draw) {
                    times[i - 1] += 0.95 * times[i];
                    times[i] *= 0.05;
                }
            }
            break;
        case Lie::microsecond_tick:
            for (double& time : times) {
                time = std::round(time / 1000.0) * 1000.0;
            }
            break;
        }
    }

    Lie m_lie;
    double m_ns_per_iteration;
    std::int64_t m_draw = 1;
    std::int64_t m_compute = 1;
    std::mt19937 m_random{3};
};

TimerReport validate(SimulatedBench& bench, bool exhaustive = true) {
    TimerValidationOptions options;
    options.exhaustive = exhaustive;
    return validate_timers(bench, options);
}

bool is_accepted(const TimerReport& report, TimerMode mode) {
    return std::find(report.accepted.begin(), report.accepted.end(), mode) != report.accepted.end();
}

TEST(TimerValidation, AnHonestClockIsAcceptedInItsCheapestMode) {
    SimulatedBench bench(SimulatedBench::Lie::none);
    const TimerReport report = validate(bench);
    EXPECT_EQ(report.accepted.size(), kQueryModes.size());
    EXPECT_EQ(report.chosen(), TimerMode::time_elapsed);
}

TEST(TimerValidation, NonsenseIsRejectedInEverySequence) {
    SimulatedBench bench(SimulatedBench::Lie::nonsense);
    const TimerReport report = validate(bench);
    EXPECT_EQ(report.chosen(), TimerMode::timestamp_finish);
    for (const TimerTrial& trial : report.trials) {
        EXPECT_EQ(trial.accepted, trial.mode == TimerMode::timestamp_finish) << trial.sequence;
    }
}

TEST(TimerValidation, AClockThatKeepsTheSumAndMovesTimeIsRejected) {
    SimulatedBench bench(SimulatedBench::Lie::moves_time);
    const TimerReport report = validate(bench);
    EXPECT_EQ(report.chosen(), TimerMode::timestamp_finish);
    for (const TimerTrial& trial : report.trials) {
        const bool has_dc = trial.sequence.find("DC") != std::string::npos;
        EXPECT_EQ(trial.accepted, trial.mode == TimerMode::timestamp_finish || !has_dc)
            << trial.sequence;
    }
}

TEST(TimerValidation, ACoarseTickIsAcceptedAndReported) {
    SimulatedBench bench(SimulatedBench::Lie::microsecond_tick);
    const TimerReport report = validate(bench);
    EXPECT_TRUE(is_accepted(report, TimerMode::time_elapsed));
    EXPECT_EQ(report.tick_ns, 1000.0);
}

TEST(TimerValidation, ADeviceAThousandTimesFasterGetsAThousandTimesTheLoad) {
    SimulatedBench slow(SimulatedBench::Lie::none);
    SimulatedBench fast(SimulatedBench::Lie::none, 20.0);
    const TimerReport slow_report = validate(slow);
    const TimerReport fast_report = validate(fast);
    const double growth = static_cast<double>(fast_report.draw_iterations) /
                          static_cast<double>(slow_report.draw_iterations);
    EXPECT_NEAR(growth, 1000.0, 300.0);
    EXPECT_GE(fast_report.draw_alone_ns, 20e6);
    EXPECT_GE(fast_report.compute_alone_ns, 20e6);
    EXPECT_EQ(fast_report.chosen(), TimerMode::time_elapsed);
}

TEST(TimerValidation, QuickSearchDropsAModeAtItsFirstFailureAndStopsAtTheFirstGoodOne) {
    SimulatedBench bench(SimulatedBench::Lie::nonsense);
    const TimerReport report = validate(bench, false);
    EXPECT_EQ(report.chosen(), TimerMode::timestamp_finish);
    int rejected = 0;
    for (const TimerTrial& trial : report.trials) {
        rejected += trial.accepted ? 0 : 1;
    }
    EXPECT_EQ(rejected, 4); // one hopeless attempt each
}

TEST(TimerValidation, WithoutAnAcceptedModeTheWallClockIsUsed) {
    class Hopeless final : public TimerBench {
      public:
        void set_iterations(LoadKind, std::int64_t iterations) override {
            m_iterations = iterations;
        }
        double run_alone(LoadKind) override { return static_cast<double>(m_iterations) * 1e4; }
        std::vector<double> run_sequence(TimerMode, std::span<const LoadKind> sequence) override {
            return std::vector<double>(sequence.size(), 1.0);
        }
        double get_tick_ns(TimerMode) override { return 1.0; }

      private:
        std::int64_t m_iterations = 1;
    };
    Hopeless bench;
    EXPECT_EQ(validate_timers(bench).chosen(), TimerMode::fenced_wall);
}

TEST(TimerValidation, ALoadThatCannotBeSizedIsAFailure) {
    SimulatedBench bench(SimulatedBench::Lie::none, 0.0);
    EXPECT_THROW(static_cast<void>(validate(bench)), FailureError);
}

} // namespace
} // namespace alcove::gl
