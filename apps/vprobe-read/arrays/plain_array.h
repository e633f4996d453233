#pragma once

#include "grid/field.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vp::reader::arrays
{

// An array whose numbers lie in a file one behind the other, in one piece at each time.
struct PlainArray
{
	bool on_points;
	std::string name;
	grid::NumberType type;
	std::uint64_t components;
	std::vector<std::uint64_t> offsets; // for each time of the file, or the one of all
	bool swaps = false;                 // whether the bytes of a number are in the other order
};

} // namespace vp::reader::arrays
