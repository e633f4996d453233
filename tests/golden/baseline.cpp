#include "baseline.h"

#include "write/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace vp::render::test
{

namespace
{

constexpr int kLargeDifference = 24; // difference of a channel
constexpr double kMaxLarge = 0.005;  // part of the pixels with a large difference
constexpr double kMaxBeyond = 0.002; // part of the pixels that differ from all others within a reach
constexpr double kMaxMean = 0.5;     // mean difference of a channel

// How far a channel of the pixel lies, at most, outside the range that the other picture has around that place.
int largestDifference(const Picture& picture, const Picture& other, std::uint32_t x, std::uint32_t y, int reach)
{
	std::array<int, 4> lo{255, 255, 255, 255};
	std::array<int, 4> hi{};
	for (int j = std::max(int(y) - reach, 0); j <= std::min(int(y) + reach, int(other.height) - 1); ++j)
		for (int i = std::max(int(x) - reach, 0); i <= std::min(int(x) + reach, int(other.width) - 1); ++i)
		{
			const auto near = other.pixel(std::uint32_t(i), std::uint32_t(j));
			for (std::size_t c = 0; c < 4; ++c)
			{
				lo[c] = std::min<int>(lo[c], near[c]);
				hi[c] = std::max<int>(hi[c], near[c]);
			}
		}
	const auto pixel = picture.pixel(x, y);
	int largest = 0;
	for (std::size_t c = 0; c < 4; ++c)
		largest = std::max({largest, lo[c] - pixel[c], pixel[c] - hi[c]});
	return largest;
}

} // namespace

Picture readPng(const std::string& path)
{
	png_image image{};
	image.version = PNG_IMAGE_VERSION;
	if (!png_image_begin_read_from_file(&image, path.c_str()))
		return {};
	image.format = PNG_FORMAT_RGBA;
	Picture picture{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
	if (!png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr))
		return {};
	return picture;
}

testing::AssertionResult looksLike(const Picture& picture, const std::string& name, int reach)
{
	const std::string path = std::string(BASELINES) + "/" + name + ".png";
	const char* update = std::getenv("VPROBE_UPDATE_GOLDEN");
	if (update && std::string_view(update) == "1")
	{
		const Status written = write::writePng(picture, path);
		return written ? testing::AssertionSuccess() : testing::AssertionFailure() << written.error().message;
	}
	const auto differs = [&]
	{
		const Status kept = write::writePng(picture, name + ".png");
		return testing::AssertionFailure() << name << (kept ? ".png (kept here) differs: " : " differs: ");
	};
	const Picture baseline = readPng(path);
	if (baseline.width != picture.width || baseline.height != picture.height)
		return differs() << "the baseline is missing or has another size; VPROBE_UPDATE_GOLDEN=1 writes it";
	std::size_t large = 0;
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
			// Both ways: neither may have what the other lacks.
			large += largestDifference(picture, baseline, x, y, reach) > kLargeDifference ||
			         largestDifference(baseline, picture, x, y, reach) > kLargeDifference;
	double sum = 0.0;
	for (std::size_t i = 0; i < picture.rgba.size(); ++i)
		sum += std::abs(int(picture.rgba[i]) - int(baseline.rgba[i]));
	const double pixels = static_cast<double>(picture.rgba.size() / 4);
	const double mean = sum / (4.0 * pixels);
	if (static_cast<double>(large) > (reach ? kMaxBeyond : kMaxLarge) * pixels || mean > kMaxMean)
		return differs() << large << " pixels by more than " << kLargeDifference << ", mean " << mean;
	return testing::AssertionSuccess();
}

} // namespace vp::render::test
