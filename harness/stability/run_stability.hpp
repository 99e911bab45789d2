#pragma once
// Every method through every case.

#include "harness/run/units.hpp"
#include "harness/stability/stability_case.hpp"

#include <functional>
#include <span>
#include <vector>

namespace alcove {

/// Under it cases have no room for their lines, squares and blocks.
inline constexpr int kSmallestStabilitySize = 32;

struct StabilityPlan {
    std::vector<MethodSpec> methods; ///< labels unique
    std::vector<StabilityCase> cases;
    ImageSize size{96, 72};
    std::string command_line;
};

/// A picture of a cell that failed.
struct StabilityPicture {
    std::string path; ///< inside the folder
    Image visibility;
};

struct StabilityEvents {
    /// Share done in [0,1] and what comes next.
    std::function<void(double, const std::string&)> progress;
    /// Pictures of failing cells at the mildest and the harshest severity.
    std::function<void(const StabilityPicture&)> picture;
};

/// All reported methods in their default preset, and the presets that behave otherwise: a blur over
/// edges, the paper's settings without a bias, and its other estimator.
[[nodiscard]] std::vector<MethodSpec>
list_default_stability_methods(const Registry<MethodUnit>& methods);

/// The cases of these names; all without any. Throws InputError with the nearest name.
[[nodiscard]] std::vector<StabilityCase> choose_cases(std::span<const std::string> names);

/// Runs the plan; every score comes from fresh instances. Throws InputError on unknown methods,
/// presets and parameters, and on labels that stand twice.
[[nodiscard]] StabilityRecord run_stability(const StabilityPlan& plan, gl::Context& context,
                                            const Registry<MethodUnit>& methods,
                                            const StabilityEvents& events);

} // namespace alcove
