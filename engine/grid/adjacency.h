#pragma once

#include "base/ids.h"
#include "grid/cell_shape.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::grid
{

// The faces of a block's cells, each in a slot: first `face_width` slots per cell, by its number, then the faces of all
// polyhedra. The members are those of UnstructuredGrid.
struct FaceSlots
{
	std::span<const std::uint32_t> records;
	int record_width = 8;
	int face_width = 6;
	std::size_t cells = 0;
	std::size_t points = 0;
	std::uint32_t shape_mark = 0;
	std::span<const CellId> polyhedra; // cell of each polyhedron
	std::span<const std::uint32_t> polyhedron_faces;
	std::span<const std::uint32_t> face_points_start;
	std::span<const PointId> face_points;

	std::size_t tableSlots() const { return cells * face_width; }
	std::size_t count() const { return tableSlots() + (polyhedron_faces.empty() ? 0 : polyhedron_faces.back()); }
};

// What is across every face: a cell, kNoCell, or kMaxBlockIds + index into `several`.
struct Adjacency
{
	std::vector<std::uint32_t> neighbours; // one per slot
	std::vector<std::vector<CellId>> several;

	void link(std::size_t slot, CellId other);
};

// Two faces meet where their sets of distinct points are equal, so a collapsed quad meets a triangle. Faces of fewer
// than three distinct points meet nothing. A cell is not its own neighbour. The same result for any number of threads.
Adjacency matchFaces(const FaceSlots& faces);

} // namespace vp::grid
