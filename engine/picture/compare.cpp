#include "picture/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace vp::picture
{

namespace
{

constexpr std::array<const char*, 4> kChannelNames{"red", "green", "blue", "alpha"};

// A pixel that is there in one picture alone, as seenValue() counts.
constexpr std::int64_t kWholePixel = 255 * 255;

// Sums over the pixels of a tile, for one channel of both pictures. Whole numbers are exact, whatever the order.
struct TileSums
{
	std::int64_t a = 0, b = 0, aa = 0, bb = 0, ab = 0, apart = 0;
};

// The value of a channel as it is seen, of 255 * 255: colors times alpha.
int seenValue(const std::uint8_t* pixel, std::size_t channel)
{
	return channel == 3 ? 255 * pixel[3] : pixel[channel] * pixel[3];
}

// Wang et al., equation 13. The values go up to 255 * 255.
double similarityOf(const TileSums& sums, double count)
{
	constexpr double kLevels = 255.0 * 255.0;
	constexpr double kC1 = (0.01 * kLevels) * (0.01 * kLevels);
	constexpr double kC2 = (0.03 * kLevels) * (0.03 * kLevels);
	const double mean_a = static_cast<double>(sums.a) / count;
	const double mean_b = static_cast<double>(sums.b) / count;
	// The variances are those of a sample, as in equation 6.
	const double fewer = std::max(count - 1.0, 1.0);
	const double var_a = (static_cast<double>(sums.aa) - count * mean_a * mean_a) / fewer;
	const double var_b = (static_cast<double>(sums.bb) - count * mean_b * mean_b) / fewer;
	const double covariance = (static_cast<double>(sums.ab) - count * mean_a * mean_b) / fewer;
	return (2.0 * mean_a * mean_b + kC1) * (2.0 * covariance + kC2) /
	       ((mean_a * mean_a + mean_b * mean_b + kC1) * (var_a + var_b + kC2));
}

// Compares one tile with all four channels, and keeps what is worse than before.
void compareTile(const render::Picture& expected, const render::Picture& drawn, TilePlace place, std::uint32_t width,
                 std::uint32_t height, PictureDifference& worst)
{
	const double count = static_cast<double>(width) * height;
	for (std::size_t c = 0; c < 4; ++c)
	{
		TileSums sums;
		for (std::uint32_t y = place.y; y < place.y + height; ++y)
		{
			const std::size_t row = 4 * (std::size_t(y) * expected.width + place.x);
			for (std::size_t i = row; i < row + std::size_t(4) * width; i += 4)
			{
				const std::int64_t a = seenValue(&expected.rgba[i], c);
				const std::int64_t b = seenValue(&drawn.rgba[i], c);
				sums.a += a;
				sums.b += b;
				sums.aa += a * a;
				sums.bb += b * b;
				sums.ab += a * b;
				sums.apart += std::abs(a - b);
			}
		}
		if (const double similarity = similarityOf(sums, count);
		    similarity < worst.similarity && sums.apart >= kWholePixel)
		{
			worst.similarity = similarity;
			worst.least_similar = place;
		}
		if (const double mean = static_cast<double>(sums.b - sums.a) / (255.0 * count);
		    std::abs(mean) > std::abs(worst.mean))
		{
			worst.mean = mean;
			worst.channel = static_cast<int>(c);
			worst.farthest = place;
		}
	}
}

bool tilesEqual(const render::Picture& expected, const render::Picture& drawn, TilePlace place, std::uint32_t width,
                std::uint32_t height)
{
	for (std::uint32_t y = place.y; y < place.y + height; ++y)
	{
		const std::size_t row = 4 * (std::size_t(y) * expected.width + place.x);
		if (!std::equal(&expected.rgba[row], &expected.rgba[row] + std::size_t(4) * width, &drawn.rgba[row]))
			return false;
	}
	return true;
}

} // namespace

PictureTolerance toleranceOf(int samples)
{
	constexpr int kManySamples = 8;
	return samples >= kManySamples ? PictureTolerance{} : PictureTolerance{.similarity = 0.86, .mean = 3.2};
}

bool PictureDifference::isWithin(const PictureTolerance& tolerance) const
{
	return similarity >= tolerance.similarity && std::abs(mean) <= tolerance.mean;
}

std::string PictureDifference::text() const
{
	if (similarity == 1.0 && mean == 0.0)
		return "equal";
	const std::string where = similarity == 1.0 ? "" : fmt::format(" at {},{}", least_similar.x, least_similar.y);
	return fmt::format("similarity {:.4f}{}, mean {:+.2f} of {} at {},{}", similarity, where, mean,
	                   kChannelNames[static_cast<std::size_t>(channel)], farthest.x, farthest.y);
}

Result<PictureDifference> comparePictures(const render::Picture& expected, const render::Picture& drawn)
{
	if (expected.width != drawn.width || expected.height != drawn.height)
		return Error{ErrorKind::found, fmt::format("the expected picture has {} x {} pixels, and the drawn one {} x {}",
		                                           expected.width, expected.height, drawn.width, drawn.height)};
	PictureDifference worst;
	const std::uint32_t width = std::min(kTileSize, expected.width);
	const std::uint32_t height = std::min(kTileSize, expected.height);
	// The last tiles of a row and of a column end at the rim, so all tiles have the same size.
	const auto next = [](std::uint32_t at, std::uint32_t last)
	{ return at == last ? last + 1 : std::min(at + kTileSize / 2, last); };
	if (expected.rgba.empty())
		return worst;
	for (TilePlace place; place.y <= expected.height - height; place.y = next(place.y, expected.height - height))
		for (place.x = 0; place.x <= expected.width - width; place.x = next(place.x, expected.width - width))
			if (!tilesEqual(expected, drawn, place, width, height))
				compareTile(expected, drawn, place, width, height, worst);
	return worst;
}

render::Picture pictureOfDifference(const render::Picture& expected, const render::Picture& drawn)
{
	constexpr int kTimes = 8;
	render::Picture picture{expected.width, expected.height, expected.rgba};
	for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
	{
		int apart = 0;
		int light = 0;
		for (std::size_t c = 0; c < 4; ++c)
		{
			const int seen = seenValue(&expected.rgba[i], c);
			apart = std::max(apart, (std::abs(seen - seenValue(&drawn.rgba[i], c)) + 254) / 255);
			light += c < 3 ? seen / 255 : 0;
		}
		std::uint8_t* pixel = &picture.rgba[i];
		const int strength = std::min(kTimes * apart, 255);
		const auto pale = static_cast<std::uint8_t>(200 + light * 40 / (3 * 255));
		pixel[0] = apart ? 230 : pale;
		pixel[1] = apart ? static_cast<std::uint8_t>(200 - strength * 200 / 255) : pale;
		pixel[2] = apart ? 0 : pale;
		pixel[3] = 255;
	}
	return picture;
}

} // namespace vp::picture
