#include "core/base/cache_folder.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/hash.hpp"
#include "methods/shanmugam_arikan/sphere_clusters.hpp"

#include <cstring>
#include <optional>
#include <string>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// Raised whenever find_clusters gives other clusters for the same geometry.
constexpr std::uint32_t kClustersVersion = 1;

std::string make_key(const PosedGeometry& rest, const ClusterSettings& settings) {
    Hasher hasher;
    hasher.add(kClustersVersion).add(settings.spheres).add(static_cast<int>(settings.members));
    for (const PosedObject& object : rest.objects) {
        hasher.add_bytes(std::as_bytes(object.positions()));
        hasher.add_bytes(std::as_bytes(std::span(object.mesh->indices)));
        hasher.add_bytes(std::as_bytes(std::span(&object.origin_from_object, 1)));
    }
    return hasher.finish_hex();
}

template <class T>
void append(std::string& bytes, std::span<const T> values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

std::string make_checksum(std::string_view bytes) {
    return Hasher().add(bytes).finish_hex();
}

/// Checksum, two counts, clusters, members: this machine's own bytes.
std::string write_clusters(const ClusterSet& set) {
    std::string body;
    const std::array<std::uint64_t, 2> counts{set.clusters.size(), set.members.size()};
    append(body, std::span<const std::uint64_t>(counts));
    append(body, std::span<const SphereCluster>(set.clusters));
    append(body, std::span<const ClusterMember>(set.members));
    return make_checksum(body) + body;
}

template <class T>
bool take(std::string_view& bytes, std::span<T> values) {
    if (bytes.size() < values.size_bytes()) {
        return false;
    }
    std::memcpy(values.data(), bytes.data(), values.size_bytes());
    bytes.remove_prefix(values.size_bytes());
    return true;
}

/// No size of the file is trusted before its checksum is.
std::optional<ClusterSet> read_clusters(std::string_view bytes) {
    constexpr std::size_t kChecksum = 32;
    if (bytes.size() < kChecksum ||
        make_checksum(bytes.substr(kChecksum)) != bytes.substr(0, kChecksum)) {
        return std::nullopt;
    }
    bytes.remove_prefix(kChecksum);
    std::array<std::uint64_t, 2> counts{};
    if (!take(bytes, std::span<std::uint64_t>(counts)) ||
        bytes.size() != counts[0] * sizeof(SphereCluster) + counts[1] * sizeof(ClusterMember)) {
        return std::nullopt;
    }
    ClusterSet set;
    set.clusters.resize(counts[0]);
    set.members.resize(counts[1]);
    take(bytes, std::span(set.clusters));
    take(bytes, std::span(set.members));
    return set;
}

} // namespace

ClusterSet get_clusters(const PosedGeometry& rest, const ClusterSettings& settings) {
    const fs::path path =
        make_cache_path(get_cache_folder(), "spheres", make_key(rest, settings), ".clusters");
    if (fs::is_regular_file(path)) {
        try {
            if (std::optional<ClusterSet> set = read_clusters(read_file(path))) {
                mark_used(path);
                return std::move(*set);
            }
        } catch (const InputError&) {
            // A damaged file of the cache is no input of the user's: it is made anew below.
        }
    }
    ClusterSet set = find_clusters(rest, settings);
    write_cache_file(path, write_clusters(set));
    return set;
}

} // namespace alcove
