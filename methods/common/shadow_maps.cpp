#include "methods/common/shadow_maps.hpp"

#include "methods/common/layered_surfaces.hpp"

#include <cmath>

#include <glm/gtc/type_ptr.hpp>

namespace alcove {
namespace {

constexpr GLuint kFirstMapUnit = 12;

} // namespace

std::string make_shadow_map_counts(std::size_t faces) {
    return "const int kFaces = " + std::to_string(faces) + ";\n";
}

void ShadowMaps::draw(Raster& raster, std::span<const LightView> views) {
    ALCOVE_ASSERT(views.size() == 1 || views.size() == kCubeFaces, "one view or a cube's faces");
    while (m_maps.size() < views.size()) {
        m_maps.emplace_back(m_gl, ImageSize{m_side, m_side}, ChannelSet{Channel::eye_depth},
                            Precision{});
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        raster.draw(m_maps[i], views[i]);
    }
}

void ShadowMaps::bind(const FullScreenProgram& program, const Camera& viewer,
                      std::span<const LightView> views) const {
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto unit = static_cast<GLuint>(i);
        if (i < m_maps.size()) {
            m_gl.BindTextureUnit(kFirstMapUnit + unit, m_maps[i].texture(Channel::eye_depth).get());
        }
        const glm::mat4 matrix = compute_other_from_view(views[i].camera, viewer);
        const std::string name = "map_from_view[" + std::to_string(i) + "]";
        m_gl.UniformMatrix4fv(program.location(name.c_str()), 1, GL_FALSE, glm::value_ptr(matrix));
    }
    const LightView& view = views.front();
    const double extent =
        view.is_orthographic() ? view.half_extent_m : std::tan(0.5 * view.camera.fov_y_radians);
    m_gl.Uniform1f(program.location("map_extent"), static_cast<float>(extent));
    m_gl.Uniform1i(program.location("map_is_perspective"), view.is_orthographic() ? 0 : 1);
    m_gl.Uniform1f(program.location("map_side"), static_cast<float>(m_side));
}

} // namespace alcove
