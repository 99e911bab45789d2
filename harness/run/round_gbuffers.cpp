#include "harness/run/round_gbuffers.hpp"

#include "core/base/error.hpp"
#include "core/gl/texels.hpp"

#include <algorithm>

namespace alcove {

RoundGBuffers::RoundGBuffers(const gl::Functions& gl, const Scene& scene, ImageSize size,
                             const Precision& precision, GBufferStore store, Audit audit,
                             std::string timer)
    : m_gl(gl), m_scene(scene), m_sphere(compute_bounding_sphere(scene)), m_size(size),
      m_precision(precision), m_renderer(gl, scene), m_raster(m_renderer, m_sphere),
      m_store(std::move(store)), m_audit(audit), m_timer(std::move(timer)) {}

void RoundGBuffers::add(const GBufferKey& key) {
    if (m_gbuffers.contains(key)) {
        return;
    }
    const int samples = key.part.kind == PartKind::multisampled ? key.part.index : 1;
    m_gbuffers.emplace(key, Kept{GBuffer(m_gl, get_part_size(key.part, m_size, key.border),
                                         key.channels, m_precision, samples),
                                 std::nullopt});
}

FrameView RoundGBuffers::get_view(const GBufferKey& key, const FrameView& view) const {
    return make_part_view(key.part, view, key.border, m_sphere);
}

const GBufferKey& RoundGBuffers::find_nearer(const GBufferKey& key) const {
    const bool is_second = key.part.index == 2;
    const auto found = std::find_if(m_gbuffers.begin(), m_gbuffers.end(), [&](const auto& entry) {
        const GBufferKey& other = entry.first;
        return other.border == key.border &&
               (is_second
                    ? other.part.kind == PartKind::nearest &&
                          other.channels.contains(Channel::eye_depth)
                    : other.part.kind == PartKind::layer &&
                          other.part.index == key.part.index - 1 && other.channels == key.channels);
    });
    ALCOVE_ASSERT(found != m_gbuffers.end(), "a layer is added behind the one before it");
    return found->first;
}

void RoundGBuffers::draw(const GBufferKey& key, const FrameView& view) {
    Kept& kept = m_gbuffers.at(key);
    const GBuffer* nearer = nullptr;
    if (key.part.kind == PartKind::layer) {
        const GBufferKey& before = find_nearer(key);
        const std::optional<FrameView>& shows = m_gbuffers.at(before).shows;
        if (!shows || !shows_same(*shows, view)) {
            draw(before, view);
        }
        nearer = &get(before);
    }
    draw_part(m_renderer, key.part, kept.gbuffer, view, nearer != nullptr ? *nearer : kept.gbuffer);
    kept.shows = view;
    ++m_drawn;
}

void RoundGBuffers::draw_into(const GBuffer& gbuffer, const FrameView& view) {
    m_renderer.render(gbuffer, view);
    ++m_drawn;
}

bool RoundGBuffers::load(const GBufferKey& key, const FrameView& view) {
    if (key.part.kind == PartKind::multisampled) {
        return false;
    }
    const GBuffer& gbuffer = m_gbuffers.at(key).gbuffer;
    for (const ChannelInfo& info : kChannels) {
        if (!key.channels.contains(info.channel)) {
            continue;
        }
        const gl::Texture& texture = gbuffer.texture(info.channel);
        const std::size_t bytes = static_cast<std::size_t>(texture.size().width) *
                                  static_cast<std::size_t>(texture.size().height) *
                                  gl::get_texel_bytes(texture.format());
        const std::optional<std::vector<std::byte>> texels = m_store.read(
            m_store.make_key(m_scene, view, m_precision, info.channel, key.part), bytes);
        if (!texels) {
            return false;
        }
        gl::write_texels(m_gl, texture, *texels);
    }
    m_gbuffers.at(key).shows = view;
    ++m_loaded;
    return true;
}

void RoundGBuffers::store(const GBufferKey& key, const FrameView& view) {
    if (key.part.kind == PartKind::multisampled) {
        return;
    }
    const GBuffer& gbuffer = m_gbuffers.at(key).gbuffer;
    for (const ChannelInfo& info : kChannels) {
        if (!key.channels.contains(info.channel)) {
            continue;
        }
        const std::string name =
            m_store.make_key(m_scene, view, m_precision, info.channel, key.part);
        if (!m_store.has(name)) {
            m_store.write(name, gl::read_texels(m_gl, gbuffer.texture(info.channel)));
        }
    }
}

bool RoundGBuffers::is_stored(const GBufferKey& key, const FrameView& view) {
    return std::all_of(kChannels.begin(), kChannels.end(), [&](const ChannelInfo& info) {
        return !key.channels.contains(info.channel) ||
               m_store.has(m_store.make_key(m_scene, view, m_precision, info.channel, key.part));
    });
}

std::optional<std::vector<std::int64_t>> RoundGBuffers::read_times(const GBufferKey& key,
                                                                   const FrameView& view) {
    return m_store.read_times(
        m_store.make_times_key(m_scene, view, m_precision, key.channels, key.part, m_timer));
}

void RoundGBuffers::write_times(const GBufferKey& key, const FrameView& view,
                                std::span<const std::int64_t> times_ns) {
    m_store.write_times(
        m_store.make_times_key(m_scene, view, m_precision, key.channels, key.part, m_timer),
        times_ns);
}

void RoundGBuffers::audit(const GBufferKey& key, const FrameView& view) {
    const GBuffer& gbuffer = m_gbuffers.at(key).gbuffer;
    bool is_drawn = false;
    for (const ChannelInfo& info : kChannels) {
        const std::string name =
            m_store.make_key(m_scene, view, m_precision, info.channel, key.part);
        if (!key.channels.contains(info.channel) || !m_audit.draws(name)) {
            continue;
        }
        if (!is_drawn) {
            draw(key, view);
            is_drawn = true;
        }
        const std::vector<std::byte> drawn = gl::read_texels(m_gl, gbuffer.texture(info.channel));
        const std::optional<std::vector<std::byte>> cached = m_store.read(name, drawn.size());
        if (cached && *cached != drawn) {
            throw FailureError("audit",
                               "a cached G-buffer is not what is drawn now: frame " +
                                   std::to_string(view.index),
                               std::string(info.name),
                               "the same bytes; `alcove cache prune --limit "
                               "0` empties the cache");
        }
        ++m_audited;
    }
}

} // namespace alcove
