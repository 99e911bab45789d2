#include "harness/run/gbuffer_store.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cstring>

#include <lz4.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKind = "gbuffers";
constexpr std::string_view kMagic = "ALCVGBF1";
/// Compressed apart; no larger than what LZ4's interface counts in an int.
constexpr std::size_t kBlockBytes = std::size_t{4} << 20;
/// No channel of an image that parse_size accepts is larger: 16384 x 16384 RGBA32F.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{5} << 30;

std::uint64_t hash_bytes(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add_bytes(bytes);
    return hasher.finish64();
}

template <class T>
void append(std::string& text, T value) {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    text.append(bytes, sizeof(T));
}

/// Takes the next number off the front; false at the end.
template <class T>
bool take(std::string_view& text, T& value) {
    if (text.size() < sizeof(T)) {
        return false;
    }
    std::memcpy(&value, text.data(), sizeof(T));
    text.remove_prefix(sizeof(T));
    return true;
}

/// The texels of a file; nothing if a byte of it is not as it was written.
std::optional<std::vector<std::byte>> unpack(std::string_view text) {
    std::uint64_t bytes = 0;
    std::uint64_t checksum = 0;
    if (!text.starts_with(kMagic)) {
        return std::nullopt;
    }
    text.remove_prefix(kMagic.size());
    if (!take(text, bytes) || !take(text, checksum) || bytes > kLargestFile) {
        return std::nullopt;
    }
    std::vector<std::byte> texels(bytes);
    for (std::size_t begin = 0; begin < texels.size(); begin += kBlockBytes) {
        const std::size_t block = std::min(kBlockBytes, texels.size() - begin);
        std::uint32_t packed = 0;
        if (!take(text, packed) || packed > text.size()) {
            return std::nullopt;
        }
        const int unpacked =
            LZ4_decompress_safe(text.data(), reinterpret_cast<char*>(texels.data() + begin),
                                static_cast<int>(packed), static_cast<int>(block));
        if (unpacked != static_cast<int>(block)) {
            return std::nullopt;
        }
        text.remove_prefix(packed);
    }
    if (!text.empty() || hash_bytes(texels) != checksum) {
        return std::nullopt;
    }
    return texels;
}

} // namespace

GBufferStore::GBufferStore(fs::path folder, std::string drawn_by)
    : m_folder(std::move(folder)), m_drawn_by(std::move(drawn_by)) {}

std::string GBufferStore::make_key(const Scene& scene, const FrameView& view,
                                   const Precision& precision, Channel channel,
                                   const GBufferPart& part) {
    Hasher hasher;
    hasher.add(m_drawn_by).add(m_geometry.get(scene, view.time_s)).add(describe(precision));
    hasher.add(kChannels.at(static_cast<std::size_t>(channel)).name);
    if (channel == Channel::motion || channel == Channel::motion_depth) {
        hasher.add(m_geometry_before.get(scene, view.previous_time_s));
    }
    hasher.add(to_text(part));
    if (channel == Channel::direct_light) {
        hasher.add(hash_lights(scene, view.time_s));
    }
    add_view(hasher, scene, view);
    return hasher.finish_hex();
}

std::string GBufferStore::make_times_key(const Scene& scene, const FrameView& view,
                                         const Precision& precision, ChannelSet channels,
                                         const GBufferPart& part, const std::string& timer) {
    Hasher hasher;
    hasher.add("times").add(timer);
    for (const ChannelInfo& info : kChannels) {
        if (channels.contains(info.channel)) {
            hasher.add(make_key(scene, view, precision, info.channel, part));
        }
    }
    return hasher.finish_hex();
}

bool GBufferStore::has(const std::string& key) const {
    std::error_code error;
    return fs::is_regular_file(make_cache_path(m_folder, kKind, key, ".texels"), error);
}

std::optional<std::vector<std::byte>> GBufferStore::read(const std::string& key,
                                                         std::size_t bytes) const {
    const fs::path path = make_cache_path(m_folder, kKind, key, ".texels");
    if (!has(key)) {
        return std::nullopt;
    }
    std::optional<std::vector<std::byte>> texels = unpack(read_file(path, kLargestFile));
    if (!texels || texels->size() != bytes) {
        return std::nullopt;
    }
    mark_used(path);
    return texels;
}

void GBufferStore::write(const std::string& key, std::span<const std::byte> texels) const {
    std::string text(kMagic);
    append(text, std::uint64_t{texels.size()});
    append(text, hash_bytes(texels));
    std::string packed;
    for (std::size_t begin = 0; begin < texels.size(); begin += kBlockBytes) {
        const auto block = static_cast<int>(std::min(kBlockBytes, texels.size() - begin));
        packed.resize(static_cast<std::size_t>(LZ4_compressBound(block)));
        const int bytes =
            LZ4_compress_default(reinterpret_cast<const char*>(texels.data() + begin),
                                 packed.data(), block, static_cast<int>(packed.size()));
        ALCOVE_ASSERT(bytes > 0, "room for what does not compress");
        append(text, static_cast<std::uint32_t>(bytes));
        text.append(packed.data(), static_cast<std::size_t>(bytes));
    }
    write_cache_file(make_cache_path(m_folder, kKind, key, ".texels"), text);
}

std::optional<std::vector<std::int64_t>> GBufferStore::read_times(const std::string& key) const {
    const fs::path path = make_cache_path(m_folder, kKind, key, ".times");
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return std::nullopt;
    }
    constexpr std::uintmax_t kLargestTimes = std::uintmax_t{1} << 18;
    std::vector<std::int64_t> times;
    try {
        for (const std::string& line : split(read_file(path, kLargestTimes), '\n')) {
            if (!line.empty()) {
                times.push_back(parse_integer(line, path.string()));
            }
        }
    } catch (const InputError&) {
        return std::nullopt; // damaged: drawn and timed anew
    }
    mark_used(path);
    return times;
}

void GBufferStore::write_times(const std::string& key,
                               std::span<const std::int64_t> times_ns) const {
    std::string text;
    for (const std::int64_t time_ns : times_ns) {
        text += std::to_string(time_ns) + "\n";
    }
    write_cache_file(make_cache_path(m_folder, kKind, key, ".times"), text);
}

bool GBufferStore::is_intact(const fs::path& file) {
    if (file.extension() == ".times") {
        return true;
    }
    return unpack(read_file(file, kLargestFile)).has_value();
}

} // namespace alcove
