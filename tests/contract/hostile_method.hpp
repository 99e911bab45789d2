#pragma once
// A method that leaves GL as dirty as it can: nothing another method draws may depend on what ran
// before it.

#include "core/contract/method.hpp"

#include <memory>

namespace alcove {

[[nodiscard]] std::unique_ptr<Method> make_hostile_method(const gl::Functions& gl);

} // namespace alcove
