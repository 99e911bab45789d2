#pragma once
// Headless OpenGL through EGL, without a window or a display server.
// This work is based on: Khronos. EGL_EXT_platform_device, EGL_EXT_device_enumeration. 2014. and
// EGL_MESA_platform_surfaceless. 2016.

#include "core/gl/context.hpp"

#include <string>

namespace alcove::gl {

/// The ways into EGL, in the order in which they are tried.
enum class EglPlatform {
    either,      ///< device, then surfaceless where devices cannot be listed or give no context
    device,      ///< EGL_EXT_platform_device: hardware devices, then Mesa's software device.
                 ///< DeviceInfo.context is "egl-device"
    surfaceless, ///< EGL_MESA_platform_surfaceless. DeviceInfo.context is "egl-surfaceless"
};

/// Which devices are taken.
enum class EglDevices {
    hardware, ///< no software renderer
    any,      ///< hardware first
    software, ///< software renderers only: the stand-in for OSMesa
};

/// Opens libEGL.so.1 at run time and makes the first OpenGL 4.5 core context current that EGL gives
/// on this platform and these devices. A device counts as hardware by what its context says of
/// itself (classify_device), not by its place in EGL's list.
///
/// One EGL context may live at a time: displays are shared in a process, and the first to go would
/// take the other's along. For EglDevices::software on the surfaceless platform the environment
/// variable LIBGL_ALWAYS_SOFTWARE is set while the context is made: call it before there are other
/// threads.
///
/// Throws FailureError if the library is missing, or if there is no such context, with EGL's
/// reasons. Throws InputError naming the renderer if contexts were found and all were of devices
/// that are not taken.
[[nodiscard]] std::unique_ptr<Context> open_egl_context(EglPlatform platform, EglDevices devices);

} // namespace alcove::gl
