#include "core/base/domain.hpp"
#include "core/base/error.hpp"
#include "core/base/image.hpp"
#include "core/base/image_file.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class ImageFileTest : public testing::Test {
  protected:
    TemporaryFolder m_own;
    const fs::path& m_folder = m_own.path();
};

Image make_gradient(int channels) {
    Image image({17, 9}, channels);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 17; ++x) {
            for (int c = 0; c < channels; ++c) {
                image.at(x, y, c) = static_cast<float>(x + 17 * y + c) / 160.0f;
            }
        }
    }
    return image;
}

TEST(Image, HashSeesEveryValueAndTheShape) {
    const Image a = make_gradient(1);
    Image b = a;
    EXPECT_EQ(hash_image(a), hash_image(b));
    b.at(16, 8) = std::nextafter(b.at(16, 8), 2.0f);
    EXPECT_NE(hash_image(a), hash_image(b));
    EXPECT_NE(hash_image(Image({4, 2}, 1)), hash_image(Image({2, 4}, 1)));
}

TEST(Image, FindsTheFirstValueThatIsNotFinite) {
    Image image = make_gradient(3);
    PixelPosition position;
    EXPECT_FALSE(find_non_finite(image, position));
    image.at(5, 7, 2) = std::numeric_limits<float>::quiet_NaN();
    ASSERT_TRUE(find_non_finite(image, position));
    EXPECT_EQ(position.x, 5);
    EXPECT_EQ(position.y, 7);
    EXPECT_EQ(position.channel, 2);
}

TEST_F(ImageFileTest, ExrKeepsEveryFloatAndTheDomain) {
    const Image image = make_gradient(2);
    write_exr(m_folder / "a.exr", image, Domain::visibility);
    const ImageFile file = read_image_file(m_folder / "a.exr");
    EXPECT_EQ(hash_image(file.image), hash_image(image));
    EXPECT_EQ(file.domain, Domain::visibility);
}

TEST_F(ImageFileTest, PngKeepsCodesAndTheDomain) {
    const Image image = make_gradient(3);
    write_png(m_folder / "a.png", image, Domain::view);
    const ImageFile file = read_image_file(m_folder / "a.png");
    EXPECT_EQ(file.domain, Domain::view);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        EXPECT_NEAR(file.image.values()[i], image.values()[i], 0.5 / 255.0 + 1e-6);
    }
    EXPECT_EQ(read_image_file(m_folder / "a.png", Domain::srgb).domain, Domain::srgb);
}

TEST_F(ImageFileTest, BadFilesAreInputErrors) {
    EXPECT_THROW(static_cast<void>(read_image_file(m_folder / "none.png")), InputError);
    EXPECT_THROW(static_cast<void>(read_image_file(m_folder)), InputError);
    std::ofstream(m_folder / "text.png") << "no image";
    EXPECT_THROW(static_cast<void>(read_image_file(m_folder / "text.png")), InputError);
    write_exr(m_folder / "cut.exr", make_gradient(3), Domain::linear);
    fs::resize_file(m_folder / "cut.exr", fs::file_size(m_folder / "cut.exr") / 2);
    EXPECT_THROW(static_cast<void>(read_image_file(m_folder / "cut.exr")), InputError);
}

TEST(Domain, SrgbRoundTripsAndKnowsItsKnee) {
    EXPECT_NEAR(encode_srgb(0.5f), 0.735357f, 1e-6);
    EXPECT_NEAR(encode_srgb(0.001f), 0.01292f, 1e-7);
    for (float x = 0.0f; x <= 1.0f; x += 1.0f / 64.0f) {
        EXPECT_NEAR(decode_srgb(encode_srgb(x)), x, 1e-6);
    }
}

TEST(Domain, LumaWeighsAsRec709) {
    Image image({1, 1}, 3);
    image.at(0, 0, 0) = 1.0f;
    EXPECT_FLOAT_EQ(compute_luma(image).at(0, 0), 0.2126f);
    image.at(0, 0, 1) = image.at(0, 0, 2) = 1.0f;
    EXPECT_NEAR(compute_luma(image).at(0, 0), 1.0f, 1e-6);
}

} // namespace
} // namespace alcove
