#include "tests/harness/parts_method.hpp"

#include <cmath>

namespace alcove {
namespace {

struct PartsParams {
    double strength = 1.0;
};

class PartsMethod final : public Method {
  public:
    PartsMethod(const gl::Functions& gl, std::shared_ptr<PartsLog> log)
        : m_gl(gl), m_log(std::move(log)) {}

    MethodRequests get_requests() const override {
        MethodRequests requests;
        requests.border = 0.1;
        requests.layers = 3;
        requests.back_faces = true;
        requests.views = {{{0.5, 0.2, 0.0}, 0.5}};
        requests.samples = 4;
        return requests;
    }
    void resize(ImageSize size) override { m_visibility = gl::Texture(m_gl, GL_R32F, size); }
    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("parts_method/look");
        m_log->layers = inputs.layers.size();
        m_log->views = inputs.views.size();
        m_log->samples = inputs.multisampled->samples();
        const auto read = [this](const GBuffer& gbuffer) {
            return gl::read_texture(m_gl, gbuffer.texture(Channel::eye_depth), 1);
        };
        const Image first = read(inputs.gbuffer);
        const Image second = read(*inputs.layers.at(0));
        const Image third = read(*inputs.layers.at(1));
        const Image back = read(*inputs.back_faces);
        for (std::size_t i = 0; i < first.values().size(); ++i) {
            const float a = first.values()[i];
            const float b = second.values()[i];
            const float c = third.values()[i];
            m_log->disordered += (b <= a && std::isfinite(a)) || (c <= b && std::isfinite(b)) ||
                                 (std::isinf(a) && std::isfinite(b));
            m_log->deeper += std::isfinite(b);
            m_log->behind += std::isfinite(back.values()[i]) && back.values()[i] >= a;
        }
        m_log->view_size = inputs.views.front().gbuffer->size();
        ++m_log->frames;
        gl::write_texture(m_gl, m_visibility, Image(m_visibility.size(), 1, 0.5f));
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    std::shared_ptr<PartsLog> m_log;
    gl::Texture m_visibility;
};

} // namespace

MethodUnit make_parts_method_unit(std::shared_ptr<PartsLog> log) {
    MethodUnit unit;
    unit.name = "parts_method";
    unit.title = "Looks at all parts";
    unit.citation = "nobody's work: it looks";
    unit.content_hash = "none";
    unit.reported = false;
    unit.parameters = describe_parameters("parts_method", {real(&PartsParams::strength, "strength")
                                                               .range(0.0, 1.0)
                                                               .unit("1")
                                                               .meaning("Does nothing.")
                                                               .inert("the method looks")
                                                               .source("ours")});
    unit.presets = {{"default", "looks", {}, 1.0, 2.0, ""}};
    unit.map_target = [](const Target&) { return TargetMapping{{}, "it knows no radius"}; };
    unit.create = [log](gl::Context& context, const ResolvedParameters&) {
        return std::make_unique<PartsMethod>(context.functions(), log);
    };
    return unit;
}

} // namespace alcove
