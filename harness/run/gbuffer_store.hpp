#pragma once
// G-buffers on disk, channel by channel, so that sets of channels share what they have in common:
// cached under the content of all that decides them (geometry, pose, camera, size, precision, the
// sources that draw, the driver). Bytes as the texture holds them, LZ4-compressed in blocks, with a
// checksum. What drawing cost is kept beside them: it is the input cost of runs that load.

#include "core/frame/gbuffer.hpp"
#include "core/frame/gbuffer_part.hpp"
#include "harness/run/cache.hpp"
#include "harness/run/view_hash.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace alcove {

class GBufferStore {
  public:
    /// `folder` is the cache. `drawn_by` names what else decides the bits: the sources that draw,
    /// compiler, driver and CPU features.
    GBufferStore(std::filesystem::path folder, std::string drawn_by);

    /// Of one channel of a part of a frame, told as it is drawn.
    [[nodiscard]] std::string make_key(const Scene& scene, const FrameView& view,
                                       const Precision& precision, Channel channel,
                                       const GBufferPart& part);
    /// Of the times of a set of channels, taken with a timer.
    [[nodiscard]] std::string make_times_key(const Scene& scene, const FrameView& view,
                                             const Precision& precision, ChannelSet channels,
                                             const GBufferPart& part, const std::string& timer);

    [[nodiscard]] bool has(const std::string& key) const;
    /// Nothing if it is not there, damaged, or not of `bytes` bytes.
    [[nodiscard]] std::optional<std::vector<std::byte>> read(const std::string& key,
                                                             std::size_t bytes) const;
    void write(const std::string& key, std::span<const std::byte> texels) const;

    /// Nanoseconds, one a repeat. Nothing if they are not there or damaged.
    [[nodiscard]] std::optional<std::vector<std::int64_t>> read_times(const std::string& key) const;
    void write_times(const std::string& key, std::span<const std::int64_t> times_ns) const;

    /// Is the file what was written? For `cache verify`.
    [[nodiscard]] static bool is_intact(const std::filesystem::path& file);

  private:
    std::filesystem::path m_folder;
    std::string m_drawn_by;
    GeometryHash m_geometry;
    GeometryHash m_geometry_before;
};

} // namespace alcove
