#pragma once
// A method that gives radiance, and its visibility where it is asked for that.

#include "core/contract/method.hpp"

#include <memory>

namespace alcove {

struct LightLog {
    int asked = 0;   ///< frames that asked for visibility
    int unasked = 0; ///< frames that did not
};

/// The visibility that "light_method" gives, everywhere.
inline constexpr float kLightVisibility = 0.25f;

/// "light_method:red=R,gives_both=B,is_stubborn=S": the same radiance everywhere, (R, 0, 0). With
/// gives_both it leaves its visibility unasked; with is_stubborn never.
[[nodiscard]] MethodUnit make_light_method_unit(std::shared_ptr<LightLog> log);

} // namespace alcove
