#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "grid/field.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace vp::read
{

// An unstructured grid in parts that lie together in space, as its reader tells of it before the parts are read.
struct PackedGrid
{
	std::size_t points = 0; // as cells, those of all parts
	std::size_t cells = 0;
	std::vector<grid::Field> fields; // the arrays that would be read, without values
	std::vector<Box> parts;          // around the points of their cells; empty boxes if no point has a place

	Box bounds() const;
};

// Returns the numbers of the parts to read, ascending, at least one; or nothing if all are needed.
using ChooseParts = std::function<std::optional<std::vector<std::uint64_t>>(const PackedGrid& grid)>;

// Reads what a child tells of a pack (protocol.h). Nothing is trusted. The message of the error is only the reason.
Result<PackedGrid> checkPackedGrid(std::string_view text, std::vector<std::array<double, 6>> boxes);

} // namespace vp::read
