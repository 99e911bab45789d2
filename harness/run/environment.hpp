#pragma once
// The machine, the device and the build that a run's numbers belong to.

#include "core/gl/context.hpp"
#include "core/gl/timer_validation.hpp"
#include "reports/record/record.hpp"

namespace alcove {

/// Everything about this process, this device and its timers, with the time of day.
[[nodiscard]] ContextRecord describe_environment(const gl::Context& context,
                                                 const gl::TimerReport& timers);

/// Throws InputError (exit 2) naming both if a run made by another build, driver or set of CPU
/// features, or with another timer, would be continued here.
void check_same_environment(const ContextRecord& recorded, const ContextRecord& here);

/// What decides the bits of an image beside our own data: the sources that draw, compiler and
/// flags, renderer, driver and the CPU features it compiles for.
[[nodiscard]] std::string describe_drawing(const gl::Context& context);
/// What a time belongs to: the above, the processor and its threads.
[[nodiscard]] std::string describe_timing(const gl::Context& context);

/// "20261122T013000Z"
[[nodiscard]] std::string make_utc_stamp();

} // namespace alcove
