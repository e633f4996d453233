#include "pixels.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

namespace view
{

namespace
{

using vp::render::Picture;

std::uint32_t bigEndian(const std::string& bytes, std::size_t word)
{
	std::uint32_t value = 0;
	for (std::size_t i = 4 * word; i < 4 * word + 4; ++i)
		value = value << 8 | static_cast<unsigned char>(bytes[i]);
	return value;
}

bool isNear(const vp::render::Color& color, const std::uint8_t* pixel)
{
	constexpr int kNear = 6;
	return std::abs(color.r - pixel[0]) <= kNear && std::abs(color.g - pixel[1]) <= kNear &&
	       std::abs(color.b - pixel[2]) <= kNear;
}

} // namespace

Picture readScreen(const std::string& file)
{
	std::ifstream stream(file, std::ios::binary);
	const std::string bytes(std::istreambuf_iterator<char>(stream), {});
	constexpr std::size_t kHeaderWords = 25;
	constexpr std::size_t kColorBytes = 12;
	if (bytes.size() < 4 * kHeaderWords || bigEndian(bytes, 11) != 32)
		return {};
	Picture picture{bigEndian(bytes, 4), bigEndian(bytes, 5), {}};
	const std::size_t line = bigEndian(bytes, 12);
	const std::size_t start = bigEndian(bytes, 0) + kColorBytes * bigEndian(bytes, 19);
	if (bytes.size() < start + line * picture.height || line < std::size_t(4) * picture.width)
		return {};
	picture.rgba.resize(std::size_t(4) * picture.width * picture.height);
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
		{
			const auto* from = reinterpret_cast<const std::uint8_t*>(&bytes[start + y * line + 4 * x]);
			std::uint8_t* to = &picture.rgba[4 * (std::size_t(y) * picture.width + x)];
			to[0] = from[2];
			to[1] = from[1];
			to[2] = from[0];
			to[3] = 255;
		}
	return picture;
}

Picture part(const Picture& picture, const Area& area)
{
	const std::uint32_t x = std::min(area.x, picture.width);
	const std::uint32_t y = std::min(area.y, picture.height);
	Picture cut{std::min(area.width, picture.width - x), std::min(area.height, picture.height - y), {}};
	for (std::uint32_t row = y; row < y + cut.height; ++row)
	{
		const auto* from = picture.rgba.data() + 4 * (std::size_t(row) * picture.width + x);
		cut.rgba.insert(cut.rgba.end(), from, from + std::size_t(4) * cut.width);
	}
	return cut;
}

double difference(const Picture& a, const Picture& b)
{
	if (a.width != b.width || a.height != b.height || a.rgba.empty())
		return 1.0;
	std::size_t others = 0;
	for (std::size_t i = 0; i < a.rgba.size(); i += 4)
		others += std::memcmp(&a.rgba[i], &b.rgba[i], 3) != 0;
	return static_cast<double>(others) / (static_cast<double>(a.rgba.size()) / 4.0);
}

double shareOf(const vp::render::ColorMap& map, const Picture& picture)
{
	std::size_t count = 0;
	for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
		count += std::ranges::any_of(map.colors, [&](const auto& color) { return isNear(color, &picture.rgba[i]); });
	return picture.rgba.empty() ? 0.0 : static_cast<double>(count) / (static_cast<double>(picture.rgba.size()) / 4.0);
}

} // namespace view
