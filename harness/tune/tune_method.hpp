#pragma once
// `alcove tune`: fits free parameters of methods to a target (DESIGN 3.8). Competitors get equal
// effort: evaluations in proportion to their free parameters. Every second single frame of the
// training scenes is fitted on; the others, and held-out scenes, judge, by the objective and by a
// metric that was not tuned on.

#include "harness/run/experiment.hpp"
#include "harness/run/units.hpp"
#include "reports/record/tune_record.hpp"

#include <functional>
#include <string>
#include <vector>

namespace alcove {

/// What tuning is asked for.
struct TunePlan {
    std::vector<MethodSpec> methods;
    std::vector<std::string> scenes; ///< one or more
    std::vector<std::string> held_out_scenes;
    std::string target; ///< over the scenes' default; empty: the default
    ImageSize size{384, 288};
    std::string objective = "rmse";
    std::string judge = "ssim";
    std::vector<std::string> free; ///< names; empty: radius and strength
    int evaluations_per_parameter = 24;
    std::optional<MethodSpec> reference; ///< what is fitted to, as Experiment::reference
    int reference_rays_per_half = 32;
    std::uint64_t seed = 1;
    std::string command_line;
};

/// Least and most evaluations a parameter.
inline constexpr int kFewestEvaluations = 4;
inline constexpr int kMostEvaluations = 1000;

struct TuneEvents {
    /// Share done in [0,1], and what is being done.
    std::function<void(double, const std::string&)> progress = [](double, const std::string&) {};
    /// After each method: the record so far, and the text of the new method's calibration.
    std::function<void(const TuneRecord&, const TunedMethodRecord&, const std::string&)>
        method_done = [](const TuneRecord&, const TunedMethodRecord&, const std::string&) {};
};

/// `context` and `described` are of one context. Throws InputError on what cannot be tuned.
[[nodiscard]] TuneRecord run_tune(const TunePlan& plan, gl::Context& context,
                                  const ContextRecord& described, const Units& units,
                                  const TuneEvents& events);

} // namespace alcove
