#pragma once
// The embedded default: Mesa's off-screen software rasteriser, without a display or a GPU.

#include "core/gl/context.hpp"

namespace alcove::gl {

/// Whether the system's loader can open libOSMesa. Mesa 25.1 and later no longer have it.
[[nodiscard]] bool is_osmesa_installed();

/// Opens libOSMesa at run time. Throws FailureError if it is missing or gives no OpenGL 4.5 core
/// context.
[[nodiscard]] std::unique_ptr<Context> open_osmesa_context();

} // namespace alcove::gl
