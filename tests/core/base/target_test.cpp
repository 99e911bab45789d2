#include "core/base/error.hpp"
#include "core/base/target.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(Target, DescriptionReadsBack) {
    Target target;
    target.radius_m = 0.123456789012345;
    target.falloff = Falloff::quadratic;
    target.weighting = Weighting::uniform;
    target.normals = Normals::geometric;
    EXPECT_EQ(parse_target(describe(target), {}), target);
    target.output = TargetOutput::radiance;
    EXPECT_EQ(parse_target(describe(target), {}), target);
    target.reach = Reach::full;
    EXPECT_EQ(parse_target(describe(target), {}), target);
}

TEST(Target, OnlyRadianceSaysWhatItsOutputIs) {
    EXPECT_EQ(describe(Target{}), "radius=1,falloff=linear,weighting=cosine,normals=shading");
    EXPECT_EQ(
        describe(parse_target("output=radiance", {})),
        "radius=1,falloff=linear,weighting=cosine,normals=shading,output=radiance,reach=near");
}

TEST(Target, BadTargetsAreErrors) {
    for (const char* wrong :
         {"radius=0", "radius=-1", "radius=inf", "falloff=cubic", "size=1", "radius=1,radius=2",
          "radius", "output=picture", "reach=far,output=radiance"}) {
        EXPECT_THROW(static_cast<void>(parse_target(wrong, {})), InputError) << wrong;
    }
}

TEST(Target, VisibilityHasNoFullReach) {
    EXPECT_THROW(static_cast<void>(parse_target("reach=full", {})), InputError);
    EXPECT_THROW(static_cast<void>(parse_target("reach=full,output=visibility", {})), InputError);
    EXPECT_EQ(parse_target("reach=full,output=radiance", {}).reach, Reach::full);
}

} // namespace
} // namespace alcove
