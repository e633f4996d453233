#include "picture/read_png.h"

#include "render/scene/look.h"

#include <fmt/format.h>
#include <png.h>

#include <cstdint>
#include <filesystem>
#include <memory>

namespace vp::picture
{

namespace
{

Error notReadable(const std::string& path, const std::string& why)
{
	return {ErrorKind::input, fmt::format("{}: {}", path, why)};
}

} // namespace

Result<render::Picture> readPng(const std::string& path)
{
	std::error_code unknown;
	const std::uintmax_t file_size = std::filesystem::file_size(path, unknown);
	if (unknown)
		return notReadable(path, fmt::format("cannot be read: {}", unknown.message()));
	png_image image{};
	image.version = PNG_IMAGE_VERSION;
	if (!png_image_begin_read_from_file(&image, path.c_str()))
		return notReadable(path, fmt::format("is not a PNG that can be read: {}", image.message));
	const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&image, png_image_free);
	if (image.format & PNG_FORMAT_FLAG_LINEAR)
		return notReadable(path, "has 16 bits a channel; store it with 8, as vprobe render does");
	if (image.width > render::kMaxPictureSize || image.height > render::kMaxPictureSize)
		return notReadable(path, fmt::format("has {} x {} pixels; pictures have up to {} each way", image.width,
		                                     image.height, render::kMaxPictureSize));
	// Deflate makes data at most 1032 times smaller, and a row of one-bit pixels is what holds the most pixels.
	constexpr std::uintmax_t kMaxPixelsPerByte = 1032 * 8;
	if (std::uintmax_t(image.width) * image.height > kMaxPixelsPerByte * file_size)
		return notReadable(path, "is too short for its size in pixels; it is damaged");
	image.format = PNG_FORMAT_RGBA;
	render::Picture picture{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
	if (!png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr))
		return notReadable(path, fmt::format("is not a PNG that can be read: {}", image.message));
	return picture;
}

} // namespace vp::picture
