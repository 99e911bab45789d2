#pragma once
// How large a pixel is seen: the viewing conditions that flip and hdr_flip ask for.

#include "core/base/parameters.hpp"

namespace alcove {

/// Base of a metric's parameters. Defaults as published: 0.7 m away from a monitor that is 0.7 m
/// wide and has 3840 pixels a row, 67.02 pixels a degree.
struct FlipViewing {
    double distance_m = 0.7;
    double monitor_width_m = 0.7;
    double monitor_width_px = 3840.0;
    double ppd = 67.0; ///< the table computes it from the other three unless it is given
};

/// The four declarations for a struct that derives from FlipViewing.
template <class Params>
[[nodiscard]] ParameterBuilder declare_distance() {
    return real<Params>(&Params::distance_m, "distance_m")
        .range(0.05, 20.0)
        .unit("m")
        .meaning("From the eye to the monitor.")
        .source("Andersson et al. 2020, section 5");
}

template <class Params>
[[nodiscard]] ParameterBuilder declare_monitor_width() {
    return real<Params>(&Params::monitor_width_m, "monitor_width_m")
        .range(0.05, 20.0)
        .unit("m")
        .meaning("Width of the monitor's picture.")
        .source("Andersson et al. 2020, section 5");
}

template <class Params>
[[nodiscard]] ParameterBuilder declare_monitor_pixels() {
    return real<Params>(&Params::monitor_width_px, "monitor_width_px")
        .range(64.0, 65536.0)
        .unit("px")
        .meaning("Pixels in a row of the monitor.")
        .source("Andersson et al. 2020, section 5");
}

template <class Params>
[[nodiscard]] ParameterBuilder declare_ppd() {
    return real<Params>(&Params::ppd, "ppd")
        .range(1.0, 500.0)
        .unit("px/degree")
        .symbol("p")
        .meaning("Pixels a degree of visual angle; where it is given, the three above do nothing.")
        .source("Andersson et al. 2020, section 5")
        // pi / 180
        .default_expression("distance_m * monitor_width_px / monitor_width_m * "
                            "0.017453292519943295");
}

} // namespace alcove
