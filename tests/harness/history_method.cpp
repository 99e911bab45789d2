#include "tests/harness/history_method.hpp"

namespace alcove {
namespace {

struct HistoryParams {
    double strength = 1.0;
};

class HistoryMethod final : public Method {
  public:
    HistoryMethod(const gl::Functions& gl, std::shared_ptr<HistoryLog> log)
        : m_gl(gl), m_log(std::move(log)), m_instance(m_log->instances++) {}

    MethodRequests get_requests() const override {
        return {{Channel::eye_depth, Channel::normal, Channel::motion}, true};
    }
    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_count = 0;
    }
    void reset_history() override {
        m_count = 0;
        HistoryEntry entry;
        entry.event = HistoryEvent::reset;
        entry.instance = m_instance;
        m_log->entries.push_back(entry);
    }
    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const FrameView& view = inputs.view;
        HistoryEntry entry;
        entry.instance = m_instance;
        entry.frame = view.index;
        entry.history_valid = view.history_valid;
        entry.is_held = view.previous_camera.position == view.camera.position &&
                        view.previous_camera.world_from_view == view.camera.world_from_view &&
                        view.previous_time_s == view.time_s;
        entry.has_motion = inputs.gbuffer.channels().contains(Channel::motion);
        entry.has_lights = inputs.lights != nullptr;
        entry.has_geometry = inputs.geometry != nullptr;
        entry.noise_seed = inputs.noise_seed;
        entry.count = ++m_count;
        m_log->entries.push_back(entry);
        {
            const auto pass = passes.scope("history_method/first");
            gl::write_texture(m_gl, m_visibility,
                              Image(view.size, 1, 1.0f / static_cast<float>(m_count)));
        }
        const auto pass = passes.scope("history_method/second");
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    std::shared_ptr<HistoryLog> m_log;
    int m_instance;
    gl::Texture m_visibility;
    int m_count = 0;
};

} // namespace

MethodUnit make_history_method_unit(std::shared_ptr<HistoryLog> log) {
    MethodUnit unit;
    unit.name = "history_method";
    unit.title = "Counts its frames";
    unit.citation = "nobody's work: it counts";
    unit.content_hash = "none";
    unit.reported = false;
    unit.parameters =
        describe_parameters("history_method", {real(&HistoryParams::strength, "strength")
                                                   .range(0.0, 1.0)
                                                   .unit("1")
                                                   .meaning("Does nothing.")
                                                   .inert("the method counts")
                                                   .source("ours")});
    unit.presets = {{"default", "counts", {}, 1.0, 2.0, ""}};
    unit.map_target = [](const Target&) { return TargetMapping{{}, "it knows no radius"}; };
    unit.warm_frames = [](const ResolvedParameters&) { return kHistoryWarmFrames; };
    unit.create = [log](gl::Context& context, const ResolvedParameters&) {
        return std::make_unique<HistoryMethod>(context.functions(), log);
    };
    return unit;
}

} // namespace alcove
