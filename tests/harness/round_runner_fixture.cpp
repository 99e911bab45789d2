#include "tests/harness/round_runner_fixture.hpp"

#include "harness/run/segments.hpp"

namespace alcove {
namespace {

/// Another scene with a cut more.
class CutScene final : public Scene {
  public:
    explicit CutScene(std::unique_ptr<Scene> scene)
        : m_scene(std::move(scene)), m_walkthrough(m_scene->get_walkthrough()) {
        m_walkthrough.cuts = {0, kCutFrame};
    }
    [[nodiscard]] std::span<const Mesh> get_meshes() const override {
        return m_scene->get_meshes();
    }
    [[nodiscard]] std::span<const Object> get_objects() const override {
        return m_scene->get_objects();
    }
    [[nodiscard]] const Lights& get_lights() const override { return m_scene->get_lights(); }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return m_scene->get_ao_radius_m(); }
    [[nodiscard]] Pose compute_pose(double time_s) const override {
        return m_scene->compute_pose(time_s);
    }

  private:
    std::unique_ptr<Scene> m_scene;
    Walkthrough m_walkthrough;
};

} // namespace

RoundRunnerTest::RoundRunnerTest()
    : m_cache("ALCOVE_CACHE", (m_folder.path() / "cache").string()) {}

void RoundRunnerTest::run(const std::vector<std::string>& methods, int repeats, std::uint64_t seed,
                          const RoundEvents& events) {
    m_log = std::make_shared<HistoryLog>();
    if (!m_keeps_cache) {
        std::filesystem::remove_all(m_folder.path() / "cache" / "captures");
        std::filesystem::remove_all(m_folder.path() / "cache" / "gbuffers");
    }
    const Units shipped = get_units();
    std::vector<MethodUnit> units(shipped.methods.units().begin(), shipped.methods.units().end());
    units.push_back(make_history_method_unit(m_log));
    units.push_back(make_parts_method_unit(m_parts));
    units.push_back(make_light_method_unit(m_light));
    const Units all{Registry<MethodUnit>("methods", std::move(units)), shipped.metrics,
                    shipped.scenes};
    Experiment experiment;
    experiment.scenes = {{"template_scene", std::nullopt}};
    experiment.sizes = {{96, 72}};
    experiment.repeats = repeats;
    experiment.until_width = m_until_width;
    experiment.shuffle_seed = seed;
    experiment.reference_rays_per_half = 16;
    experiment.audit_share = m_audit_share;
    experiment.explains_errors = m_explains_errors;
    experiment.counts_fetches = m_counts_fetches;
    experiment.measures_strata = m_measures_strata;
    experiment.regions = m_regions;
    experiment.targets = {m_target};
    for (const std::string& text : methods) {
        experiment.methods.push_back(parse_method_spec(text));
    }
    if (!m_reference.empty()) {
        experiment.reference = parse_method_spec(m_reference, "--reference");
    }
    m_plan = make_plan(experiment, all).record;
    RoundRecord& planned = m_plan.rounds.at(0);
    planned.segments = {{0, 4}, {10, 11}, {20, 21}, {30, 31}};
    planned.image_frames = choose_image_frames(planned.segments);
    planned.film = m_films_burst ? choose_film(planned.segments) : SegmentRecord{};
    const SceneUnit& scene = all.scenes.find("template_scene");
    m_scene = std::make_unique<CutScene>(scene.open(scene.parameters.resolve({}, {})));
    m_result = run_round(context(), gl::TimerMode::fenced_wall, all, m_plan, planned, *m_scene,
                         m_folder.path(), events);
}

std::vector<SampleRow> RoundRunnerTest::find_samples(const std::string& cell_id,
                                                     SampleState state) const {
    std::vector<SampleRow> rows;
    for (const SampleRow& row : m_result.samples) {
        if (row.cell == cell_id && row.state == state) {
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace alcove
