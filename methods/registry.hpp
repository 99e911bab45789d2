#pragma once
// All methods, from the one list in methods/CMakeLists.txt. registry.cpp is generated.

#include "core/base/registry.hpp"
#include "core/contract/method.hpp"

namespace alcove {

[[nodiscard]] Registry<MethodUnit> methods_registry();

} // namespace alcove
