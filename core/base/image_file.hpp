#pragma once
// PNG, EXR and Radiance HDR files (OpenImageIO). A file says what its values mean in the metadata
// `alcove:domain`; pixel order is top row first in both.

#include "core/base/domain.hpp"
#include "core/base/image.hpp"

#include <filesystem>
#include <optional>

namespace alcove {

struct ImageFile {
    Image image; ///< integer files are read to [0,1] (code / 255 or / 65535)
    Domain domain = Domain::linear;
};

/// Reads a file. `domain` overrides; otherwise the file's metadata, else srgb for integer files,
/// linear for float ones. Throws InputError if the file is missing, unreadable, truncated or larger
/// than 2^28 values.
[[nodiscard]] ImageFile read_image_file(const std::filesystem::path& path,
                                        std::optional<Domain> domain = std::nullopt);

enum class ExrType { half_float, full_float };

/// Writes a ZIP-compressed EXR, atomically. Throws FailureError.
void write_exr(const std::filesystem::path& path, const Image& image, Domain domain,
               ExrType type = ExrType::full_float);

/// Writes an 8-bit PNG of values in [0,1] (clamped, rounded), atomically; the values must already
/// be display codes.
void write_png(const std::filesystem::path& path, const Image& codes, Domain domain);

} // namespace alcove
