#include "sweep/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace vp::app
{

namespace
{

// These functions convert sRGB (IEC 61966-2-1) to linear light and back.
float lightOf(std::uint8_t code)
{
	static const std::array<float, 256> table = []
	{
		std::array<float, 256> made;
		for (int i = 0; i < 256; ++i)
		{
			const float c = static_cast<float>(i) / 255.0f;
			made[static_cast<std::size_t>(i)] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
		}
		return made;
	}();
	return table[code];
}

std::uint8_t codeOf(float light)
{
	const float l = std::clamp(light, 0.0f, 1.0f);
	const float c = l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f;
	return static_cast<std::uint8_t>(std::lround(255.0f * c));
}

// Alpha adds up like light, but needs no conversion.
float channelOf(const render::Picture& picture, std::size_t i)
{
	return i % 4 == 3 ? static_cast<float>(picture.rgba[i]) / 255.0f : lightOf(picture.rgba[i]);
}

} // namespace

Exposure::Exposure(render::Picture empty)
    : empty_(std::move(empty)), light_(empty_.rgba.size(), 0.0f), touched_(empty_.rgba.size() / 4, 0)
{
}

void Exposure::add(const render::Picture& frame)
{
	for (std::size_t pixel = 0; pixel < touched_.size(); ++pixel)
	{
		const std::size_t at = 4 * pixel;
		if (std::equal(&frame.rgba[at], &frame.rgba[at] + 4, &empty_.rgba[at]))
			continue;
		++touched_[pixel];
		for (std::size_t i = at; i < at + 4; ++i)
			light_[i] += channelOf(frame, i) - channelOf(empty_, i);
	}
}

render::Picture Exposure::picture() const
{
	std::vector<std::uint32_t> counts;
	std::ranges::copy_if(touched_, std::back_inserter(counts), [](std::uint32_t n) { return n > 0; });
	render::Picture picture = empty_;
	if (counts.empty())
		return picture;
	std::ranges::nth_element(counts, counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2));
	const auto typical = static_cast<float>(counts[counts.size() / 2]);
	for (std::size_t i = 0; i < picture.rgba.size(); ++i)
	{
		if (touched_[i / 4] == 0)
			continue;
		const float sum = channelOf(empty_, i) + light_[i] / std::max(static_cast<float>(touched_[i / 4]), typical);
		picture.rgba[i] =
		    i % 4 == 3 ? static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(sum, 0.0f, 1.0f))) : codeOf(sum);
	}
	return picture;
}

} // namespace vp::app
