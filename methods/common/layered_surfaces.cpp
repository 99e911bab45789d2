#include "methods/common/layered_surfaces.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr GLuint kLayerUnit = 5;
constexpr GLuint kViewUnit = 8;

} // namespace

glm::mat4 compute_other_from_view(const Camera& other, const Camera& viewer) {
    const glm::dmat3 other_from_world = glm::transpose(other.world_from_view);
    glm::dmat4 matrix(other_from_world * viewer.world_from_view);
    matrix[3] = glm::dvec4(other_from_world * (viewer.position - other.position), 1.0);
    return glm::mat4(matrix);
}

std::string make_layer_counts(int layers, int views, bool is_clamped) {
    return "const int kLayers = " + std::to_string(layers) +
           ";\nconst int kViews = " + std::to_string(views) +
           ";\nconst bool kIsClamped = " + (is_clamped ? "true" : "false") + ";\n";
}

void bind_layered_surfaces(const gl::Functions& gl, const FullScreenProgram& program,
                           const MethodInputs& inputs) {
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    gl.Uniform2f(program.location("tangents"), tangents.x, tangents.y);
    gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
    for (std::size_t i = 0; i < inputs.layers.size(); ++i) {
        gl.BindTextureUnit(kLayerUnit + static_cast<GLuint>(i),
                           inputs.layers[i]->texture(Channel::eye_depth).get());
    }
    for (std::size_t i = 0; i < inputs.views.size(); ++i) {
        const MethodInputs::View& view = inputs.views[i];
        const std::string index = "[" + std::to_string(i) + "]";
        gl.BindTextureUnit(kViewUnit + static_cast<GLuint>(i),
                           view.gbuffer->texture(Channel::eye_depth).get());
        const glm::mat4 matrix = compute_other_from_view(view.view.camera, inputs.view.camera);
        gl.UniformMatrix4fv(program.location(("other_from_view" + index).c_str()), 1, GL_FALSE,
                            glm::value_ptr(matrix));
        const glm::vec2 other(compute_tangents(view.view.camera, view.view.size));
        gl.Uniform2f(program.location(("other_tangents" + index).c_str()), other.x, other.y);
    }
}

} // namespace alcove
