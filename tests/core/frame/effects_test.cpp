#include "core/frame/effects.hpp"

#include "core/base/error.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(Effects, AreReadBackAsTheyAreDescribed) {
    EXPECT_EQ(describe(EffectSet::all()), "all");
    EffectSet effects = EffectSet::all();
    effects.remove(Effect::reprojection);
    effects.remove(Effect::light_buffers);
    EXPECT_EQ(describe(effects), "without reprojection,light_buffers");
    EXPECT_EQ(parse_effects(describe(effects)), effects);
    EXPECT_EQ(parse_effects("all"), EffectSet::all());
    EXPECT_TRUE(effects.contains(Effect::object_motion));
    EXPECT_FALSE(effects.contains(Effect::reprojection));
}

TEST(Effects, UnknownOnesAreNamedWithTheNearest) {
    for (const char* text : {"", "none", "without", "without ", "without reprojektion"}) {
        SCOPED_TRACE(text);
        EXPECT_THROW(static_cast<void>(parse_effects(text)), InputError);
    }
    try {
        static_cast<void>(parse_effects("without reprojektion"));
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("nearest: reprojection"), std::string::npos);
    }
}

} // namespace
} // namespace alcove
