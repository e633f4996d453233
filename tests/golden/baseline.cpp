#include "baseline.h"

#include "picture/compare.h"
#include "picture/read_png.h"
#include "write/png.h"

#include <cstdlib>
#include <string_view>

namespace vp::render::test
{

Picture partOf(const Picture& picture, const PictureBox& box)
{
	Picture part{box.x1 - box.x0, box.y1 - box.y0, {}};
	for (std::uint32_t y = box.y0; y < box.y1; ++y)
	{
		const auto row = picture.rgba.begin() + std::ptrdiff_t(4) * y * picture.width;
		part.rgba.insert(part.rgba.end(), row + std::ptrdiff_t(4) * box.x0, row + std::ptrdiff_t(4) * box.x1);
	}
	return part;
}

Picture readPng(const std::string& path)
{
	Result<Picture> read = picture::readPng(path);
	return read ? std::move(*read) : Picture{};
}

testing::AssertionResult passes(const Picture& expected, const Picture& drawn)
{
	const Result<picture::PictureDifference> difference = picture::comparePictures(expected, drawn);
	if (!difference)
		return testing::AssertionFailure() << difference.error().message;
	return testing::AssertionResult(difference->isWithin(picture::toleranceOf(8))) << difference->text();
}

testing::AssertionResult looksLike(const Picture& picture, const std::string& name,
                                   const std::optional<PictureBox>& part)
{
	const std::string path = std::string(BASELINES) + "/" + name + ".png";
	const char* update = std::getenv("VPROBE_UPDATE_GOLDEN");
	if (update && std::string_view(update) == "1")
	{
		const Status written = write::writePng(picture, path);
		return written ? testing::AssertionSuccess() : testing::AssertionFailure() << written.error().message;
	}
	const Picture baseline = readPng(path);
	const bool is_same_size = baseline.width == picture.width && baseline.height == picture.height;
	const testing::AssertionResult compared =
	    part && is_same_size ? passes(partOf(baseline, *part), partOf(picture, *part)) : passes(baseline, picture);
	if (compared)
		return compared;
	const Status kept = write::writePng(picture, name + ".png");
	return testing::AssertionFailure() << name << (kept ? ".png (kept here) differs: " : " differs: ")
	                                   << compared.message() << "; VPROBE_UPDATE_GOLDEN=1 writes the baseline";
}

} // namespace vp::render::test
