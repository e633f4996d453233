#pragma once

#include "base/huge_vector.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace vp::reader::convert
{

struct CellOnCurve
{
	std::uint64_t place; // along a Morton curve, 21 bits an axis, x the lowest
	std::uint32_t cell;
};

// The place of cells that come behind all others.
constexpr std::uint64_t kBehindTheCurve = std::uint64_t(1) << 63;

// A bit of each axis in turn. Each axis is from 0 to 2^21 - 1.
std::uint64_t mortonKey(std::uint32_t x, std::uint32_t y, std::uint32_t z);

// Tells the places of the cells from `first` on, as many as there is room for. Any thread may ask, more than once.
using PlacesOnCurve = std::function<void(std::size_t first, std::span<std::uint64_t> places)>;

// Returns so many cells, at most 2^32 - 1, in the order of the curve. Cells at one place keep the order of their
// numbers.
HugeVector<CellOnCurve> alongCurve(std::size_t cells, const PlacesOnCurve& placesOf, int threads);

} // namespace vp::reader::convert
