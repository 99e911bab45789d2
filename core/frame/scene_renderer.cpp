#include "core/frame/scene_renderer.hpp"

#include "core/base/error.hpp"
#include "core/gl/shaders.hpp"

#include <limits>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr GLuint kPositionAttribute = 0;
constexpr GLuint kNormalAttribute = 1;
constexpr GLsizei kVertexStride = 6 * sizeof(float);

std::vector<float> interleave(const Mesh& mesh) {
    std::vector<float> vertices;
    vertices.reserve(mesh.positions.size() * 6);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        const glm::vec3 n = mesh.normals[i];
        vertices.insert(vertices.end(), {p.x, p.y, p.z, n.x, n.y, n.z});
    }
    return vertices;
}

/// One output a channel, in the order of the table, which is that of the framebuffer's attachments.
std::string make_channel_outputs(ChannelSet channels) {
    std::string text;
    int location = 0;
    for (const ChannelInfo& info : kChannels) {
        if (channels.contains(info.channel)) {
            const std::string name(info.name);
            text += "#define WRITE_" + name + "\nlayout(location = " + std::to_string(location++) +
                    ") out " + std::string(info.glsl_type) + " out_" + name + ";\n";
        }
    }
    return text;
}

void set_matrix(const gl::Functions& gl, GLint location, const glm::dmat4& matrix) {
    const glm::mat4 rounded(matrix);
    gl.UniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(rounded));
}

} // namespace

SceneRenderer::SceneRenderer(const gl::Functions& gl, const Scene& scene)
    : m_gl(gl), m_scene(scene), m_library{embedded_frame_shaders(), embedded_gl_shaders()},
      m_rebuild(gl, m_library, "core/frame/rebuild_eye_depth.frag.glsl") {
    if (scene.get_lights().directional.size() > kMaximumLights) {
        throw InputError("scene", "too many directional lights",
                         std::to_string(scene.get_lights().directional.size()),
                         "at most " + std::to_string(kMaximumLights));
    }
    for (const Mesh& mesh : scene.get_meshes()) {
        GpuMesh uploaded;
        const std::vector<float> vertices = interleave(mesh);
        uploaded.vertices = gl::create_buffer(gl, std::as_bytes(std::span(vertices)));
        uploaded.indices = gl::create_buffer(gl, std::as_bytes(std::span(mesh.indices)));
        uploaded.index_count = static_cast<GLsizei>(mesh.indices.size());
        GLuint name = 0;
        gl.CreateVertexArrays(1, &name);
        uploaded.vertex_array = gl::VertexArrayHandle(gl, name);
        gl.VertexArrayVertexBuffer(name, 0, uploaded.vertices.get(), 0, kVertexStride);
        gl.VertexArrayElementBuffer(name, uploaded.indices.get());
        for (const GLuint attribute : {kPositionAttribute, kNormalAttribute}) {
            gl.EnableVertexArrayAttrib(name, attribute);
            gl.VertexArrayAttribFormat(name, attribute, 3, GL_FLOAT, GL_FALSE,
                                       attribute * 3 * static_cast<GLuint>(sizeof(float)));
            gl.VertexArrayAttribBinding(name, attribute, 0);
        }
        m_meshes.push_back(std::move(uploaded));
    }
}

const SceneRenderer::Pipeline& SceneRenderer::get_pipeline(ChannelSet channels) {
    const auto known = m_pipelines.find(channels);
    if (known != m_pipelines.end()) {
        return known->second;
    }
    Pipeline pipeline;
    pipeline.program =
        gl::build_program(m_gl, m_library,
                          {{GL_VERTEX_SHADER, "core/frame/gbuffer.vert.glsl"},
                           {GL_FRAGMENT_SHADER, "core/frame/gbuffer.frag.glsl"}},
                          {{"channel_outputs.glsl", make_channel_outputs(channels)}});
    pipeline.view_from_object = pipeline.program.location("view_from_object");
    pipeline.clip_from_view = pipeline.program.location("clip_from_view");
    pipeline.normal_matrix = pipeline.program.location("normal_matrix");
    pipeline.motion_matrix = pipeline.program.location("motion_matrix");
    pipeline.albedo = pipeline.program.location("albedo");
    pipeline.instance_id = pipeline.program.location("instance_id");
    return m_pipelines.emplace(channels, std::move(pipeline)).first->second;
}

void SceneRenderer::clear(const GBuffer& gbuffer) const {
    GLint buffer = 0;
    for (const ChannelInfo& info : kChannels) {
        if (!gbuffer.channels().contains(info.channel)) {
            continue;
        }
        if (info.channel == Channel::instance_id) {
            const std::array<GLuint, 4> none{};
            m_gl.ClearNamedFramebufferuiv(gbuffer.framebuffer(), GL_COLOR, buffer, none.data());
        } else {
            std::array<float, 4> value{};
            if (info.channel == Channel::eye_depth) {
                value.fill(std::numeric_limits<float>::infinity());
            } else if (info.channel == Channel::motion_depth) {
                value[3] = std::numeric_limits<float>::infinity();
            }
            m_gl.ClearNamedFramebufferfv(gbuffer.framebuffer(), GL_COLOR, buffer, value.data());
        }
        ++buffer;
    }
    const float far_depth = gbuffer.precision().reversed ? 0.0f : 1.0f;
    m_gl.ClearNamedFramebufferfv(gbuffer.framebuffer(), GL_DEPTH, 0, &far_depth);
}

void SceneRenderer::set_lights(const Pipeline& pipeline, const Camera& camera) const {
    const std::vector<DirectionalLight>& lights = m_scene.get_lights().directional;
    m_gl.Uniform1i(pipeline.program.location("light_count"), static_cast<GLint>(lights.size()));
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::vec3 direction(glm::transpose(camera.world_from_view) * lights[i].to_light);
        const std::string index = "[" + std::to_string(i) + "]";
        m_gl.Uniform3f(pipeline.program.location(("light_direction" + index).c_str()), direction.x,
                       direction.y, direction.z);
        m_gl.Uniform3f(pipeline.program.location(("light_irradiance" + index).c_str()),
                       lights[i].irradiance.x, lights[i].irradiance.y, lights[i].irradiance.z);
    }
}

SceneRenderer::Objects SceneRenderer::sort_objects(const FrameView& view) const {
    const Pose pose = m_scene.compute_pose(view.time_s);
    const Pose previous =
        view.previous_time_s == view.time_s ? pose : m_scene.compute_pose(view.previous_time_s);
    Objects objects;
    for (std::size_t i = 0; i < pose.object_to_world.size(); ++i) {
        const ObjectTransform transform{i, pose.object_to_world[i], previous.object_to_world[i]};
        (transform.now == transform.before ? objects.still : objects.moving).push_back(transform);
    }
    return objects;
}

void SceneRenderer::draw_objects(ChannelSet channels, GLuint framebuffer, const FrameView& view,
                                 const glm::dmat4& projection,
                                 const std::vector<ObjectTransform>& objects) {
    if (objects.empty()) {
        return;
    }
    const Pipeline& pipeline = get_pipeline(channels);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    pipeline.program.use();
    set_matrix(m_gl, pipeline.clip_from_view, projection);
    set_lights(pipeline, view.camera);
    for (const ObjectTransform& object : objects) {
        const glm::dmat4 view_from_object = compute_view_from_object(view.camera, object.now);
        set_matrix(m_gl, pipeline.view_from_object, view_from_object);
        const glm::mat3 normal_matrix(glm::transpose(glm::inverse(glm::dmat3(view_from_object))));
        m_gl.UniformMatrix3fv(pipeline.normal_matrix, 1, GL_FALSE, glm::value_ptr(normal_matrix));
        // p_old - p_new as one matrix: the difference is taken in double before anything is
        // rounded.
        set_matrix(m_gl, pipeline.motion_matrix, object.before - object.now);
        const std::size_t mesh_index = m_scene.get_objects()[object.index].mesh;
        const glm::vec3 albedo = m_scene.get_meshes()[mesh_index].albedo;
        m_gl.Uniform3f(pipeline.albedo, albedo.x, albedo.y, albedo.z);
        m_gl.Uniform1ui(pipeline.instance_id, static_cast<GLuint>(object.index + 1));
        const GpuMesh& mesh = m_meshes[mesh_index];
        m_gl.BindVertexArray(mesh.vertex_array.get());
        m_gl.DrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr);
    }
}

void SceneRenderer::rebuild_eye_depth(const GBuffer& gbuffer, const Camera& camera) const {
    const bool reversed = gbuffer.precision().reversed;
    m_gl.Disable(GL_DEPTH_TEST);
    m_rebuild.use();
    m_gl.BindTextureUnit(0, gbuffer.raster_depth().get());
    const auto at_near = static_cast<float>(1.0 / camera.near_m);
    const auto at_far = static_cast<float>(1.0 / camera.far_m);
    m_gl.Uniform2f(m_rebuild.location("inverse_ends"), reversed ? at_far : at_near,
                   reversed ? at_near : at_far);
    m_gl.Uniform1f(m_rebuild.location("background_depth"), reversed ? 0.0f : 1.0f);
    m_rebuild.draw(gbuffer.rebuild_framebuffer(), gbuffer.size());
}

void SceneRenderer::render(const GBuffer& gbuffer, const FrameView& view) {
    ALCOVE_ASSERT(gbuffer.size() == view.size, "a G-buffer of the frame's size");
    const bool reversed = gbuffer.precision().reversed;
    const glm::dmat4 projection = compute_projection(view.camera, view.size, reversed);
    clear(gbuffer);
    m_gl.Viewport(0, 0, view.size.width, view.size.height);
    m_gl.ClipControl(GL_LOWER_LEFT, reversed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthFunc(reversed ? GL_GREATER : GL_LESS);
    // What stands still leaves the cleared motion alone. It comes first: a mover behind it then
    // fails the depth test, and one before it writes over the zero.
    const Objects objects = sort_objects(view);
    draw_objects(gbuffer.still_channels(), gbuffer.still_framebuffer(), view, projection,
                 objects.still);
    draw_objects(gbuffer.channels(), gbuffer.framebuffer(), view, projection, objects.moving);
    m_gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    if (gbuffer.rebuild_framebuffer() != 0) {
        rebuild_eye_depth(gbuffer, view.camera);
    }
    m_gl.Disable(GL_DEPTH_TEST);
}

} // namespace alcove
