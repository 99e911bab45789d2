#pragma once
// The G-buffers of a round: drawn, or loaded where an earlier run has left all of them.

#include "core/frame/raster.hpp"
#include "harness/run/gbuffer_store.hpp"

#include <map>
#include <optional>
#include <tuple>

namespace alcove {

/// Cells whose G-buffers are alike share one.
struct GBufferKey {
    ChannelSet channels;
    Border border;
    GBufferPart part;
    friend bool operator==(const GBufferKey&, const GBufferKey&) = default;
    friend bool operator<(const GBufferKey& a, const GBufferKey& b) {
        return std::tie(a.part, a.channels, a.border) < std::tie(b.part, b.channels, b.border);
    }
};

/// The G-buffer that every run rasterises.
inline const GBufferKey kBaseGBuffer{kBaseChannels, {}, {}};

class RoundGBuffers {
  public:
    /// Everything passed by reference must outlive this. `timer` names the clock of stored times.
    RoundGBuffers(const gl::Functions& gl, const Scene& scene, ImageSize size,
                  const Precision& precision, GBufferStore store, Audit audit, std::string timer);

    /// Allocates, unless it is there.
    void add(const GBufferKey& key);
    [[nodiscard]] const GBuffer& get(const GBufferKey& key) const {
        return m_gbuffers.at(key).gbuffer;
    }

    /// `view`, without border, as the key's part is drawn.
    [[nodiscard]] FrameView get_view(const GBufferKey& key, const FrameView& view) const;
    /// Draws the shadow maps of the frame's direct light, which every G-buffer shares and whose
    /// time is charged to none.
    void prepare_shadows(const FrameView& view) { m_renderer.prepare_shadows(view); }
    /// For methods; its frame is the caller's to set.
    [[nodiscard]] SceneRaster& raster() { return m_raster; }
    /// Rasterises; a layer on top of the one before it, which is drawn as well unless it shows this
    /// frame. `view` is that of get_view, here and below.
    void draw(const GBufferKey& key, const FrameView& view);
    /// Rasterises into a G-buffer of the caller's, which is never cached.
    void draw_into(const GBuffer& gbuffer, const FrameView& view);
    /// Uploads what the cache has; false if a channel is missing or damaged. Multisampled G-buffers
    /// are never cached: their texels cannot be read.
    [[nodiscard]] bool load(const GBufferKey& key, const FrameView& view);
    /// Puts what the G-buffer holds, which must be this frame, into the cache.
    void store(const GBufferKey& key, const FrameView& view);

    /// Are all its channels there?
    [[nodiscard]] bool is_stored(const GBufferKey& key, const FrameView& view);
    [[nodiscard]] std::optional<std::vector<std::int64_t>> read_times(const GBufferKey& key,
                                                                      const FrameView& view);
    void write_times(const GBufferKey& key, const FrameView& view,
                     std::span<const std::int64_t> times_ns);

    /// If the audit draws it: rasterises and compares with the cache, channel by channel. Throws
    /// FailureError if a byte differs.
    void audit(const GBufferKey& key, const FrameView& view);

    [[nodiscard]] std::size_t drawn() const noexcept { return m_drawn; }
    [[nodiscard]] std::size_t loaded() const noexcept { return m_loaded; }
    [[nodiscard]] std::size_t audited() const noexcept { return m_audited; }

  private:
    struct Kept {
        GBuffer gbuffer;
        std::optional<FrameView> shows; ///< what was drawn or loaded last
    };
    [[nodiscard]] const GBufferKey& find_nearer(const GBufferKey& key) const;

    const gl::Functions& m_gl;
    const Scene& m_scene;
    BoundingSphere m_sphere;
    ImageSize m_size;
    Precision m_precision;
    SceneRenderer m_renderer;
    SceneRaster m_raster;
    GBufferStore m_store;
    Audit m_audit;
    std::string m_timer;
    std::map<GBufferKey, Kept> m_gbuffers;
    std::size_t m_drawn = 0;
    std::size_t m_loaded = 0;
    std::size_t m_audited = 0;
};

} // namespace alcove
