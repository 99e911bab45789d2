#pragma once
// The flags that say what draws. Shared by every verb that opens a context.

#include "core/gl/context.hpp"

#include <memory>
#include <string>

namespace CLI {
class App;
} // namespace CLI

namespace alcove {

struct ContextChoice {
    gl::ContextKind kind = gl::ContextKind::autodetect;
    gl::SoftwarePolicy policy = gl::SoftwarePolicy::refuse;
};

struct ContextFlags {
    std::string kind = "auto";
    bool allow_software = false;

    /// The flags must outlive the parsing.
    void add_to(CLI::App& app);
    /// Throws InputError with the nearest name.
    [[nodiscard]] ContextChoice parse() const;
};

/// Opens it as gl::open_context does, and says on standard error where `auto` did not become
/// OSMesa.
[[nodiscard]] std::unique_ptr<gl::Context> open_chosen_context(const ContextChoice& chosen);

} // namespace alcove
