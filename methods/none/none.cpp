#include "methods/none/none.hpp"

namespace alcove {
namespace {

class None final : public Method {
  public:
    explicit None(const gl::Functions& gl) : m_gl(gl) {}

    MethodRequests get_requests() const override { return {{}, false}; }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        const float open = 1.0f;
        m_gl.ClearTexImage(m_visibility.get(), 0, GL_RED, GL_FLOAT, &open);
    }

    MethodOutput render(const MethodInputs& /*inputs*/, PassRecorder& /*passes*/) override {
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    gl::Texture m_visibility;
};

} // namespace

MethodUnit none_unit() {
    MethodUnit unit;
    unit.name = "none";
    unit.title = "No ambient occlusion";
    unit.citation = "the control of every comparison";
    unit.has_passes = false;
    unit.parameters = describe_parameters("none", {});
    unit.presets = {{"default", "the only one", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.map_target = [](const Target&) {
        return TargetMapping{{}, "visibility is 1 whatever the target"};
    };
    unit.create = [](gl::Context& context, const ResolvedParameters&) {
        return std::make_unique<None>(context.functions());
    };
    return unit;
}

} // namespace alcove
