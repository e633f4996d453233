#pragma once

#include "base/ids.h"
#include "grid/grid.h"
#include "grid/structured.h"
#include "seed/sheet_window.h"
#include "surface/plane.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace vp::find
{

// Cells begin to end - 1 along an axis.
struct CellRange
{
	std::uint32_t begin = 0;
	std::uint32_t end = 0;
};

// Which cells of a grid with straight axes a window holds a part of. Boxes decide about most, the others are asked one
// by one.
template <class G>
class StraightWindow
{
public:
	StraightWindow(const G& grid, const surface::Plane& plane, const seed::SheetWindow& window)
	    : grid_(grid), plane_(plane), window_(window)
	{
		for (int side = 0; side < 2; ++side)
			for (int axis = 0; axis < 3; ++axis)
				for (std::uint32_t i = 0; i < grid.points()[axis]; ++i)
					terms_[side][axis].push_back(window.axis(side)[axis] *
					                             (grid.coordinate(axis, i) - window.origin()[axis]));
	}

	// Along an axis, cells outside the range lie outside the box about the window.
	CellRange cellsAlong(int axis) const
	{
		double least = window_.origin()[axis];
		double most = least;
		for (int side = 0; side < 2; ++side)
		{
			const double a = window_.lo()[side] * window_.axis(side)[axis];
			const double b = window_.hi()[side] * window_.axis(side)[axis];
			least += std::min(a, b);
			most += std::max(a, b);
		}
		// The error that rounding may add, also far from the origin.
		const double slack = 1e-12 * (std::abs(least) + std::abs(most) + std::abs(window_.origin()[axis]));
		CellRange range{grid_.cells()[axis], 0};
		for (std::uint32_t i = 0; i < grid_.cells()[axis]; ++i)
		{
			const auto [low, high] = std::minmax({grid_.coordinate(axis, i), grid_.coordinate(axis, i + 1)});
			if (high < least - slack || low > most + slack)
				continue;
			range.begin = std::min(range.begin, i);
			range.end = i + 1;
		}
		return range;
	}

	// Returns true if a cut cell meets the window. The cell is given by its i and its row as in Span.
	bool meets(std::uint32_t i, std::uint32_t row) const
	{
		const std::uint32_t k = row / grid_.points()[1];
		const std::array<std::uint32_t, 3> at = {i, row - k * grid_.points()[1], k};
		bool within = true;
		for (int side = 0; side < 2; ++side)
		{
			double low = 0.0;
			double high = 0.0;
			double magnitude = 0.0;
			for (int axis = 0; axis < 3; ++axis)
			{
				const double a = terms_[side][axis][at[axis]];
				const double b = terms_[side][axis][at[axis] + 1];
				low += std::min(a, b);
				high += std::max(a, b);
				magnitude += std::abs(a) + std::abs(b);
			}
			const double slack = 1e-15 * magnitude;
			if (high + slack < window_.lo()[side] || low - slack > window_.hi()[side])
				return false;
			within = within && low - slack > window_.lo()[side] && high + slack < window_.hi()[side];
		}
		if (within)
			return true;
		grid::CellFaces faces;
		grid_.cellFaces(grid_.cell(at[0], at[1], at[2]), faces);
		return window_.meetsCell(grid_, plane_, faces);
	}

private:
	const G& grid_;
	const surface::Plane& plane_;
	const seed::SheetWindow& window_;
	std::array<std::array<std::vector<double>, 3>, 2> terms_; // terms of a point's place in the window, per axis
};

} // namespace vp::find
