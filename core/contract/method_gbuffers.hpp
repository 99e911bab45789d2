#pragma once
// All G-buffers that one method declares, drawn frame by frame: for whoever shows a method frames
// without sharing them between methods.

#include "core/contract/method.hpp"
#include "core/frame/scene_renderer.hpp"

namespace alcove {

class MethodGBuffers {
  public:
    /// For images of `size`; `renderer` and its scene must outlive this.
    MethodGBuffers(const gl::Functions& gl, SceneRenderer& renderer, const Scene& scene,
                   const MethodRequests& requests, ImageSize size, const Precision& precision);

    /// Draws a frame of the walkthrough, told without border.
    void draw(const FrameView& view);
    /// The base channels and what was requested, border included.
    [[nodiscard]] const GBuffer& main() const noexcept { return m_main; }
    [[nodiscard]] const Border& border() const noexcept { return m_border; }
    /// The frame that was drawn last with its lights: all else is the caller's. Holds until the
    /// next frame is drawn.
    [[nodiscard]] MethodInputs make_inputs();

  private:
    struct Part {
        GBufferPart part;
        GBuffer gbuffer;
        FrameView view;
    };
    SceneRenderer& m_renderer;
    const Scene& m_scene;
    BoundingSphere m_sphere;
    SceneRaster m_raster;
    Surroundings m_surroundings;
    Lights m_lights;
    Border m_border;
    FrameView m_view;
    GBuffer m_main;
    std::vector<Part> m_parts;
};

/// Puts a part's G-buffer, and the view of an extra one, to its place in a method's inputs.
void add_part(MethodInputs& inputs, const GBufferPart& part, const GBuffer& gbuffer,
              const FrameView& view);

} // namespace alcove
