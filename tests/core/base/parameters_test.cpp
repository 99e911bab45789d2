#include "core/base/parameters.hpp"

#include "core/base/error.hpp"
#include "core/base/expression.hpp"
#include "core/base/parameters_glsl.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace alcove {
namespace {

enum class Shape { box, sphere };

struct Params {
    int samples = 16;
    double radius = 0.5;
    double reach = 1.0;
    double cap = 1000.0;
    bool rotate = true;
    Shape shape = Shape::sphere;
};

ParameterTable make_table() {
    return describe_parameters(
        "unit",
        {
            integer(&Params::samples, "samples")
                .range(1, 64)
                .log_scale()
                .rebuild()
                .unit("samples")
                .meaning("a"),
            real(&Params::radius, "radius")
                .range(0.01, 10)
                .unit("m")
                .default_expression("scene_radius")
                .meaning("b"),
            real(&Params::reach, "reach")
                .range(0.01, 100)
                .unit("m")
                .default_expression("2 * radius")
                .meaning("c"),
            real(&Params::cap, "cap").range(1, 1500).may_be_infinite().unit("samples").meaning("d"),
            boolean(&Params::rotate, "rotate").rebuild().meaning("e"),
            choice(&Params::shape, "shape", {"box", "sphere"}).meaning("f"),
        });
}

const ExpressionVariables kVariables{{"scene_radius", 0.25}};

Params bind(std::vector<ParameterOverride> overrides) {
    const ParameterTable table = make_table();
    return table.bind<Params>(table.resolve(overrides, kVariables));
}

std::string message_of(std::vector<ParameterOverride> overrides) {
    try {
        static_cast<void>(bind(std::move(overrides)));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Parameters, DefaultsComeFromTheStructAndFromExpressions) {
    const Params params = bind({});
    EXPECT_EQ(params.samples, 16);
    EXPECT_DOUBLE_EQ(params.radius, 0.25);
    EXPECT_DOUBLE_EQ(params.reach, 0.5);
    EXPECT_TRUE(params.rotate);
    EXPECT_EQ(params.shape, Shape::sphere);
}

TEST(Parameters, ExpressionsFollowWhatTheyAreMadeOf) {
    EXPECT_DOUBLE_EQ(bind({{"radius", "3"}}).reach, 6.0);
    EXPECT_DOUBLE_EQ(bind({{"radius", "3"}, {"reach", "1"}}).reach, 1.0);
}

TEST(Parameters, EveryKindRoundTripsAtBothEnds) {
    const ParameterTable table = make_table();
    for (const ParameterTable::Entry& entry : table.entries()) {
        for (const bool maximum : {false, true}) {
            const std::string text = get_extreme(entry.info, maximum);
            const std::vector<ParameterOverride> overrides{{entry.info.name, text}};
            const Params params = table.bind<Params>(table.resolve(overrides, kVariables));
            EXPECT_EQ(to_text(table.read(params).get(entry.info.name)), text) << entry.info.name;
        }
    }
}

TEST(Parameters, LaterProvenanceWinsWhateverTheOrderGiven) {
    EXPECT_EQ(
        bind({{"samples", "8", Provenance::command_line}, {"samples", "4", Provenance::preset}})
            .samples,
        8);
    EXPECT_EQ(
        bind({{"samples", "8", Provenance::target}, {"samples", "4", Provenance::preset}}).samples,
        4);
}

TEST(Parameters, ProvenanceIsKept) {
    const std::vector<ParameterOverride> overrides{{"samples", "8", Provenance::preset}};
    const ResolvedParameters resolved = make_table().resolve(overrides, kVariables);
    EXPECT_EQ(resolved.values()[0].provenance, Provenance::preset);
    EXPECT_EQ(resolved.values()[1].provenance, Provenance::default_value);
}

TEST(Parameters, OutOfRangeIsAnErrorWithUnitAndRange) {
    EXPECT_EQ(message_of({{"samples", "65"}}),
              "unit.samples: out of range: found `65`, expected 1 to 64 samples");
    EXPECT_EQ(message_of({{"cap", "2000"}}),
              "unit.cap: out of range: found `2000`, expected 1 to 1500 or inf samples");
}

TEST(Parameters, InfinityOnlyWhereAllowed) {
    EXPECT_EQ(bind({{"cap", "inf"}}).cap, std::numeric_limits<double>::infinity());
    EXPECT_NE(message_of({{"radius", "inf"}}), "no error");
    EXPECT_NE(message_of({{"cap", "-inf"}}), "no error");
    EXPECT_NE(message_of({{"cap", "nan"}}), "no error");
}

TEST(Parameters, UnknownNamesGetTheNearest) {
    EXPECT_NE(message_of({{"sampels", "3"}}).find("(nearest: samples)"), std::string::npos);
    EXPECT_NE(message_of({{"shape", "spere"}}).find("(nearest: sphere)"), std::string::npos);
}

TEST(Parameters, WrongKindsAreErrors) {
    for (const char* text : {"", "1.5", "abc", "1x", "99999999999999999999"}) {
        EXPECT_NE(message_of({{"samples", text}}), "no error") << text;
    }
    EXPECT_NE(message_of({{"rotate", "yes"}}), "no error");
}

TEST(Parameters, DerivedDefaultOutOfRangeIsAnError) {
    const ParameterTable table = make_table();
    EXPECT_THROW(static_cast<void>(table.resolve({}, {{"scene_radius", 100.0}})), InputError);
}

TEST(Parameters, CirclesOfExpressionsAreErrors) {
    const ParameterTable table = describe_parameters(
        "unit",
        {
            real(&Params::radius, "radius").range(0, 10).default_expression("reach").meaning("b"),
            real(&Params::reach, "reach").range(0, 10).default_expression("radius").meaning("c"),
        });
    EXPECT_THROW(static_cast<void>(table.resolve({}, {})), InputError);
}

TEST(Parameters, GlslHasConstantsForRebuildAndABlockForTheRest) {
    const ParameterTable table = make_table();
    const std::string text = make_glsl_parameters(table, table.resolve({}, kVariables));
    EXPECT_NE(text.find("const int param_samples = 16;"), std::string::npos);
    EXPECT_NE(text.find("const bool param_rotate = true;"), std::string::npos);
    EXPECT_NE(text.find("const int param_shape_sphere = 1;"), std::string::npos);
    EXPECT_NE(text.find("float param_radius; // m"), std::string::npos);
    EXPECT_EQ(text.find("const float param_radius"), std::string::npos);
}

TEST(Parameters, BlockHoldsValuesInTableOrder) {
    const ParameterTable table = make_table();
    const std::vector<ParameterOverride> overrides{{"cap", "inf"}};
    const std::vector<std::byte> bytes =
        pack_parameter_block(table, table.resolve(overrides, kVariables));
    ASSERT_EQ(bytes.size(), 16u); // radius, reach, cap, shape
    float values[3];
    std::memcpy(values, bytes.data(), sizeof values);
    EXPECT_EQ(values[0], 0.25f);
    EXPECT_EQ(values[1], 0.5f);
    EXPECT_EQ(values[2], std::numeric_limits<float>::infinity());
    std::int32_t shape = 0;
    std::memcpy(&shape, bytes.data() + 12, sizeof shape);
    EXPECT_EQ(shape, 1);
}

TEST(Expression, FollowsArithmetic) {
    const auto lookup = [](std::string_view name) -> double {
        if (name == "x") {
            return 3.0;
        }
        throw InputError("unknown");
    };
    EXPECT_DOUBLE_EQ(evaluate_expression("1 + 2 * x", lookup), 7.0);
    EXPECT_DOUBLE_EQ(evaluate_expression("(1 + 2) * x - -1", lookup), 10.0);
    EXPECT_DOUBLE_EQ(evaluate_expression("min(x, 2) / max(4, x)", lookup), 0.5);
    EXPECT_DOUBLE_EQ(evaluate_expression("2e-1", lookup), 0.2);
    for (const char* wrong : {"", "1 +", "(1", "1 2", "y", "min(1)", "x x"}) {
        EXPECT_THROW(static_cast<void>(evaluate_expression(wrong, lookup)), InputError) << wrong;
    }
}

} // namespace
} // namespace alcove
