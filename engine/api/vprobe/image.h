#pragma once

#include <vprobe/result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vprobe
{

/// A picture: rows from the top, each pixel red, green, blue, alpha, 0 to 255, in sRGB.
struct VPROBE_API Image
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	std::vector<std::uint8_t> rgba{}; // 4 * width * height

	/// Writes the picture as PNG. If it fails, no file is left.
	Status save(const std::string& file) const;
	/// Returns the bytes of such a file.
	Result<std::string> png() const;
};

} // namespace vprobe
