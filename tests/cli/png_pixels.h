#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cli
{

struct Pixels
{
	unsigned width = 0;
	unsigned height = 0;
	std::vector<unsigned char> rgba; // empty where the file cannot be read
};

Pixels readPixels(const std::string& path);
void writePixels(const Pixels& pixels, const std::string& path);

/// The pixels in which two pictures of one size differ, as regions that touch at sides or corners.
std::vector<std::vector<std::size_t>> regionsApart(const Pixels& a, const Pixels& b);

} // namespace cli
