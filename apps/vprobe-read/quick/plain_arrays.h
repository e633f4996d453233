#pragma once

#include "grid/field.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::quick
{

// An array whose values lie in a file as they are in memory, one behind the other.
struct PlainArray
{
	bool on_points;
	std::string name;
	grid::NumberType type;
	std::uint64_t components;
	std::uint64_t offset;
};

// Returns the arrays of a .vtu file of one piece that lie there like that: appended as raw bytes, in the order of this
// machine. Returns nothing for files that the quick reader does not support.
std::optional<std::vector<PlainArray>> plainArrays(const std::string& file);

} // namespace vp::reader::quick
