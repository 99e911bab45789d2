#pragma once
// The embedded default: Mesa's off-screen software rasteriser, without a display or a GPU.

#include "core/gl/context.hpp"

namespace alcove::gl {

/// Opens libOSMesa at run time. Throws FailureError if it is missing or gives no OpenGL 4.5 core
/// context.
[[nodiscard]] std::unique_ptr<Context> open_osmesa_context();

} // namespace alcove::gl
