#pragma once
// What this binary was built from. build_info.cpp is generated at build time.

namespace alcove {

struct BuildInfo {
    const char* id; ///< hash of sources, compiler and flags: 16 hexadecimal digits
    const char* compiler;
    const char* flags;
    const char* type; ///< "Release"
    // Hashes of parts of the sources, for caches: 16 hexadecimal digits.
    const char* frame_id;   ///< what draws G-buffers: core
    const char* capture_id; ///< what takes and measures images: core and harness/run
};

[[nodiscard]] BuildInfo get_build_info();

} // namespace alcove
