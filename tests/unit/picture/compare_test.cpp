// The measure of pictures: its figures by hand, what passes, and that each small fault is found. tests/cli/verify_test
// draws the faults that take a program.

#include "picture/compare.h"
#include "picture/read_png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace vp::picture::test
{

namespace
{

using render::Picture;
using Pixel = std::array<std::uint8_t, 4>;

Picture made(std::uint32_t width, std::uint32_t height, const std::function<Pixel(std::uint32_t, std::uint32_t)>& pixel)
{
	Picture picture{width, height, {}};
	for (std::uint32_t y = 0; y < height; ++y)
		for (std::uint32_t x = 0; x < width; ++x)
			for (const std::uint8_t value : pixel(x, y))
				picture.rgba.push_back(value);
	return picture;
}

Picture plain(std::uint32_t width, std::uint32_t height, Pixel pixel)
{
	return made(width, height, [&](std::uint32_t, std::uint32_t) { return pixel; });
}

void put(Picture& picture, std::uint32_t x, std::uint32_t y, Pixel pixel)
{
	std::ranges::copy(pixel, &picture.rgba[4 * (std::size_t(y) * picture.width + x)]);
}

PictureDifference difference(const Picture& expected, const Picture& drawn)
{
	Result<PictureDifference> found = comparePictures(expected, drawn);
	EXPECT_TRUE(found) << found.error().message;
	return found ? *found : PictureDifference();
}

bool pass(const Picture& expected, const Picture& drawn)
{
	return difference(expected, drawn).isWithin(toleranceOf(8));
}

// Three sheets with a legend, 320 x 240, drawn by this program.
Picture drawnPicture()
{
	Result<Picture> read = readPng(std::string(BASELINES) + "/three_sheets.png");
	EXPECT_TRUE(read) << read.error().message;
	return *read;
}

} // namespace

TEST(ComparePictures, EqualOnes)
{
	const PictureDifference found = difference(drawnPicture(), drawnPicture());
	EXPECT_EQ(found.similarity, 1.0);
	EXPECT_EQ(found.mean, 0.0);
	EXPECT_EQ(found.text(), "equal");
}

TEST(ComparePictures, FiguresByHand)
{
	// Constant tiles have no variance: equation 13 leaves (2 a b + C1) / (a^2 + b^2 + C1) with C1 = 2.55^2 = 6.5025.
	const PictureDifference colors = difference(plain(16, 16, {100, 50, 50, 255}), plain(16, 16, {110, 50, 50, 255}));
	EXPECT_NEAR(colors.similarity, (2.0 * 100.0 * 110.0 + 6.5025) / (100.0 * 100.0 + 110.0 * 110.0 + 6.5025), 1e-12);
	EXPECT_DOUBLE_EQ(colors.mean, 10.0);
	EXPECT_EQ(colors.channel, 0);

	// Stripes of 0 and 200 against the same stripes, exchanged. Their means are 100, their variance of 256 samples is
	// 100^2 * 256 / 255, and their covariance is minus that. C2 = 7.65^2 = 58.5225.
	const auto stripes = [](std::uint32_t first)
	{
		return made(16, 16,
		            [&](std::uint32_t x, std::uint32_t) {
			            return Pixel{0, static_cast<std::uint8_t>(x % 2 == first ? 200 : 0), 0, 255};
		            });
	};
	const double variance = 100.0 * 100.0 * 256.0 / 255.0;
	const PictureDifference moved = difference(stripes(0), stripes(1));
	EXPECT_NEAR(moved.similarity, (58.5225 - 2.0 * variance) / (2.0 * variance + 58.5225), 1e-12);
	EXPECT_EQ(moved.mean, 0.0); // blind to what moved within the tile
}

TEST(ComparePictures, TellsTheSignTheChannelAndThePlace)
{
	Picture expected = plain(100, 70, {90, 90, 90, 255});
	Picture drawn = expected;
	for (std::uint32_t y = 60; y < 70; ++y) // in the last row of tiles, which ends at the rim
		for (std::uint32_t x = 90; x < 100; ++x)
			put(drawn, x, y, {90, 90, 40, 255});
	const PictureDifference found = difference(expected, drawn);
	EXPECT_DOUBLE_EQ(found.mean, -50.0 * 100.0 / 256.0);
	EXPECT_EQ(found.channel, 2);
	EXPECT_EQ(found.farthest.x, 84u);
	EXPECT_EQ(found.farthest.y, 54u);
	EXPECT_NE(found.text().find("mean -19.53 of blue at 84,54"), std::string::npos) << found.text();
}

TEST(ComparePictures, AnotherSizeIsADifferenceToldInALine)
{
	const auto found = comparePictures(plain(20, 10, {}), plain(10, 20, {}));
	ASSERT_FALSE(found);
	EXPECT_EQ(found.error().kind, ErrorKind::found);
	EXPECT_EQ(found.error().message, "the expected picture has 20 x 10 pixels, and the drawn one 10 x 20");
	EXPECT_TRUE(pass(plain(0, 0, {}), plain(0, 0, {})));
	EXPECT_FALSE(pass(plain(3, 1, {0, 0, 0, 255}), plain(3, 1, {90, 0, 0, 255}))); // smaller than a tile
}

TEST(ComparePictures, AlphaCounts)
{
	// A color that nobody sees does not matter.
	EXPECT_EQ(difference(plain(32, 32, {255, 0, 0, 0}), plain(32, 32, {0, 0, 255, 0})).text(), "equal");
	const PictureDifference found = difference(plain(32, 32, {0, 0, 0, 255}), plain(32, 32, {0, 0, 0, 250}));
	EXPECT_DOUBLE_EQ(found.mean, -5.0);
	EXPECT_EQ(found.channel, 3);
	EXPECT_FALSE(found.isWithin({}));
}

TEST(ComparePictures, NoiseOfADriverPasses)
{
	const Picture expected = drawnPicture();
	// Rounding: each channel is off by one at most.
	std::minstd_rand random(5);
	Picture rounded = expected;
	for (std::size_t i = 0; i < rounded.rgba.size(); ++i)
		if (i % 4 != 3)
			rounded.rgba[i] =
			    static_cast<std::uint8_t>(std::clamp<int>(rounded.rgba[i] + int(random() % 3) - 1, 0, 255));
	EXPECT_TRUE(pass(expected, rounded)) << difference(expected, rounded).text();

	// An edge with contrast 100 that lies elsewhere by a tenth of a pixel.
	const auto edge = [](double at)
	{
		return made(64, 64,
		            [&](std::uint32_t x, std::uint32_t y)
		            {
			            const double inside = std::clamp(at + 0.3 * y - x, 0.0, 1.0);
			            return Pixel{static_cast<std::uint8_t>(std::lround(60.0 + 100.0 * inside)), 60, 60, 255};
		            });
	};
	EXPECT_TRUE(pass(edge(20.0), edge(20.1))) << difference(edge(20.0), edge(20.1)).text();
	// By a whole pixel it is another picture.
	EXPECT_FALSE(pass(edge(20.0), edge(21.0)));

	// One pixel at an edge.
	Picture one = expected;
	put(one, 100, 100, {255, 255, 255, 255});
	EXPECT_TRUE(difference(expected, one).isWithin(toleranceOf(1))) << difference(expected, one).text();
}

TEST(ComparePictures, AMissingPolygonOfFourPixelsIsFound)
{
	const Picture expected = drawnPicture();
	int faults = 0;
	// Everywhere within the sheet that lies, wherever it falls among the tiles. The background is black.
	for (std::uint32_t y = 112; y < 128; ++y)
		for (std::uint32_t x = 86; x < 110; ++x)
			for (const std::uint32_t width : {1u, 2u, 4u})
			{
				Picture drawn = expected;
				for (std::uint32_t i = 0; i < 4; ++i)
					put(drawn, x + i % width, y + i / width, {0, 0, 0, 255});
				faults += pass(expected, drawn);
			}
	EXPECT_EQ(faults, 0);
}

TEST(ComparePictures, ASheetMovedByAPixelIsFound)
{
	const Picture expected = drawnPicture();
	for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
	{
		Picture drawn = expected;
		for (std::uint32_t y = 50; y < 190; ++y)
			for (std::uint32_t x = 50; x < 220; ++x)
				put(drawn, x, y, expected.pixel(std::uint32_t(int(x) + dx), std::uint32_t(int(y) + dy)));
		EXPECT_FALSE(pass(expected, drawn)) << dx << dy << ' ' << difference(expected, drawn).text();
	}
}

TEST(ComparePictures, FewSamplesHaveAWiderTolerance)
{
	EXPECT_EQ(toleranceOf(8), PictureTolerance());
	EXPECT_LT(toleranceOf(4).similarity, toleranceOf(8).similarity);
	EXPECT_GT(toleranceOf(1).mean, toleranceOf(16).mean);
}

TEST(ComparePictures, ThePictureOfTheDifferenceShowsWhere)
{
	const Picture expected = plain(4, 1, {100, 100, 100, 255});
	Picture drawn = expected;
	put(drawn, 1, 0, {110, 100, 100, 255});
	put(drawn, 2, 0, {100, 100, 100, 155});
	const Picture shown = pictureOfDifference(expected, drawn);
	EXPECT_EQ(shown.pixel(0, 0), shown.pixel(3, 0));
	EXPECT_EQ(shown.pixel(0, 0)[0], shown.pixel(0, 0)[2]);   // gray
	EXPECT_EQ(shown.pixel(1, 0), (Pixel{230, 138, 0, 255})); // 10 levels, eightfold: 200 - 80 * 200 / 255
	EXPECT_EQ(shown.pixel(2, 0), (Pixel{230, 0, 0, 255}));   // 100 levels of alpha
}

} // namespace vp::picture::test
