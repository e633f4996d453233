#pragma once

#include "cases/case_table.h"
#include "grid/grid.h"
#include "surface/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace vp::seed
{

struct Range
{
	double lo = std::numeric_limits<double>::infinity();
	double hi = -std::numeric_limits<double>::infinity();

	double length() const { return hi - lo; }
	double middle() const { return 0.5 * (lo + hi); }
	void include(double x)
	{
		lo = std::min(lo, x);
		hi = std::max(hi, x);
	}
	Range within(const Range& other) const { return {std::max(lo, other.lo), std::min(hi, other.hi)}; }
};

// The axes of a sheet: u along axis 0 and v along axis 1, from its origin, in the grid's units.
struct SheetAxes
{
	Vec3 origin;
	Vec3 axis[2]; // unit vectors

	glm::dvec2 uvOf(const Vec3& p) const { return {glm::dot(p - origin, axis[0]), glm::dot(p - origin, axis[1])}; }
};

// The section of a cell: a polygon in the sheet's axes, and the face that each of its sides lies on. Without corners
// where the cell is not cut or has no entry in a case table.
struct Section
{
	std::array<glm::dvec2, cases::kMaxPolygon> corner;
	std::array<std::uint8_t, cases::kMaxPolygon> face_after; // face of the side from this corner to the next
	int corners = 0;

	// From where to where it reaches along an axis. It has corners.
	Range range(int axis) const
	{
		Range range{corner[0][axis], corner[0][axis]};
		for (int i = 1; i < corners; ++i)
			range.include(corner[i][axis]);
		return range;
	}
};

template <grid::Grid G>
Section sectionOf(const G& grid, const surface::Plane& plane, const SheetAxes& axes, CellId cell)
{
	Section section;
	const grid::CellShape shape = grid.shape(cell);
	if (shape == grid::CellShape::polyhedron)
		return section;
	const grid::CellPoints points = grid.cellPoints(cell);
	std::array<Vec3, grid::kMaxShapePoints> place;
	std::array<double, grid::kMaxShapePoints> distance;
	std::uint32_t mask = 0;
	for (int v = 0; v < points.size; ++v)
	{
		place[v] = grid.point(points.id[v]);
		distance[v] = plane.signedDistance(place[v]);
		mask |= static_cast<std::uint32_t>(distance[v] >= 0.0) << v;
	}
	const cases::Case& cut = cases::caseTable(shape)[mask];
	section.corners = cut.edges;
	section.face_after = cut.face_after;
	for (int i = 0; i < cut.edges; ++i)
	{
		const auto [a, b] = cut.edge[i];
		section.corner[i] = axes.uvOf(place[a] + (distance[a] / (distance[a] - distance[b])) * (place[b] - place[a]));
	}
	return section;
}

// A straight line in a sheet, along one of its axes.
struct SheetLine
{
	int axis;  // that it runs along
	double at; // on the other axis
	int sense; // direction of the walk, +1 or -1
};

// Where a line meets the sides of a section, and the faces they lie on.
struct Crossings
{
	struct Crossing
	{
		double where; // along the line, in its sense
		int face;
	};
	std::array<Crossing, cases::kMaxPolygon> at; // in the line's sense
	int count = 0;
};

inline Crossings crossingsOf(const Section& section, const SheetLine& line)
{
	const int across = 1 - line.axis;
	Crossings crossings;
	for (int i = 0; i < section.corners; ++i)
	{
		const glm::dvec2& a = section.corner[i];
		const glm::dvec2& b = section.corner[i + 1 < section.corners ? i + 1 : 0];
		if ((a[across] >= line.at) == (b[across] >= line.at))
			continue;
		const double t = (line.at - a[across]) / (b[across] - a[across]);
		const double where = line.sense * (a[line.axis] + t * (b[line.axis] - a[line.axis]));
		int place = crossings.count++;
		for (; place > 0 && crossings.at[place - 1].where > where; --place)
			crossings.at[place] = crossings.at[place - 1];
		crossings.at[place] = {where, section.face_after[i]};
	}
	return crossings;
}

// A cell that a walk passed through.
struct PassedCell
{
	CellId cell;
	double from; // the part of the line in it: from < to, whichever way it was walked
	double to;
	double breadth; // breadth of its section across the line
};

// Returns the cell into which the line goes: across the last side that it meets and that does not lead back. Returns
// kNoCell if it leaves the block.
template <grid::Grid G>
CellId nextCell(const G& grid, CellId cell, CellId before, const Crossings& crossings)
{
	const std::span met(crossings.at.data(), static_cast<std::size_t>(crossings.count));
	for (auto crossing = met.rbegin(); crossing != met.rend(); ++crossing)
	{
		CellId next = kNoCell;
		bool leads_back = false;
		grid.forEachNeighbor(cell, crossing->face,
		                     [&](CellId neighbor)
		                     {
			                     leads_back = leads_back || neighbor == before;
			                     next = neighbor;
		                     });
		if (!leads_back)
			return next;
	}
	return kNoCell;
}

// Fence hopping within a sheet: from a cell that a line crosses to the next one along it, across the side of its
// section by which the line leaves it, until the line leaves the block or has passed `end`. So every cell on the way is
// cut. Appends the cells, the first one too; those after it are hops.
template <grid::Grid G>
void walk(const G& grid, const surface::Plane& plane, const SheetAxes& axes, CellId cell, const SheetLine& line,
          double end, std::vector<PassedCell>& passed)
{
	// A line along a side, or through a corner where many cells meet, may stand still for some cells, and rounding sets
	// it back.
	constexpr int kMaxStops = 8;
	int stops = 0;
	CellId before = kNoCell;
	double reached = -std::numeric_limits<double>::infinity(); // in the line's sense
	while (cell != kNoCell)
	{
		const Section section = sectionOf(grid, plane, axes, cell);
		const Crossings crossings = crossingsOf(section, line);
		if (crossings.count == 0)
			return;
		const double enters = crossings.at[0].where;
		const double leaves = crossings.at[crossings.count - 1].where;
		stops = leaves > reached ? 0 : stops + 1;
		if (stops > kMaxStops)
			return;
		reached = leaves;
		passed.push_back({cell, line.sense > 0 ? enters : -leaves, line.sense > 0 ? leaves : -enters,
		                  section.range(1 - line.axis).length()});
		if (leaves >= line.sense * end)
			return;
		const CellId next = nextCell(grid, cell, before, crossings);
		before = cell;
		cell = next;
	}
}

} // namespace vp::seed
