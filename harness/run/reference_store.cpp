#include "harness/run/reference_store.hpp"

namespace alcove {

ReferenceStore::ReferenceStore(std::filesystem::path folder, std::string tracer_hash, Audit audit)
    : m_tracer_hash(std::move(tracer_hash)), m_pairs(std::move(folder), audit) {}

std::string ReferenceStore::make_key(const Scene& scene, const FrameView& view,
                                     const TraceSettings& settings) {
    Hasher hasher;
    hasher.add(m_tracer_hash).add(m_geometry.get(scene, view.time_s));
    hasher.add(describe(settings.target));
    hasher.add(settings.rays_per_half).add(settings.seed).add(settings.terminator_safe);
    add_view(hasher, scene, view);
    return hasher.finish_hex();
}

ReferencePair ReferenceStore::get(const Scene& scene, const FrameView& view,
                                  const TraceSettings& settings, bool& was_cached) {
    return m_pairs.get(
        make_key(scene, view, settings), {view.size, 1, Domain::visibility},
        [&] {
            m_tracer.update(pose_geometry(scene, view.time_s));
            return m_tracer.trace(view.camera, view.size, settings);
        },
        was_cached);
}

} // namespace alcove
