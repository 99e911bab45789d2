#include "harness/app/context_flags.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {

void ContextFlags::add_to(CLI::App& app) {
    app.add_option("--context", kind,
                   "auto (OSMesa, or EGL on llvmpipe where a system no longer has it), osmesa, "
                   "egl (a GPU without a display), glfw (a GPU with one)")
        ->capture_default_str();
    app.add_flag("--allow-software", allow_software,
                 "accept a software renderer where egl or glfw asked for a GPU");
}

ContextChoice ContextFlags::parse() const {
    return {gl::parse_context_kind(kind),
            allow_software ? gl::SoftwarePolicy::allow : gl::SoftwarePolicy::refuse};
}

std::unique_ptr<gl::Context> open_chosen_context(const ContextChoice& chosen) {
    std::unique_ptr<gl::Context> context = gl::open_context(chosen.kind, chosen.policy);
    const gl::DeviceInfo& device = context->device();
    if (chosen.kind == gl::ContextKind::autodetect && device.context != "osmesa") {
        fmt::print(stderr, "alcove: libOSMesa cannot be opened; drawing with {} on {}\n",
                   device.context, device.renderer);
    }
    return context;
}

} // namespace alcove
