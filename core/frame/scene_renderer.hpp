#pragma once
// Rasterises a scene into a G-buffer. Every matrix the GPU sees is relative to the current camera
// and composed in double.

#include "core/frame/draw_list.hpp"
#include "core/frame/frame_view.hpp"
#include "core/frame/full_screen.hpp"
#include "core/frame/gbuffer.hpp"
#include "core/frame/gbuffer_part.hpp"
#include "core/frame/scene_lights.hpp"

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace alcove {

/// What one frame cost in triangles.
struct DrawCounts {
    std::size_t drawn = 0;   ///< triangles handed to the GPU for the G-buffer
    std::size_t hiders = 0;  ///< and before that to find out what they hide
    std::size_t objects = 0; ///< drawn, whole or in part
};

class SceneRenderer {
  public:
    /// Uploads the scene's meshes. The scene must outlive the renderer. Culling changes no bit of
    /// an image, only its cost. Throws InputError above the lights that SceneLights takes.
    SceneRenderer(const gl::Functions& gl, const Scene& scene,
                  Culling culling = Culling::occlusion);

    /// Draws the shadow maps of the frame's time, unless they are there: what a caller does first
    /// who takes the time of `render`, which does it otherwise.
    void prepare_shadows(const FrameView& view);
    /// Fills all channels of the G-buffer.
    void render(const GBuffer& gbuffer, const FrameView& view);
    /// As a light sees the frame's scene: front and back faces, every triangle in its view. The
    /// G-buffer is square; depth is 32F, not reversed.
    void render_light_view(const GBuffer& gbuffer, const LightView& light, const FrameView& view);
    /// With what lies behind the surfaces of `nearer`, a G-buffer of the same view: depth peeling,
    /// front and back faces alike. This work is based on: Everitt. Interactive order-independent
    /// transparency. 2001. Throws InputError unless both keep eye depth as float32.
    void render_layer(const GBuffer& gbuffer, const FrameView& view, const GBuffer& nearer);
    /// With the nearest surfaces that are seen from behind.
    void render_back_faces(const GBuffer& gbuffer, const FrameView& view);
    /// Of the last render.
    [[nodiscard]] const DrawCounts& counts() const noexcept { return m_counts; }

  private:
    /// A program and its uniforms' places for one set of channels and vertex streams.
    struct Pipeline {
        gl::Program program;
        GLint clip_from_view = -1;
        GLint previous_world_from_object = -1;
        bool is_lit = false;
    };
    /// How a pass differs from that of the nearest surfaces.
    struct Pass {
        FaceRule faces = FaceRule::as_listed;
        const gl::Texture* nearer_depth = nullptr; ///< of a peeled pass
    };
    using PipelineKey = std::tuple<ChannelSet, VertexStreams, bool>; ///< true: peeled

    const Pipeline& get_pipeline(const PipelineKey& key);
    void clear(const GBuffer& gbuffer) const;
    /// Where everything is, and on the GPU what deforms.
    [[nodiscard]] FramePose pose_frame(const FrameView& view);
    void render(const GBuffer& gbuffer, const FrameView& view, const Pass& pass);
    void draw_shadows(const FramePose& pose);
    void draw_from_light(const LightView& light, const FramePose& pose, ChannelSet channels,
                         GLuint framebuffer, ImageSize size);
    [[nodiscard]] VisibleSet find_visible(const FrameView& view, const FramePose& pose,
                                          const GBuffer& gbuffer, const Pass& pass,
                                          const glm::dmat4& projection);
    void draw(const DrawList& list, ChannelSet channels, GLuint framebuffer, const Camera& camera,
              const glm::dmat4& projection, const Pass& pass);
    void rebuild_eye_depth(const GBuffer& gbuffer, const Camera& camera) const;

    const gl::Functions& m_gl;
    const Scene& m_scene;
    Culling m_culling;
    gl::ShaderLibrary m_library;
    SceneGeometry m_geometry;
    std::vector<gl::TextureHandle> m_textures;
    SceneLights m_lights;
    bool m_has_placed_light; ///< lights that need a surface's position: with shadow, or points
    SceneCuller m_culler;
    DrawList m_still;
    DrawList m_moving;
    gl::Texture m_hider_depth; ///< eye depth of what hides most
    std::map<PipelineKey, Pipeline> m_pipelines;
    FullScreenProgram m_rebuild;
    DrawCounts m_counts;
};

/// Draws any part. `nearer` is the layer before, of the same view, where the part is a layer.
void draw_part(SceneRenderer& renderer, const GBufferPart& part, const GBuffer& gbuffer,
               const FrameView& view, const GBuffer& nearer);

} // namespace alcove
