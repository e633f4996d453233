#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/block.h"
#include "probe/sheet.h"
#include "traverse/bfs.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vp::slice
{

// Where a vertex lies: on the edge from the lower to the higher point id, at lower + t (higher - lower), 0 <= t <= 1.
// This is the vertex's identity too: a cut edge is one vertex, whatever number of cells share it. Where blocks meet, or
// points are not merged, an edge has several names, of which the vertex bears one (join_vertices.h).
struct EdgePoint
{
	std::uint32_t block;
	PointId lower;
	PointId higher;
	double t;
};

struct BlockCell
{
	std::uint32_t block;
	CellId cell;
};

// The cut of one sheet through a block set: polygons with shared vertices, in double precision. Polygons wind
// counter-clockwise seen from the side the sheet's normal points to. Polygons with fewer than three distinct vertices
// are left out.
struct SheetMesh
{
	std::vector<Vec3> positions;
	std::vector<EdgePoint> edges;              // per vertex
	std::vector<std::uint32_t> polygon_starts; // polygons + 1 offsets into polygon_vertices
	std::vector<std::uint32_t> polygon_vertices;
	std::vector<BlockCell> polygon_cells; // per polygon
	std::size_t boundary_polygons = 0;    // the last so many are boundary faces in the plane, of cells that are not cut
	// Vertices that lie on each other at a seam and yet stay two, since the arrays differ from one side to the other.
	std::vector<std::pair<std::uint32_t, std::uint32_t>> seam_pairs;
	std::size_t cells_twisted = 0; // cut cells with a face that is cut more than once, or with several polygons

	std::size_t polygons() const { return polygon_cells.size(); }
	std::span<const std::uint32_t> polygon(std::size_t i) const
	{
		return std::span(polygon_vertices).subspan(polygon_starts[i], polygon_starts[i + 1] - polygon_starts[i]);
	}
};

// One traversed block of a sheet, and its boundary faces that lie in the plane without their cell being cut.
struct BlockCut
{
	std::uint32_t block;
	const traverse::LaneCut* cut;
	std::span<const grid::BoundaryIndex::Face> faces_in_plane;
};

SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const BlockCut> cuts);

// The value of a point field at a vertex: linear along the edge, from the lower point. component may be
// grid::kMagnitude: the length of the interpolated tuple.
double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at);
double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell);

} // namespace vp::slice
