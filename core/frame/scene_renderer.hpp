#pragma once
// Rasterises a scene into a G-buffer. Every matrix the GPU sees is relative to the current camera
// and composed in double.

#include "core/frame/frame_view.hpp"
#include "core/frame/full_screen.hpp"
#include "core/frame/gbuffer.hpp"

#include <map>
#include <vector>

namespace alcove {

/// Largest number of directional lights of a scene.
inline constexpr std::size_t kMaximumLights = 4;

class SceneRenderer {
  public:
    /// Uploads the scene's meshes. The scene must outlive the renderer. Throws InputError above
    /// kMaximumLights.
    SceneRenderer(const gl::Functions& gl, const Scene& scene);

    /// Fills all channels of the G-buffer.
    void render(const GBuffer& gbuffer, const FrameView& view);

  private:
    struct GpuMesh {
        gl::BufferHandle vertices;
        gl::BufferHandle indices;
        gl::VertexArrayHandle vertex_array;
        GLsizei index_count = 0;
    };
    /// A program and its uniforms' places for one set of channels.
    struct Pipeline {
        gl::Program program;
        GLint view_from_object = -1;
        GLint clip_from_view = -1;
        GLint normal_matrix = -1;
        GLint motion_matrix = -1;
        GLint albedo = -1;
        GLint instance_id = -1;
    };

    /// An object's transform to the world, now and one frame ago.
    struct ObjectTransform {
        std::size_t index;
        glm::dmat4 now;
        glm::dmat4 before;
    };
    struct Objects {
        std::vector<ObjectTransform> still;
        std::vector<ObjectTransform> moving;
    };

    const Pipeline& get_pipeline(ChannelSet channels);
    void clear(const GBuffer& gbuffer) const;
    void set_lights(const Pipeline& pipeline, const Camera& camera) const;
    [[nodiscard]] Objects sort_objects(const FrameView& view) const;
    void draw_objects(ChannelSet channels, GLuint framebuffer, const FrameView& view,
                      const glm::dmat4& projection, const std::vector<ObjectTransform>& objects);
    void rebuild_eye_depth(const GBuffer& gbuffer, const Camera& camera) const;

    const gl::Functions& m_gl;
    const Scene& m_scene;
    gl::ShaderLibrary m_library;
    std::vector<GpuMesh> m_meshes;
    std::map<ChannelSet, Pipeline> m_pipelines;
    FullScreenProgram m_rebuild;
};

} // namespace alcove
