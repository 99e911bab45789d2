#pragma once
// A frame's scene, drawn from other places than the viewer's: shadow maps and reflective shadow
// maps that belong to a method. What is drawn counts as that method's work.

#include "core/frame/light_view.hpp"
#include "core/frame/scene_renderer.hpp"

namespace alcove {

class Raster {
  public:
    virtual ~Raster() = default;
    Raster(const Raster&) = delete;
    Raster& operator=(const Raster&) = delete;
    /// As SceneRenderer::render_light_view. Leaves the viewport at the G-buffer's size.
    virtual void draw(const GBuffer& gbuffer, const LightView& light) = 0;
    /// Around all objects as they stand at time 0.
    [[nodiscard]] virtual const BoundingSphere& get_bounding_sphere() const = 0;

  protected:
    Raster() = default;
};

/// The raster of one frame.
class SceneRaster final : public Raster {
  public:
    /// `renderer` must outlive this.
    SceneRaster(SceneRenderer& renderer, const BoundingSphere& sphere)
        : m_renderer(renderer), m_sphere(sphere) {}
    void set_frame(const FrameView& view) { m_view = view; }
    void draw(const GBuffer& gbuffer, const LightView& light) override {
        m_renderer.render_light_view(gbuffer, light, m_view);
    }
    [[nodiscard]] const BoundingSphere& get_bounding_sphere() const override { return m_sphere; }

  private:
    SceneRenderer& m_renderer;
    BoundingSphere m_sphere;
    FrameView m_view;
};

} // namespace alcove
