#include "png_pixels.h"

#include <png.h>

#include <algorithm>
#include <utility>

namespace cli
{

Pixels readPixels(const std::string& path)
{
	png_image image{};
	image.version = PNG_IMAGE_VERSION;
	if (!png_image_begin_read_from_file(&image, path.c_str()))
		return {};
	image.format = PNG_FORMAT_RGBA;
	Pixels pixels{image.width, image.height, std::vector<unsigned char>(PNG_IMAGE_SIZE(image))};
	if (!png_image_finish_read(&image, nullptr, pixels.rgba.data(), 0, nullptr))
		return {};
	return pixels;
}

void writePixels(const Pixels& pixels, const std::string& path)
{
	png_image image{};
	image.version = PNG_IMAGE_VERSION;
	image.width = pixels.width;
	image.height = pixels.height;
	image.format = PNG_FORMAT_RGBA;
	png_image_write_to_file(&image, path.c_str(), 0, pixels.rgba.data(), 0, nullptr);
}

std::vector<std::vector<std::size_t>> regionsApart(const Pixels& a, const Pixels& b)
{
	std::vector<char> apart(a.rgba.size() / 4);
	for (std::size_t i = 0; i < apart.size(); ++i)
		apart[i] = !std::equal(&a.rgba[4 * i], &a.rgba[4 * i] + 4, &b.rgba[4 * i]);
	std::vector<std::vector<std::size_t>> regions;
	const std::size_t width = a.width;
	for (std::size_t first = 0; first < apart.size(); ++first)
	{
		if (!apart[first])
			continue;
		std::vector<std::size_t>& region = regions.emplace_back(1, first);
		apart[first] = 0;
		for (std::size_t next = 0; next < region.size(); ++next)
		{
			const std::size_t x = region[next] % width;
			const std::size_t y = region[next] / width;
			for (std::size_t j = y > 0 ? y - 1 : 0; j <= y + 1 && j < a.height; ++j)
				for (std::size_t i = x > 0 ? x - 1 : 0; i <= x + 1 && i < width; ++i)
					if (std::exchange(apart[j * width + i], 0))
						region.push_back(j * width + i);
		}
	}
	return regions;
}

} // namespace cli
