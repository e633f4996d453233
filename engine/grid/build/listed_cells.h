#pragma once

#include "grid/unstructured.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::grid
{

// VTK's cell type numbers.
inline constexpr std::uint8_t kTetra = 10;
constexpr std::uint8_t kVoxel = 11;
constexpr std::uint8_t kHexahedron = 12;
constexpr std::uint8_t kWedge = 13;
constexpr std::uint8_t kPyramid = 14;
constexpr std::uint8_t kPolyhedron = 42;

inline CellShape shapeOf(std::uint8_t vtk_type)
{
	switch (vtk_type)
	{
	case kTetra:
		return CellShape::tetrahedron;
	case kPyramid:
		return CellShape::pyramid;
	case kWedge:
		return CellShape::wedge;
	case kPolyhedron:
		return CellShape::polyhedron;
	case kVoxel:
	case kHexahedron:
		break;
	}
	return CellShape::hexahedron;
}

// A voxel's points lie in lattice order.
constexpr std::array<std::uint8_t, 8> kVoxelOrder{0, 1, 3, 2, 4, 5, 7, 6};

// The points and faces of the cells of a list, by their place in it.
class ListedCells
{
public:
	explicit ListedCells(const CellList& cells) : cells_(cells) {}

	const CellList& list() const { return cells_; }
	std::uint8_t type(std::size_t cell) const { return cells_.types[cell]; }
	bool isPolyhedron(std::size_t cell) const { return cells_.types[cell] == kPolyhedron; }

	// Calls visit(point id) for the points of a cell, of a polyhedron once per face.
	template <class Visit>
	void forEachPoint(std::size_t cell, Visit&& visit) const
	{
		if (isPolyhedron(cell))
			return forEachFace(cell,
			                   [&](std::span<const std::int64_t> face)
			                   {
				                   for (const std::int64_t p : face)
					                   visit(p);
			                   });
		const std::int64_t* ids = cells_.connectivity.data() + cells_.offsets[cell];
		const int count = topology(shapeOf(cells_.types[cell])).points;
		for (int i = 0; i < count; ++i)
			visit(ids[i]);
	}

	template <class Visit>
	void forEachFace(std::size_t cell, Visit&& visit) const
	{
		const std::int64_t* stream = cells_.face_stream.data() + cells_.face_offsets[cell];
		std::int64_t faces = *stream++;
		for (; faces > 0; --faces)
		{
			visit(std::span(stream + 1, static_cast<std::size_t>(*stream)));
			stream += 1 + *stream;
		}
	}
	const std::int64_t* points(std::size_t cell) const { return cells_.connectivity.data() + cells_.offsets[cell]; }
	std::size_t faceCount(std::size_t cell) const { return cells_.face_stream[cells_.face_offsets[cell]]; }

	// Asks for where a cell's points are listed, and some time later for them.
	void prefetchOffset(std::size_t cell) const { __builtin_prefetch(&cells_.offsets[cell]); }
	void prefetchPoints(std::size_t cell) const { __builtin_prefetch(points(cell)); }

private:
	const CellList& cells_;
};

} // namespace vp::grid
