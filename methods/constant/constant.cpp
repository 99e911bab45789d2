#include "methods/constant/constant.hpp"

#include "methods/common/ray_tracer.hpp"
#include "methods/common/traced_target.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = ConstantParams;
    return describe_parameters(
        "constant", {
                        describe_target_radius(&P::radius),
                        integer(&P::columns, "columns")
                            .range(8, 512)
                            .log_scale()
                            .unit("px")
                            .meaning("Width of the grid of pixels that is traced; its height "
                                     "follows the image's.")
                            .source("ours"),
                        integer(&P::rays, "rays")
                            .range(2, 1024)
                            .log_scale()
                            .unit("rays")
                            .symbol("N")
                            .meaning("Rays a pixel of the grid, in two halves.")
                            .source("ours"),
                        describe_target_falloff(&P::falloff),
                        describe_target_weighting(&P::weighting),
                        describe_target_normals(&P::normals),
                    });
}

/// Mean of `grid`, an image of the same view as `depth`, over the pixels that show a surface there;
/// 1 without one.
float average_surfaces(const Image& grid, const Image& depth) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
            const int column = (2 * x + 1) * depth.width() / (2 * grid.width());
            const int row = (2 * y + 1) * depth.height() / (2 * grid.height());
            if (!std::isinf(depth.at(column, row))) {
                sum += static_cast<double>(grid.at(x, y));
                ++count;
            }
        }
    }
    return count == 0 ? 1.0f : static_cast<float>(sum / count);
}

class Constant final : public Method {
  public:
    Constant(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_table().bind<ConstantParams>(resolved)) {}

    MethodRequests get_requests() const override { return {kBaseChannels, true}; }

    void resize(ImageSize size) override { m_visibility = gl::Texture(m_gl, GL_R32F, size); }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& /*passes*/) override {
        ALCOVE_ASSERT(inputs.geometry != nullptr, "posed geometry was requested");
        m_tracer.update(*inputs.geometry);
        TraceSettings settings;
        settings.target = {m_params.radius, m_params.falloff, m_params.weighting, m_params.normals};
        settings.rays_per_half = m_params.rays / 2;
        settings.seed = inputs.noise_seed;
        const ImageSize size = inputs.view.size;
        const ImageSize grid{m_params.columns,
                             std::max(1, m_params.columns * size.height / size.width)};
        const Image depth = gl::read_texture(m_gl, inputs.gbuffer.texture(Channel::eye_depth), 1);
        const float mean = average_surfaces(
            compute_mean(m_tracer.trace(inputs.view.camera, grid, settings)), depth);
        Image visibility(size, 1, 1.0f);
        for (std::size_t i = 0; i < depth.values().size(); ++i) {
            visibility.values()[i] = std::isinf(depth.values()[i]) ? 1.0f : mean;
        }
        gl::write_texture(m_gl, m_visibility, visibility);
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    ConstantParams m_params;
    RayTracer m_tracer;
    gl::Texture m_visibility;
};

} // namespace

MethodUnit constant_unit() {
    MethodUnit unit;
    unit.name = "constant";
    unit.title = "The reference's mean everywhere";
    unit.citation = "a control: ours";
    unit.has_passes = false;
    unit.parameters = make_table();
    unit.presets = {{"default", "a grid of 64 columns, 32 rays each", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.map_target = map_whole_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<Constant>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
