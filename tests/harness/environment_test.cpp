#include "harness/run/environment.hpp"

#include "tests/harness/expect_error.hpp"

namespace alcove {
namespace {

ContextRecord make_context() {
    ContextRecord record;
    record.build_id = "0123456789abcdef";
    record.gl_renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    record.gl_version = "4.5 (Core Profile) Mesa 22.3.6";
    record.timer_mode = "timestamp_finish";
    record.cpu_features = "sse4_1 avx";
    return record;
}

TEST(Environment, TheSameOneContinues) {
    ContextRecord later = make_context();
    later.started_utc = "2031-01-01T00:00:00Z";
    EXPECT_NO_THROW(check_same_environment(make_context(), later));
}

TEST(Environment, AnotherBuildIsRefusedNamingBoth) {
    ContextRecord here = make_context();
    here.build_id = "fedcba9876543210";
    expect_error([&] { check_same_environment(make_context(), here); }, 2,
                 {"--resume", "build", "0123456789abcdef", "fedcba9876543210"});
}

TEST(Environment, AnotherDriverIsRefusedNamingBoth) {
    ContextRecord here = make_context();
    here.gl_version = "4.5 (Core Profile) Mesa 25.0.1";
    expect_error([&] { check_same_environment(make_context(), here); }, 2,
                 {"driver", "Mesa 22.3.6", "Mesa 25.0.1"});
    here = make_context();
    here.gl_renderer = "llvmpipe (LLVM 19.1.7, 512 bits)";
    expect_error([&] { check_same_environment(make_context(), here); }, 2,
                 {"renderer", "256 bits", "512 bits"});
}

TEST(Environment, AnotherClockIsRefusedNamingBoth) {
    ContextRecord here = make_context();
    here.timer_mode = "fenced_wall";
    expect_error([&] { check_same_environment(make_context(), here); }, 2,
                 {"timer", "timestamp_finish", "fenced_wall"});
}

TEST(Environment, OtherCpuFeaturesAreRefusedNamingBoth) {
    // Images hash alike only between equal CPU features (DESIGN 6).
    ContextRecord here = make_context();
    here.cpu_features = "sse4_1";
    expect_error([&] { check_same_environment(make_context(), here); }, 2,
                 {"CPU", "sse4_1 avx", "`sse4_1`"});
}

TEST(Environment, StampSortsByTimeAndSuitsAFolder) {
    const std::string stamp = make_utc_stamp();
    ASSERT_EQ(stamp.size(), 16u);
    EXPECT_EQ(stamp[8], 'T');
    EXPECT_EQ(stamp.back(), 'Z');
    EXPECT_EQ(stamp.find_first_not_of("0123456789TZ"), std::string::npos);
}

} // namespace
} // namespace alcove
