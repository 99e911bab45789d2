#include "harness/run/experiment.hpp"

#include "tests/harness/expect_error.hpp"

namespace alcove {
namespace {

TEST(MethodSpec, NameAloneIsTheDefaultPreset) {
    const MethodSpec spec = parse_method_spec("hemisphere_ssao");
    EXPECT_EQ(spec.method, "hemisphere_ssao");
    EXPECT_EQ(spec.preset, "default");
    EXPECT_TRUE(spec.overrides.empty());
    EXPECT_EQ(spec.label, "hemisphere_ssao");
}

TEST(MethodSpec, AllPartsAreRead) {
    const MethodSpec spec = parse_method_spec("m@weak:samples=32,radius=0.5#my label: a=b@c");
    EXPECT_EQ(spec.method, "m");
    EXPECT_EQ(spec.preset, "weak");
    ASSERT_EQ(spec.overrides.size(), 2u);
    EXPECT_EQ(spec.overrides[0].name, "samples");
    EXPECT_EQ(spec.overrides[0].value, "32");
    EXPECT_EQ(spec.overrides[1].name, "radius");
    EXPECT_EQ(spec.overrides[1].value, "0.5");
    EXPECT_EQ(spec.overrides[1].provenance, Provenance::command_line);
    EXPECT_EQ(spec.label, "my label: a=b@c");
}

TEST(MethodSpec, LabelIsTheTextWhereNoneIsGiven) {
    EXPECT_EQ(parse_method_spec("m:samples=32").label, "m:samples=32");
    EXPECT_EQ(parse_method_spec("m@weak:samples=32").label, "m@weak:samples=32");
}

TEST(MethodSpec, WhatCannotBeReadIsNamed) {
    expect_error([] { static_cast<void>(parse_method_spec("m#")); }, 2,
                 {"--method", "label", "m#"});
    expect_error([] { static_cast<void>(parse_method_spec("m:samples")); }, 2,
                 {"--method", "samples"});
    expect_error([] { static_cast<void>(parse_method_spec("m:=3")); }, 2, {"--method"});
    expect_error([] { static_cast<void>(parse_method_spec("m:")); }, 2, {"--method"});
    expect_error([] { static_cast<void>(parse_method_spec("m:samples=8,")); }, 2, {"--method"});
}

TEST(Size, SmallestAndLargestAreAccepted) {
    EXPECT_EQ(parse_size("1x1"), (ImageSize{1, 1}));
    EXPECT_EQ(parse_size("384x288"), (ImageSize{384, 288}));
    EXPECT_EQ(parse_size("16384x16384"), (ImageSize{16384, 16384}));
}

TEST(Size, WhatNoImageHasIsRefused) {
    for (const char* text :
         {"0x0", "0x1", "1x0", "-3x4", "16385x1", "1x16385", "384", "384x", "x288", "384x288x3",
          "384X288", "3.5x4", "", "99999999999999999999x1", "2147483648x2147483648", " 3x4"}) {
        SCOPED_TRACE(text);
        expect_error([&] { static_cast<void>(parse_size(text)); }, 2, {"--size"});
    }
    expect_error([] { static_cast<void>(parse_size("0x0")); }, 2, {"0x0", "1 to 16384"});
}

} // namespace
} // namespace alcove
