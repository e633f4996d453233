#include "baseline.h"

#include "write/png.h"

#include <png.h>

#include <cstdlib>
#include <string_view>

namespace vp::render::test
{

namespace
{

constexpr int kLargeDifference = 24; // of a channel
constexpr double kMaxLarge = 0.005;  // of the pixels
constexpr double kMaxMean = 0.5;     // of a channel, over the picture

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

testing::AssertionResult looksLike(const Picture& picture, const std::string& name)
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
	double sum = 0.0;
	for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
	{
		int most = 0;
		for (std::size_t c = i; c < i + 4; ++c)
		{
			const int apart = std::abs(int(picture.rgba[c]) - int(baseline.rgba[c]));
			most = std::max(most, apart);
			sum += apart;
		}
		large += most > kLargeDifference;
	}
	const double pixels = static_cast<double>(picture.rgba.size() / 4);
	const double mean = sum / (4.0 * pixels);
	if (static_cast<double>(large) > kMaxLarge * pixels || mean > kMaxMean)
		return differs() << large << " pixels by more than " << kLargeDifference << ", mean " << mean;
	return testing::AssertionSuccess();
}

} // namespace vp::render::test
