#pragma once
// Frames of a scene through any method, one after the other, as the runner shows them; what the
// method sees of a frame can be changed on the way.

#include "core/contract/method_gbuffers.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace alcove {

/// Writes over channels before the method sees them. The G-buffer is larger than the image by
/// `border` on each side.
using GBufferEdit = std::function<void(const GBuffer& gbuffer, const Border& border)>;

struct ShotOptions {
    std::uint32_t seed = 1;
    bool wants_history_state = false;
    GBufferEdit edit; ///< may be empty
};

struct RigShot {
    Image visibility;
    std::optional<Image> history_state;
    std::vector<std::string> passes;
};

class SceneRig {
  public:
    /// The scene must outlive it.
    SceneRig(gl::Context& context, const Scene& scene, ImageSize size,
             const Precision& precision = {});

    [[nodiscard]] const Scene& scene() const noexcept { return m_scene; }
    [[nodiscard]] ImageSize size() const noexcept { return m_size; }
    /// With objects_may_move found out.
    [[nodiscard]] FrameView get_view(int frame, bool starts_segment = false) const;

    /// One frame. Asserts that the method leaves a visibility. Throws FailureError on GL errors.
    [[nodiscard]] RigShot shoot(Method& method, const FrameView& view,
                                const ShotOptions& options = {});
    /// `frames` >= 1 frames of the held pose behind a fresh start; the last one is kept.
    [[nodiscard]] RigShot settle(Method& method, int frame, int frames,
                                 const ShotOptions& options = {});

    /// Eye depth in full precision, whatever the methods are given; infinite on the background.
    [[nodiscard]] Image read_depth(const FrameView& view);

  private:
    MethodGBuffers& find_gbuffers(const MethodRequests& requests);

    gl::Context& m_context;
    const Scene& m_scene;
    ImageSize m_size;
    Precision m_precision;
    SceneRenderer m_renderer;
    struct Buffers {
        MethodRequests requests;
        std::unique_ptr<MethodGBuffers> gbuffers;
    };
    std::vector<Buffers> m_buffers;
    std::optional<GBuffer> m_depth; ///< eye depth in full precision
};

} // namespace alcove
