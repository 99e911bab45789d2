#pragma once
// The lights of a frame as the rasteriser's shader takes them: one block of numbers relative to the
// camera, and one atlas of shadow maps. This work is based on: Williams. Casting curved shadows on
// curved surfaces. 1978; the bias that follows the slope is that of Ritschel, Grosch, Seidel.
// Approximating dynamic global illumination in image space. 2009, figure 8.

#include "core/frame/light_view.hpp"
#include "core/gl/program.hpp"

#include <optional>
#include <vector>

namespace alcove {

/// Largest number of directional lights of a scene, and of points.
inline constexpr std::size_t kMostDirectionalLights = 4;
inline constexpr std::size_t kMostPointLights = 4;

class SceneLights {
  public:
    /// Throws InputError above the numbers that are allowed.
    SceneLights(const gl::Functions& gl, const Scene& scene);

    /// The lights of a time. Their shadow maps are stale then, unless it is the time before.
    void set_time(const Scene& scene, double time_s);

    /// One shadow map: what it sees, and the texels of the atlas that it lies in.
    struct Face {
        LightView view;
        int left = 0;
        int bottom = 0;
    };
    [[nodiscard]] const std::vector<Face>& faces() const noexcept { return m_faces; }
    [[nodiscard]] bool are_shadows_stale() const noexcept { return m_is_stale; }
    /// Clears the atlas for drawing; what is drawn then are the maps of the time that is set.
    void clear_atlas();
    [[nodiscard]] GLuint atlas_framebuffer() const noexcept { return m_framebuffer.get(); }
    [[nodiscard]] int face_side() const noexcept { return m_side; }

    /// Names what the shader includes besides `core/frame/lights.glsl`: "light_counts.glsl".
    [[nodiscard]] static std::string make_shader_counts();
    static void connect(const gl::Program& program);
    /// For drawing through a camera.
    void bind(const Camera& camera);

  private:
    [[nodiscard]] std::vector<float> pack(const Camera& camera) const;

    const gl::Functions& m_gl;
    BoundingSphere m_sphere;
    Lights m_lights;
    std::optional<double> m_time_s;
    bool m_is_stale = false;
    std::vector<Face> m_faces;
    std::vector<int> m_first_faces; ///< one a light, directional first; -1: no shadow
    int m_side = 0;                 ///< texels of a face
    int m_columns = 1;
    gl::Texture m_atlas; ///< eye depth of the faces' cameras; infinite where nothing is
    gl::Texture m_raster_depth;
    gl::FramebufferHandle m_framebuffer;
    gl::BufferHandle m_block;
};

} // namespace alcove
