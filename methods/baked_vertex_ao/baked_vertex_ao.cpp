#include "methods/baked_vertex_ao/baked_vertex_ao.hpp"

#include "methods/baked_vertex_ao/baked_geometry.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/traced_target.hpp"

#include <optional>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = BakedVertexAoParams;
    return describe_parameters("baked_vertex_ao",
                               {
                                   describe_target_radius(&P::radius),
                                   integer(&P::rays, "rays")
                                       .range(2, 1024)
                                       .log_scale()
                                       .unit("rays")
                                       .symbol("N")
                                       .meaning("Rays a vertex, in two halves.")
                                       .source("ours"),
                                   describe_target_falloff(&P::falloff),
                                   describe_target_weighting(&P::weighting),
                                   real(&P::inset, "inset")
                                       .range(0.0, 0.5)
                                       .unit("1")
                                       .meaning("Share of the way from a vertex to the centre of "
                                                "its largest triangle where its rays start.")
                                       .source("ours"),
                                   describe_strength(&P::strength),
                               });
}

/// The seed of the bake: it belongs to the geometry, not to a frame.
constexpr std::uint32_t kBakeSeed = 0;

class BakedVertexAo final : public Method {
  public:
    BakedVertexAo(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_table().bind<BakedVertexAoParams>(resolved)),
          m_parameters(gl, make_table(), resolved),
          m_program(gl::build_program(
              gl, make_method_shader_library(),
              {{GL_VERTEX_SHADER, "methods/baked_vertex_ao/baked_vertex_ao_raster.vert.glsl"},
               {GL_FRAGMENT_SHADER, "methods/baked_vertex_ao/baked_vertex_ao_raster.frag.glsl"}},
              m_parameters.generated_files())) {
        m_parameters.connect(m_program);
    }

    MethodRequests get_requests() const override { return {kBaseChannels, true}; }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_depth = gl::Texture(m_gl, GL_DEPTH_COMPONENT32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility}, &m_depth);
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        ALCOVE_ASSERT(inputs.geometry != nullptr, "posed geometry was requested");
        if (m_baked_for != inputs.geometry->scene) {
            bake(*inputs.geometry->scene);
        }
        const auto pass = passes.scope("baked_vertex_ao/raster");
        m_baked->update(*inputs.geometry);
        draw(inputs);
        return {&m_visibility, nullptr};
    }

  private:
    /// The pose at time 0, whichever frame comes first: equal frames give equal images.
    void bake(const Scene& scene) {
        const PosedGeometry rest = pose_geometry(scene, 0.0);
        RayTracer tracer;
        tracer.update(rest);
        TraceSettings settings;
        settings.target = {m_params.radius, m_params.falloff, m_params.weighting, Normals::shading};
        settings.rays_per_half = m_params.rays / 2;
        settings.seed = kBakeSeed;
        const std::vector<SurfacePoint> points = list_vertex_points(rest, m_params.inset);
        m_baked.emplace(m_gl, rest, tracer.trace_points(points, settings));
        m_baked_for = &scene;
    }

    void draw(const MethodInputs& inputs) {
        const ImageSize size = inputs.view.size;
        const glm::mat4 clip(compute_projection(inputs.view.camera, size, true));
        const float open = 1.0f;
        const float far = 0.0f;
        m_gl.ClearNamedFramebufferfv(m_framebuffer.get(), GL_COLOR, 0, &open);
        m_gl.ClearNamedFramebufferfv(m_framebuffer.get(), GL_DEPTH, 0, &far);
        m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.get());
        m_gl.Viewport(0, 0, size.width, size.height);
        m_gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        m_gl.Enable(GL_DEPTH_TEST);
        m_gl.DepthFunc(GL_GEQUAL);
        m_program.use();
        m_parameters.bind();
        m_baked->bind();
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.UniformMatrix4fv(m_program.location("clip_from_view"), 1, GL_FALSE,
                              glm::value_ptr(clip));
        const GLint place = m_program.location("view_from_object");
        const PosedGeometry& geometry = *inputs.geometry;
        const glm::dmat4 world_from_origin = glm::translate(glm::dmat4(1.0), geometry.origin);
        for (std::size_t i = 0; i < geometry.objects.size(); ++i) {
            const BakedGeometry::Place& range = m_baked->places()[i];
            const glm::mat4 view(compute_view_from_object(
                inputs.view.camera,
                world_from_origin * glm::dmat4(geometry.objects[i].origin_from_object)));
            m_gl.UniformMatrix4fv(place, 1, GL_FALSE, glm::value_ptr(view));
            m_gl.DrawElementsBaseVertex(GL_TRIANGLES, range.index_count, GL_UNSIGNED_INT,
                                        reinterpret_cast<const void*>(range.first_index),
                                        range.base_vertex);
        }
    }

    const gl::Functions& m_gl;
    BakedVertexAoParams m_params;
    ParameterBlock m_parameters;
    gl::Program m_program;
    std::optional<BakedGeometry> m_baked;
    const Scene* m_baked_for = nullptr;
    gl::Texture m_visibility;
    gl::Texture m_depth;
    gl::FramebufferHandle m_framebuffer;
};

} // namespace

MethodUnit baked_vertex_ao_unit() {
    MethodUnit unit;
    unit.name = "baked_vertex_ao";
    unit.title = "Baked vertex AO";
    unit.citation = "per-vertex ambient occlusion as Know your SSAO artifacts prefers it; baked as "
                    "Landis. Production-ready global illumination. 2002";
    unit.parameters = make_table();
    unit.presets = {{"default", "64 rays a vertex of the pose at time 0", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.map_target = map_target_on_shading_normals;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<BakedVertexAo>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
