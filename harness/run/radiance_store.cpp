#include "harness/run/radiance_store.hpp"

namespace alcove {
namespace {

void add_to(Image& image, const Image& summand) {
    const std::span<const float> values = summand.values();
    ALCOVE_ASSERT(image.values().size() == values.size(), "images of one shape");
    for (std::size_t i = 0; i < values.size(); ++i) {
        image.values()[i] += values[i];
    }
}

} // namespace

RadianceStore::RadianceStore(std::filesystem::path folder, std::string tracer_hash, Audit audit)
    : m_tracer_hash(std::move(tracer_hash)), m_pairs(std::move(folder), audit) {}

std::string RadianceStore::make_key(const Scene& scene, const FrameView& view,
                                    const PathSettings& settings) {
    Hasher hasher;
    hasher.add("radiance").add(m_tracer_hash);
    hasher.add(m_geometry.get(scene, view.time_s)).add(hash_lights(scene, view.time_s));
    hasher.add(settings.radius_m).add(to_text(settings.falloff)).add(to_text(settings.normals));
    hasher.add(static_cast<int>(settings.reach)).add(settings.bounces);
    hasher.add(settings.rays_per_half).add(settings.seed).add(settings.terminator_safe);
    add_view(hasher, scene, view);
    return hasher.finish_hex();
}

ReferencePair RadianceStore::get(const Scene& scene, const FrameView& view,
                                 const PathSettings& settings, bool& was_cached) {
    return m_pairs.get(
        make_key(scene, view, settings), {view.size, 3, Domain::linear},
        [&] {
            m_tracer.update(pose_geometry(scene, view.time_s));
            TracedRadiance traced =
                m_tracer.trace(view.camera, view.size, scene.compute_lights(view.time_s), settings);
            add_to(traced.indirect.a, traced.direct);
            add_to(traced.indirect.b, traced.direct);
            return std::move(traced.indirect);
        },
        was_cached);
}

} // namespace alcove
