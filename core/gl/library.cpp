#include "core/gl/library.hpp"

#include "core/base/error.hpp"

#include <dlfcn.h>
#include <utility>

namespace alcove::gl {
namespace {

/// Null if none can be opened; `reason` is then the loader's about the first name.
void* try_open(std::span<const char* const> names, std::string& reason) {
    for (const char* name : names) {
        if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
            return handle;
        }
        const char* words = dlerror();
        if (reason.empty() && words != nullptr) {
            reason = words;
        }
    }
    return nullptr;
}

} // namespace

Library::Library(std::string part, std::span<const char* const> names, const char* package)
    : m_part(std::move(part)) {
    std::string reason;
    m_handle = try_open(names, reason);
    if (m_handle == nullptr) {
        throw FailureError(m_part, "the library cannot be opened", reason,
                           std::string("the package ") + package);
    }
}

Library::Library(Library&& other) noexcept
    : m_part(std::move(other.m_part)), m_handle(std::exchange(other.m_handle, nullptr)) {}

Library::~Library() {
    if (m_handle != nullptr) {
        dlclose(m_handle);
    }
}

void* Library::find_address(const char* name) const {
    void* address = dlsym(m_handle, name);
    if (address == nullptr) {
        throw FailureError(m_part, "the library lacks a function", name);
    }
    return address;
}

bool can_open_library(std::span<const char* const> names) {
    std::string reason;
    void* handle = try_open(names, reason);
    if (handle != nullptr) {
        dlclose(handle);
    }
    return handle != nullptr;
}

} // namespace alcove::gl
