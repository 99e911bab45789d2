#pragma once
// What this binary was built from. build_info.cpp is generated at build time.

namespace alcove {

struct BuildInfo {
    const char* id; ///< hash of sources, compiler and flags: 16 hexadecimal digits
    const char* compiler;
    const char* flags;
    const char* type; ///< "Release"
};

[[nodiscard]] BuildInfo get_build_info();

} // namespace alcove
