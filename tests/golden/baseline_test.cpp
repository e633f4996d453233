#include "baseline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include <unistd.h>

namespace vp::render::test
{

namespace
{

Picture expectedPicture()
{
	return readPng(std::string(BASELINES) + "/three_sheets.png");
}

// Shifts the content by some pixels to the right; the left column is repeated.
Picture shifted(const Picture& picture, std::uint32_t pixels)
{
	Picture moved = picture;
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
			for (std::size_t c = 0; c < 4; ++c)
				moved.rgba[4 * (std::size_t(y) * picture.width + x) + c] =
				    picture.rgba[4 * (std::size_t(y) * picture.width + x - std::min(x, pixels)) + c];
	return moved;
}

Picture changed(Picture picture, const PictureBox& box, const std::function<void(std::uint8_t*)>& change)
{
	for (std::uint32_t y = box.y0; y < box.y1; ++y)
		for (std::uint32_t x = box.x0; x < box.x1; ++x)
			change(&picture.rgba[4 * (std::size_t(y) * picture.width + x)]);
	return picture;
}

} // namespace

TEST(Baseline, ItsOwnPicturePasses)
{
	const Picture expected = expectedPicture();
	ASSERT_EQ(expected.width, 320u);
	EXPECT_TRUE(passes(expected, expected));
	EXPECT_TRUE(looksLike(expected, "three_sheets"));
	// A driver that rounds a tenth of the pixels in another way.
	int pixels = 0;
	EXPECT_TRUE(
	    passes(expected, changed(expected, {0, 0, 320, 240},
	                             [&](std::uint8_t* pixel) { pixel[1] ^= std::uint8_t(++pixels % 10 == 0 ? 1 : 0); })));
}

TEST(Baseline, WrongPicturesFail)
{
	const Picture expected = expectedPicture();
	EXPECT_FALSE(passes(expected, shifted(expected, 1)));
	const auto blacken = [](std::uint8_t* pixel) { std::fill_n(pixel, 3, std::uint8_t(0)); };
	const auto lessGreen = [](std::uint8_t* pixel) { pixel[1] = static_cast<std::uint8_t>(pixel[1] * 9 / 10); };
	EXPECT_FALSE(passes(expected, changed(expected, {150, 120, 152, 122}, blacken))); // a small hole in a sheet
	EXPECT_FALSE(passes(expected, changed(expected, {0, 0, 320, 240}, lessGreen)));
	EXPECT_FALSE(passes(expected, partOf(expected, {0, 0, 319, 240}))); // it has another size
	EXPECT_FALSE(passes(expected, Picture{}));
}

TEST(Baseline, APictureThatDiffersIsKept)
{
	const std::filesystem::path before = std::filesystem::current_path();
	const std::filesystem::path folder =
	    std::filesystem::temp_directory_path() / ("vprobe_baseline_" + std::to_string(getpid()));
	std::filesystem::create_directories(folder);
	std::filesystem::current_path(folder);
	const Picture wrong = shifted(expectedPicture(), 2);
	const testing::AssertionResult looks = looksLike(wrong, "three_sheets");
	EXPECT_FALSE(looks);
	EXPECT_NE(std::string(looks.message()).find("similarity"), std::string::npos) << looks.message();
	EXPECT_EQ(readPng("three_sheets.png").rgba, wrong.rgba);
	// The wrong part alone counts, and only if it is asked for.
	const Picture hole = changed(expectedPicture(), {150, 120, 160, 130},
	                             [](std::uint8_t* pixel) { std::fill_n(pixel, 3, std::uint8_t(0)); });
	EXPECT_FALSE(looksLike(hole, "three_sheets", PictureBox{100, 100, 200, 200}));
	EXPECT_TRUE(looksLike(hole, "three_sheets", PictureBox{0, 0, 140, 110}));
	EXPECT_FALSE(looksLike(wrong, "a name without a baseline"));
	std::filesystem::current_path(before);
	std::filesystem::remove_all(folder);
}

} // namespace vp::render::test
