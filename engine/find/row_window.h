#pragma once

#include "find/row_nibbles.h"
#include "grid/structured.h"
#include "seed/sheet_window.h"
#include "surface/plane.h"
#include "surface/point_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace vp::find
{

// Which cut cells of a row count, where the sheet has no window: all.
struct WholeSheet
{
	static constexpr bool kLimits = false;

	const std::uint8_t* leftOut(std::uint32_t, std::uint32_t, std::uint32_t) { return nullptr; }
};

// The same for a window: those whose section reaches into it. Boxes in float decide about most, the others are asked
// one by one. For one thread.
template <class Number>
class RowWindow
{
public:
	static constexpr bool kLimits = true;

	// bounds: of the grid's points.
	RowWindow(const grid::CurvilinearGrid& grid, const surface::Plane& plane, const seed::SheetWindow& window,
	          const Box& bounds)
	    : grid_(grid), plane_(plane), window_(window),
	      xyz_(grid.coordinates().numbers<Number>()), heights_{surface::PointHeights(window.axis(0), window.origin(),
	                                                                                 bounds),
	                                                           surface::PointHeights(window.axis(1), window.origin(),
	                                                                                 bounds)},
	      codes_(grid.points()[0] + 8)
	{
		for (int axis = 0; axis < 2; ++axis)
		{
			// The limits are rounded to float too.
			const double doubt =
			    heights_[axis].doubt() + 0x1p-23 * (std::abs(window.lo()[axis]) + std::abs(window.hi()[axis]));
			far_.push_back(limitAt(window.lo()[axis] - doubt));
			near_.push_back(limitAt(window.lo()[axis] + doubt));
			near_.push_back(limitAt(window.hi()[axis] - doubt));
			far_.push_back(limitAt(window.hi()[axis] + doubt));
		}
	}

	// Tells, at each of the cut cells [begin, end) of the row of cells at `row`, as in Span, whether it is left out.
	const std::uint8_t* leftOut(std::uint32_t row, std::uint32_t begin, std::uint32_t end)
	{
		const PointId row_start = row * grid_.points()[0];
		for (std::uint32_t quad = begin / 4; quad <= end / 4; ++quad)
			takeCodes(quad, row_start);
		const std::uint32_t k = row / grid_.points()[1];
		const std::uint32_t j = row - k * grid_.points()[1];
		for (std::uint32_t i = begin; i < end; ++i)
		{
			const std::uint8_t code = codes_[i] & codes_[i + 1];
			codes_[i] = code & kBeyond || (!(code & kWithin) && !meets(grid_.cell(i, j, k)));
		}
		return codes_.data();
	}

private:
	// Per column of four points: bit s: they lie beyond side s of the window, all four; bit 4: all lie within.
	static constexpr std::uint8_t kBeyond = 15;
	static constexpr std::uint8_t kWithin = 1 << 4;

	static FourFloats limitAt(double value)
	{
		constexpr double kFarthest = 1e38; // windows may be wider than floats reach
		return FourFloats(static_cast<float>(std::clamp(value, -kFarthest, kFarthest)));
	}

	void takeCodes(std::uint32_t quad, PointId row_start)
	{
		const auto& points = grid_.points();
		const PointId p = row_start + 4 * quad;
		const PointId layer = points[0] * points[1];
		const unsigned count = std::min(4u, points[0] - 4 * quad);
		const surface::FourPoints four = load(p, count);
		std::array<FourFloats, 2> least{heights_[0].at(four), heights_[1].at(four)};
		std::array<FourFloats, 2> most = least;
		for (const PointId first : {p + points[0], p + layer, p + layer + points[0]})
		{
			const surface::FourPoints more = load(first, count);
			for (int axis = 0; axis < 2; ++axis)
			{
				const FourFloats along = heights_[axis].at(more);
				least[axis] = lesser(least[axis], along);
				most[axis] = greater(most[axis], along);
			}
		}
		unsigned within = 15;
		std::uint32_t codes = 0;
		for (int axis = 0; axis < 2; ++axis)
		{
			const int side = 2 * axis;
			within &= bitsAtLeast(least[axis], near_[side]) & bitsAtLeast(near_[side + 1], most[axis]);
			codes |= kNibbleBytes[bitsAtLeast(far_[side], most[axis])] << side;
			codes |= kNibbleBytes[bitsAtLeast(least[axis], far_[side + 1])] << (side + 1);
		}
		codes |= kNibbleBytes[within] << 4;
		std::memcpy(&codes_[4 * quad], &codes, 4);
	}
	// If there are fewer than four points, the last entries mean nothing.
	surface::FourPoints load(PointId first, unsigned count) const
	{
		const Number* from = xyz_ + 3 * std::size_t(first);
		if (count == 4)
			return surface::loadFour(from);
		std::array<Number, 12> some{};
		std::copy_n(from, 3 * count, some.begin());
		return surface::loadFour(some.data());
	}

	bool meets(CellId cell)
	{
		grid_.cellFaces(cell, faces_);
		return window_.meetsCell(grid_, plane_, faces_);
	}

	const grid::CurvilinearGrid& grid_;
	const surface::Plane& plane_;
	const seed::SheetWindow& window_;
	const Number* xyz_;
	std::array<surface::PointHeights, 2> heights_;
	std::vector<FourFloats> far_;  // per side: further out nothing is within
	std::vector<FourFloats> near_; // per side: further in everything is
	std::vector<std::uint8_t> codes_;
	grid::CellFaces faces_;
};

} // namespace vp::find
