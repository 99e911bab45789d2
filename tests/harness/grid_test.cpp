#include "harness/run/grid.hpp"

#include "harness/run/units.hpp"
#include "tests/harness/expect_error.hpp"

namespace alcove {
namespace {

std::vector<std::string> list_labels(const Experiment& experiment) {
    std::vector<std::string> labels;
    for (const MethodSpec& spec : experiment.methods) {
        labels.push_back(spec.label);
    }
    return labels;
}

MethodGrid make_grid() {
    MethodGrid grid;
    grid.base = parse_method_spec("tssao");
    return grid;
}

TEST(Grid, CrossedAxesMeetEveryValueTheFirstSlowest) {
    MethodGrid grid = make_grid();
    grid.crossed = {{"history_cap", {"500", "1000"}}, {"converged_samples", {"8", "16"}}};
    Experiment experiment;
    expand(grid, get_units().methods, experiment);
    EXPECT_EQ(list_labels(experiment),
              (std::vector<std::string>{"tssao:history_cap=500,converged_samples=8",
                                        "tssao:history_cap=500,converged_samples=16",
                                        "tssao:history_cap=1000,converged_samples=8",
                                        "tssao:history_cap=1000,converged_samples=16"}));
    ASSERT_EQ(experiment.methods[1].overrides.size(), 2u);
    EXPECT_EQ(experiment.methods[1].overrides[1].name, "converged_samples");
    EXPECT_EQ(experiment.methods[1].overrides[1].value, "16");
}

TEST(Grid, ZippedAxesAdvanceTogetherWithinCrossedOnes) {
    MethodGrid grid = make_grid();
    grid.crossed = {{"history_cap", {"500", "inf"}}};
    grid.zipped = {{"initial_samples", {"32", "64"}}, {"converged_samples", {"8", "16"}}};
    Experiment experiment;
    expand(grid, get_units().methods, experiment);
    EXPECT_EQ(list_labels(experiment),
              (std::vector<std::string>{
                  "tssao:history_cap=500,initial_samples=32,converged_samples=8",
                  "tssao:history_cap=500,initial_samples=64,converged_samples=16",
                  "tssao:history_cap=inf,initial_samples=32,converged_samples=8",
                  "tssao:history_cap=inf,initial_samples=64,converged_samples=16"}));
}

TEST(Grid, SkippedCombinationsKeepTheirReason) {
    MethodGrid grid = make_grid();
    grid.crossed = {{"history_cap", {"500", "1000"}}, {"converged_samples", {"8", "16"}}};
    // 5e2 is 500: values are compared as parameters.
    grid.skips = {{{{"history_cap", "5e2"}, {"converged_samples", "16"}}, "not published"}};
    Experiment experiment;
    expand(grid, get_units().methods, experiment);
    EXPECT_EQ(experiment.methods.size(), 3u);
    ASSERT_EQ(experiment.skipped.size(), 1u);
    EXPECT_EQ(experiment.skipped[0].label, "tssao:history_cap=500,converged_samples=16");
    EXPECT_EQ(experiment.skipped[0].reason, "not published");
    grid.skips.push_back({{{"history_cap", "700"}}, "meets nothing"});
    expect_error([&] { expand(grid, get_units().methods, experiment); }, 2, {"meets nothing"});
}

TEST(Grid, MistakesInAxesAreNamed) {
    const Units units = get_units();
    Experiment experiment;
    const auto expect = [&](const MethodGrid& grid, std::initializer_list<const char*> parts) {
        expect_error([&] { expand(grid, units.methods, experiment); }, 2, parts);
    };
    MethodGrid grid = make_grid();
    grid.crossed = {{"history_cop", {"500"}}};
    expect(grid, {"history_cop", "nearest: history_cap"});
    grid.crossed = {{"history_cap", {"0.5"}}};
    expect(grid, {"history_cap", "0.5"});
    grid.crossed = {{"history_cap", {}}};
    expect(grid, {"history_cap", "without a value"});
    grid.crossed = {{"history_cap", {"500"}}, {"history_cap", {"600"}}};
    expect(grid, {"history_cap", "set twice"});
    grid.crossed.clear();
    grid.zipped = {{"initial_samples", {"32", "64"}}, {"converged_samples", {"8"}}};
    expect(grid, {"converged_samples", "differ in length", "`1`", "2"});
    grid.zipped.clear();
    grid.base = parse_method_spec("tssao:history_cap=100");
    grid.crossed = {{"history_cap", {"500"}}};
    expect(grid, {"history_cap", "set twice"});
}

TEST(Grid, TooManyCombinationsAreRefusedBeforeTheyAreMade) {
    MethodGrid grid = make_grid();
    const std::vector<std::string> many(1000, "8");
    grid.crossed = {{"initial_samples", many}, {"converged_samples", many}, {"history_cap", many}};
    Experiment experiment;
    expect_error([&] { expand(grid, get_units().methods, experiment); }, 2,
                 {"too many combinations", "1000000000"});
    EXPECT_TRUE(experiment.methods.empty());
}

TEST(Grid, RangesStepEquallyOnTheirScale) {
    const auto list = [](double from, double to, std::int64_t steps, ParameterScale scale,
                         ParameterKind kind) {
        return list_values({from, to, steps, scale}, kind, "x");
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(list(0, 1, 5, ParameterScale::linear, ParameterKind::real),
              (Texts{"0", "0.25", "0.5", "0.75", "1"}));
    const Texts decades = list(0.1, 100, 4, ParameterScale::log, ParameterKind::real);
    ASSERT_EQ(decades.size(), 4u);
    EXPECT_NEAR(std::stod(decades[1]), 1.0, 1e-12);
    EXPECT_EQ(decades[3], "100");
    // Integers are rounded and lose their doubles.
    EXPECT_EQ(list(1, 4, 7, ParameterScale::linear, ParameterKind::integer),
              (Texts{"1", "2", "3", "4"}));
    for (const auto& [from, to, steps] :
         {std::tuple{0.0, 1.0, 3}, {-1.0, 1.0, 3}, {1.0, 2.0, 1}, {1.0, 2.0, 1001}}) {
        expect_error(
            [&, a = from, b = to, n = steps] {
                static_cast<void>(list(a, b, n, ParameterScale::log, ParameterKind::real));
            },
            2, {"x"});
    }
}

TEST(Sweep, ReplacesEveryCellOfItsMethodAndCrossesWithOthers) {
    Experiment experiment;
    experiment.methods = {parse_method_spec("none"), parse_method_spec("tssao@paper_stills")};
    apply_sweeps({parse_sweep("tssao.history_cap=100,200"),
                  parse_sweep("tssao.converged_samples=8,16"),
                  parse_sweep("hemisphere_ssao.samples=4,8")},
                 get_units().methods, experiment);
    EXPECT_EQ(
        list_labels(experiment),
        (std::vector<std::string>{"none", "tssao@paper_stills:history_cap=100,converged_samples=8",
                                  "tssao@paper_stills:history_cap=100,converged_samples=16",
                                  "tssao@paper_stills:history_cap=200,converged_samples=8",
                                  "tssao@paper_stills:history_cap=200,converged_samples=16",
                                  "hemisphere_ssao:samples=4", "hemisphere_ssao:samples=8"}));
}

TEST(Sweep, ReplacesTheValueThatASpecificationSetsItself) {
    Experiment experiment;
    experiment.methods = {parse_method_spec("hemisphere_ssao"),
                          parse_method_spec("hemisphere_ssao:samples=64,blur_radius=0"),
                          parse_method_spec("hemisphere_ssao:samples=8")};
    apply_sweeps({parse_sweep("hemisphere_ssao.samples=4")}, get_units().methods, experiment);
    EXPECT_EQ(list_labels(experiment),
              (std::vector<std::string>{"hemisphere_ssao:samples=4",
                                        "hemisphere_ssao:blur_radius=0,samples=4"}));
}

TEST(Sweep, WhatCannotBeReadIsRefused) {
    for (const char* text : {"tssao", "tssao=1", "tssao.=1", ".history_cap=1", "tssao.history_cap",
                             "tssao.history_cap=", "tssao.history_cap=1,,2", ""}) {
        SCOPED_TRACE(text);
        expect_error([&] { static_cast<void>(parse_sweep(text)); }, 2, {"--sweep"});
    }
}

} // namespace
} // namespace alcove
