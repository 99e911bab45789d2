#include "core/base/file.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// An open file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int value) : m_value(value) {}
    ~Descriptor() {
        if (m_value >= 0) {
            ::close(m_value);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return m_value; }

  private:
    int m_value;
};

[[noreturn]] void throw_system(const fs::path& path, std::string_view action) {
    throw FailureError(path.string(), std::string(action) + ": " + std::strerror(errno));
}

void sync_folder(const fs::path& folder) {
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (descriptor.get() >= 0) {
        ::fsync(descriptor.get());
    }
}

fs::path parent_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

} // namespace

void write_file_atomically(const fs::path& path, std::string_view bytes) {
    const fs::path folder = parent_of(path);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw FailureError(folder.string(), "cannot create the folder: " + error.message());
    }
    const fs::path temporary = path.string() + ".tmp";
    try {
        const Descriptor descriptor(
            ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
        if (descriptor.get() < 0) {
            throw_system(path, "cannot write");
        }
        for (std::size_t done = 0; done < bytes.size();) {
            const ::ssize_t written =
                ::write(descriptor.get(), bytes.data() + done, bytes.size() - done);
            if (written < 0 && errno == EINTR) {
                continue;
            }
            if (written < 0) {
                throw_system(path, "cannot write");
            }
            done += static_cast<std::size_t>(written);
        }
        if (::fsync(descriptor.get()) != 0) {
            throw_system(path, "cannot write");
        }
        if (::rename(temporary.c_str(), path.c_str()) != 0) {
            throw_system(path, "cannot rename into place");
        }
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
    sync_folder(folder);
}

void publish_folder(const fs::path& temporary, const fs::path& final_path) {
    sync_folder(temporary);
    if (::rename(temporary.c_str(), final_path.c_str()) != 0) {
        throw_system(final_path, "cannot rename into place");
    }
    sync_folder(parent_of(final_path));
}

void create_output_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) {
        throw InputError(path.string(), "cannot create the output folder: " + error.message());
    }
    const fs::path probe = path / ".alcove-write-probe";
    {
        const Descriptor descriptor(
            ::open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
        if (descriptor.get() < 0) {
            throw InputError(path.string(), std::string("cannot write to the output folder: ") +
                                                std::strerror(errno));
        }
    }
    ::unlink(probe.c_str());
}

std::string read_file(const fs::path& path, std::uintmax_t limit) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw InputError(path.string(), "no such file");
    }
    if (!fs::is_regular_file(status)) {
        throw InputError(path.string(), "not a regular file");
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (error || size > limit) {
        throw InputError(path.string(), "too large", std::to_string(size) + " bytes",
                         "at most " + std::to_string(limit));
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream || stream.bad()) {
        if (size != 0) {
            throw InputError(path.string(), "cannot be read");
        }
    }
    return std::move(text).str();
}

fs::path resolve_inside(const fs::path& folder, std::string_view relative) {
    const fs::path path{relative};
    const bool has_scheme = relative.find(':') != std::string_view::npos;
    const bool climbs = std::find(path.begin(), path.end(), fs::path("..")) != path.end();
    if (relative.empty() || path.is_absolute() || has_scheme || climbs ||
        relative.find('\\') != std::string_view::npos ||
        relative.find('\0') != std::string_view::npos) {
        throw InputError(folder.string(), "a reference leaves the file's folder", relative,
                         "a relative path below it, without `..`");
    }
    const fs::path base = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder);
    fs::path joined = fs::weakly_canonical(base / path);
    const auto [mismatch, unused] =
        std::mismatch(base.begin(), base.end(), joined.begin(), joined.end());
    static_cast<void>(unused);
    if (mismatch != base.end()) {
        throw InputError(folder.string(), "a reference leaves the file's folder", relative,
                         "a path below it, also behind symbolic links");
    }
    return joined;
}

} // namespace alcove
