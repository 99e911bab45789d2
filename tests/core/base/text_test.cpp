#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(Text, NumbersReadBackExactly) {
    for (const double value :
         {0.1, 1.0 / 3.0, 6.02214076e23, -0.0, 5e-324, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(parse_number(format_number(value), "test"), value);
    }
}

TEST(Text, NumbersMustFillTheWholeText) {
    for (const char* wrong : {"", " 1", "1 ", "1,5", "nan", "0x10", "one"}) {
        EXPECT_THROW(static_cast<void>(parse_number(wrong, "test")), InputError) << wrong;
    }
}

TEST(Text, RoundedNumbersKeepSignificantDigits) {
    EXPECT_EQ(format_rounded(0.0123456), "0.0123");
    EXPECT_EQ(format_rounded(12.3456), "12.3");
    EXPECT_EQ(format_rounded(1234.56), "1235");
    EXPECT_EQ(format_rounded(0.0), "0");
}

TEST(Text, KeyValuesNeedBothSides) {
    const std::vector<KeyValue> entries = parse_key_values("a=1,b==2", "test");
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[1].value, "=2");
    EXPECT_THROW(static_cast<void>(parse_key_values("a", "test")), InputError);
    EXPECT_THROW(static_cast<void>(parse_key_values("=1", "test")), InputError);
    EXPECT_THROW(static_cast<void>(parse_key_values("a=1,", "test")), InputError);
}

TEST(NearestName, CountsSwapsAsOneStep) {
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("samples", "sampels"), 1u);
}

} // namespace
} // namespace alcove
