#pragma once

#include <vprobe/result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vprobe
{

/// How far a picture is from an expected one, in the worst of its tiles (docs/CI.md, "How pictures are compared").
struct ImageDifference
{
	double similarity = 1.0; // how alike the structure is: 1 for equal pictures
	double mean = 0.0;       // the largest mean difference of a channel in levels of 255, with its sign
	std::string text{};      // both with their places: "similarity 0.9312 at 640,120, mean -4.1 of blue at 632,112"
};

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
	/// Compares the picture with an expected one of the same size, in a PNG file of 8 bits a channel.
	Result<ImageDifference> differenceFrom(const std::string& expected_file) const;
	/// Writes a PNG that shows where the picture differs from an expected one, eightfold, over that one in pale gray.
	Status saveDifferenceFrom(const std::string& expected_file, const std::string& file) const;
};

} // namespace vprobe
