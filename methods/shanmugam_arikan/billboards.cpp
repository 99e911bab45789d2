#include "methods/shanmugam_arikan/billboards.hpp"

#include "methods/common/shaders.hpp"
#include "methods/shanmugam_arikan/sphere_occlusion.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/ext/matrix_transform.hpp>

namespace alcove {

Billboards::Billboards(const gl::Functions& gl, const ShanmugamArikanParams& params,
                       const ParameterBlock& parameters)
    : m_gl(gl), m_params(params), m_parameters(parameters),
      m_program(gl::build_program(
          gl, make_method_shader_library(),
          {{GL_VERTEX_SHADER, "methods/shanmugam_arikan/shanmugam_arikan_far.vert.glsl"},
           {GL_FRAGMENT_SHADER, "methods/shanmugam_arikan/shanmugam_arikan_far.frag.glsl"}},
          parameters.generated_files())) {
    m_parameters.connect(m_program);
}

void Billboards::resize(ImageSize size) {
    m_result = gl::Texture(m_gl, GL_R32F, size);
    m_framebuffer = gl::create_framebuffer(m_gl, {&m_result});
}

const gl::Texture& Billboards::render(const MethodInputs& inputs, PassRecorder& passes) {
    ALCOVE_ASSERT(inputs.geometry != nullptr, "posed geometry was requested");
    if (m_scene != inputs.geometry->scene) {
        find_spheres(*inputs.geometry->scene);
    }
    {
        const auto pass = passes.scope("shanmugam_arikan/spheres");
        place_spheres(inputs);
    }
    const auto pass = passes.scope("shanmugam_arikan/far");
    draw(inputs);
    return m_result;
}

/// Of the pose at time 0, whichever frame comes first: equal frames give equal images.
void Billboards::find_spheres(const Scene& scene) {
    m_scene = &scene;
    m_poser.emplace(get_clusters(pose_geometry(scene, 0.0), {m_params.spheres, m_params.members}),
                    m_params.radius_rule, m_params.sphere_push_back);
    const std::vector<Instance> room(std::max<std::size_t>(m_poser->size(), 1));
    m_buffer = gl::create_buffer(m_gl, std::as_bytes(std::span(room)), GL_DYNAMIC_STORAGE_BIT);
    GLuint name = 0;
    m_gl.CreateVertexArrays(1, &name);
    m_vertex_array = gl::VertexArrayHandle(m_gl, name);
    m_gl.VertexArrayVertexBuffer(name, 0, m_buffer.get(), 0, sizeof(Instance));
    m_gl.VertexArrayBindingDivisor(name, 0, 1);
    for (const auto& [attribute, offset] :
         {std::pair{0u, offsetof(Instance, sphere)}, {1u, offsetof(Instance, rectangle)}}) {
        m_gl.EnableVertexArrayAttrib(name, attribute);
        m_gl.VertexArrayAttribFormat(name, attribute, 4, GL_FLOAT, GL_FALSE,
                                     static_cast<GLuint>(offset));
        m_gl.VertexArrayAttribBinding(name, attribute, 0);
    }
}

void Billboards::place_spheres(const MethodInputs& inputs) {
    const PosedGeometry& geometry = *inputs.geometry;
    const glm::dmat4 view_from_origin = compute_view_from_object(
        inputs.view.camera, glm::translate(glm::dmat4(1.0), geometry.origin));
    const glm::dvec2 tangents = compute_tangents(inputs.view.camera, inputs.view.size);
    const double far_distance = compute_far_distance_in_radii(m_params.epsilon);
    m_instances.clear();
    for (const Sphere& sphere : m_poser->pose(geometry)) {
        const glm::dvec3 center(view_from_origin * glm::dvec4(glm::dvec3(sphere.center), 1.0));
        const auto radius = static_cast<double>(sphere.radius);
        // Receivers within the sphere count as well where `inside_value` does.
        const double limit = std::max(std::min(far_distance * radius, m_params.reach), radius);
        const DeviceRectangle bounds = compute_ball_bounds(center, limit, tangents);
        if (radius > 0.0 && !bounds.is_empty()) {
            m_instances.push_back({glm::vec4(glm::vec3(center), sphere.radius),
                                   glm::vec4(glm::vec2(bounds.low), glm::vec2(bounds.high))});
        }
    }
    if (!m_instances.empty()) {
        m_gl.NamedBufferSubData(m_buffer.get(), 0,
                                static_cast<GLsizeiptr>(m_instances.size() * sizeof(Instance)),
                                m_instances.data());
    }
}

void Billboards::draw(const MethodInputs& inputs) const {
    const bool is_additive = m_params.blending == OcclusionBlending::additive;
    const float start = is_additive ? 0.0f : 1.0f;
    m_gl.ClearNamedFramebufferfv(m_framebuffer.get(), GL_COLOR, 0, &start);
    if (m_instances.empty()) {
        return;
    }
    const ImageSize size = inputs.view.size;
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, size));
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.get());
    m_gl.Viewport(0, 0, size.width, size.height);
    m_gl.Enable(GL_BLEND);
    m_gl.BlendEquation(GL_FUNC_ADD);
    m_gl.BlendFunc(is_additive ? GL_ONE : GL_ZERO, is_additive ? GL_ONE : GL_SRC_COLOR);
    m_program.use();
    m_parameters.bind();
    m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
    m_gl.BindTextureUnit(4, inputs.gbuffer.texture(Channel::normal).get());
    m_gl.Uniform2f(m_program.location("tangents"), tangents.x, tangents.y);
    m_gl.Uniform1f(m_program.location("far_distance"),
                   static_cast<float>(compute_far_distance_in_radii(m_params.epsilon)));
    m_gl.BindVertexArray(m_vertex_array.get());
    m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(m_instances.size()));
    m_gl.Disable(GL_BLEND);
}

} // namespace alcove
