#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace vp::parts
{

/// How the items of an array on a lattice are cut into parts. An item is the value of a point or a cell, of one number
/// or several. i runs fastest: through the array, through each part, and from part to part.
struct Layout
{
	std::array<std::uint64_t, 3> items{1, 1, 1}; // along i, j, k; at least 1
	std::array<std::uint64_t, 3> part{1, 1, 1};  // items of a part along i, j, k; at least 1
	std::size_t item_bytes = 1;
	// If true, the last part along an axis is as large as the others, and what lies beyond the array means nothing. So
	// it is with chunks of HDF5 and Zarr. Else it is cut short, which suits parts that hold whole rows.
	bool is_padded = false;

	std::uint64_t itemCount() const { return items[0] * items[1] * items[2]; }
	std::uint64_t byteCount() const { return itemCount() * item_bytes; }
	std::uint64_t partsAlong(int axis) const { return (items[axis] + part[axis] - 1) / part[axis]; }
	std::uint64_t partCount() const { return partsAlong(0) * partsAlong(1) * partsAlong(2); }

	/// Returns the place of a part among the parts along each axis.
	std::array<std::uint64_t, 3> placeOf(std::uint64_t number) const
	{
		const std::uint64_t row = number / partsAlong(0);
		return {number % partsAlong(0), row % partsAlong(1), row / partsAlong(1)};
	}
	/// Returns the first item of a part along each axis.
	std::array<std::uint64_t, 3> firstOf(std::uint64_t number) const
	{
		const auto place = placeOf(number);
		return {place[0] * part[0], place[1] * part[1], place[2] * part[2]};
	}
	/// Returns how many items of the array a part holds along each axis.
	std::array<std::uint64_t, 3> itemsOf(std::uint64_t number) const
	{
		const auto first = firstOf(number);
		return {std::min(part[0], items[0] - first[0]), std::min(part[1], items[1] - first[1]),
		        std::min(part[2], items[2] - first[2])};
	}
	/// Returns the size of a part as it is kept and stored.
	std::size_t bytesOf(std::uint64_t number) const
	{
		const auto held = is_padded ? part : itemsOf(number);
		return static_cast<std::size_t>(held[0] * held[1] * held[2]) * item_bytes;
	}
};

} // namespace vp::parts
