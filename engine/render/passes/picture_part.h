#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>

namespace vp::render
{

// Rows of a picture that are drawn together: all of them, or as many as the device's memory holds. Pixels of a part are
// numbered from its own first row.
struct PicturePart
{
	VkExtent2D picture{};
	std::uint32_t first_row = 0;
	VkExtent2D extent{}; // size of the part, as wide as the picture

	static PicturePart whole(VkExtent2D picture) { return {picture, 0, picture}; }
	bool isWhole() const { return extent.height == picture.height; }
};

} // namespace vp::render
