#pragma once
// The shipped experiments, embedded at build time from harness/run/experiments.

#include "core/base/embedded_file.hpp"

#include <span>

namespace alcove {

[[nodiscard]] std::span<const EmbeddedFile> embedded_experiments();

} // namespace alcove
