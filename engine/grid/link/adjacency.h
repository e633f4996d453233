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
// polyhedra. The members are those of UnstructuredGrid; what is across a face is written into the records.
struct FaceSlots
{
	std::span<std::uint32_t> records;
	int record_width = 8;
	int face_width = 6;
	std::size_t cells = 0;
	std::size_t points = 0;
	std::uint32_t shape_mark = 0;
	std::span<const CellId> polyhedra; // cell of each polyhedron
	std::span<const std::uint32_t> polyhedron_faces;
	std::span<const std::uint32_t> face_points_start;
	std::span<const PointId> face_points;
	std::span<std::uint32_t> polyhedron_neighbors;

	const std::uint32_t* record(std::size_t cell) const { return &records[cell * (record_width + face_width)]; }
	std::uint32_t& across(std::size_t slot) const
	{
		if (slot >= tableSlots())
			return polyhedron_neighbors[slot - tableSlots()];
		const std::size_t cell = face_width == 4 ? slot / 4 : slot / 6;
		return records[slot + (cell + 1) * record_width];
	}
	std::size_t tableSlots() const { return cells * face_width; }
	std::size_t count() const { return tableSlots() + (polyhedron_faces.empty() ? 0 : polyhedron_faces.back()); }
};

// A number across a face, kNoCell at first, names this cell too. several: what numbers from kMaxBlockIds on stand for.
void addNeighbor(std::uint32_t& across, CellId other, std::vector<std::vector<CellId>>& several);

// Writes what is across every face, and returns what the numbers from kMaxBlockIds on stand for.
//
// Two faces meet where their sets of distinct points are equal, so a collapsed quad meets a triangle. Faces of fewer
// than three distinct points meet nothing. A cell is not its own neighbor. The same result for any number of threads.
std::vector<std::vector<CellId>> matchFaces(const FaceSlots& faces);

} // namespace vp::grid
