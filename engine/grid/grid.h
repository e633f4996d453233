#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/cell_shape.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace vp::grid
{

// The contract between a grid and all code that walks it. A cell has any number of faces. A face has any number of
// points and any number of neighbors: none on the boundary of the domain, several at a 2:1 interface or a non-manifold
// face. Grids are concrete types behind this concept. std::visit chooses one for each cut, never for each cell.

// The points of a cell of a table shape, in VTK's order. Points may repeat (collapsed cells).
struct CellPoints
{
	std::array<PointId, kMaxShapePoints> id;
	int size = 0;

	const PointId* begin() const { return id.data(); }
	const PointId* end() const { return id.data() + size; }
};

// All faces of a cell as lists of point ids. Use one object for many cells, to save allocations.
struct CellFaces
{
	std::vector<PointId> points;       // points of all faces, one face after the other
	std::vector<std::uint32_t> starts; // faces + 1 offsets into `points`

	int size() const { return starts.empty() ? 0 : static_cast<int>(starts.size()) - 1; }
	std::span<const PointId> operator[](int f) const { return {points.data() + starts[f], starts[f + 1] - starts[f]}; }
	void clear()
	{
		points.clear();
		starts.assign(1, 0);
	}
	void add(std::span<const PointId> face)
	{
		points.insert(points.end(), face.begin(), face.end());
		starts.push_back(static_cast<std::uint32_t>(points.size()));
	}
};

template <class G>
concept Grid = requires(const G& g, CellId c, PointId p, int f, CellFaces& faces, void (*visit)(CellId))
{
	{
		g.cellCount()
		} -> std::convertible_to<std::size_t>;
	{
		g.pointCount()
		} -> std::convertible_to<std::size_t>;
	{
		g.point(p)
		} -> std::same_as<Vec3>;
	{
		g.shape(c)
		} -> std::same_as<CellShape>;
	{
		g.cellPoints(c)
		} -> std::same_as<CellPoints>; // table shapes only
	{
		g.faceCount(c)
		} -> std::same_as<int>;
	g.cellFaces(c, faces);          // any shape; clears `faces` first
	g.forEachNeighbor(c, f, visit); // every cell across face f
	{
		g.sourcePoint(p)
		} -> std::convertible_to<std::size_t>; // index into point fields
	{
		g.sourceCell(c)
		} -> std::convertible_to<std::size_t>; // index into cell fields
};

// Writes the faces of a table shape as point ids: the common part of cellFaces() of all grids.
void shapeFaces(CellShape shape, const CellPoints& points, CellFaces& faces);

// Returns the mean of the points of a cell of any shape. A point of a polyhedron counts once for each of its faces.
template <Grid G>
Vec3 cellCenter(const G& grid, CellId cell)
{
	Vec3 sum(0.0);
	if (grid.shape(cell) != CellShape::polyhedron)
	{
		const CellPoints points = grid.cellPoints(cell);
		for (const PointId p : points)
			sum += grid.point(p);
		return sum / static_cast<double>(points.size);
	}
	CellFaces faces;
	grid.cellFaces(cell, faces);
	for (const PointId p : faces.points)
		sum += grid.point(p);
	return sum / static_cast<double>(faces.points.size());
}

} // namespace vp::grid
