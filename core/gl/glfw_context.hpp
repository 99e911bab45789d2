#pragma once
// OpenGL in a hidden window of GLFW 3: what a desktop's driver gives to programs with a window.

#include "core/gl/context.hpp"

namespace alcove::gl {

/// Opens libglfw.so.3 at run time and makes the context of a hidden window current, OpenGL 4.5
/// core, vertical sync off. On the main thread only, and one at a time: GLFW is initialised with it
/// and ended with it. Throws FailureError with GLFW's reason if the library is missing, if there is
/// no display (set DISPLAY, or start under `xvfb-run -a`), or if the driver gives no such context.
[[nodiscard]] std::unique_ptr<Context> open_glfw_context();

} // namespace alcove::gl
