#pragma once

#include "base/array.h"
#include "base/prefetch.h"
#include "grid/cell_shape.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vp::grid
{

/// Ids of 32 or 64 bits, stored as they came from the file. A copy shares the memory.
class IdArray
{
public:
	IdArray() = default;
	IdArray(Array<std::int32_t> ids) : narrow_(std::move(ids)) {}
	IdArray(Array<std::int64_t> ids) : wide_(std::move(ids)), is_wide_(true) {}
	IdArray(std::vector<std::int32_t> ids) : IdArray(Array<std::int32_t>(std::move(ids))) {}
	IdArray(std::vector<std::int64_t> ids) : IdArray(Array<std::int64_t>(std::move(ids))) {}

	std::size_t size() const { return is_wide_ ? wide_.size() : narrow_.size(); }
	const std::shared_ptr<const void>& owner() const { return is_wide_ ? wide_.owner() : narrow_.owner(); }
	std::size_t bytes() const { return is_wide_ ? 8 * wide_.size() : 4 * narrow_.size(); }
	std::int64_t operator[](std::size_t i) const { return is_wide_ ? wide_[i] : narrow_[i]; }

	/// Calls use(std::span<const Id>) with the ids as they are kept: 32 or 64 bits wide.
	template <class Use>
	decltype(auto) as(Use&& use) const
	{
		return is_wide_ ? use(wide_.span()) : use(narrow_.span());
	}
	void prefetch(std::size_t i) const
	{
		if (is_wide_)
			vp::prefetch(wide_.data() + i);
		else
			vp::prefetch(narrow_.data() + i);
	}

private:
	Array<std::int32_t> narrow_;
	Array<std::int64_t> wide_;
	bool is_wide_ = false;
};

/// VTK's cell type numbers.
inline constexpr std::uint8_t kTetra = 10;
inline constexpr std::uint8_t kVoxel = 11;
inline constexpr std::uint8_t kHexahedron = 12;
inline constexpr std::uint8_t kWedge = 13;
inline constexpr std::uint8_t kPyramid = 14;
inline constexpr std::uint8_t kPolyhedron = 42;

/// Returns the dimension of a cell type: 0 to 3, or -1 for a type that VTK does not know.
int vtkDimension(std::uint8_t vtk_type);

/// Returns true for the types that UnstructuredGrid::build() takes: tetrahedron, voxel, hexahedron, wedge, pyramid,
/// polyhedron. It skips other three-dimensional types (quadratic and higher cells, prisms over pentagons and hexagons)
/// and does not count them as left out. The reader rewrites those to the types above, refuses them or warns.
bool isSliceable(std::uint8_t vtk_type);

/// Returns the shape of a type for which isSliceable() is true.
constexpr CellShape shapeOf(std::uint8_t vtk_type)
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
	default:
		return CellShape::hexahedron; // voxels too
	}
}

/// Places of a hexahedron's points in the list of a voxel, whose points are in lattice order.
inline constexpr std::array<std::uint8_t, 8> kVoxelOrder{0, 1, 3, 2, 4, 5, 7, 6};

/// A cell names a point that there is not.
class WrongPoint : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

/// Throws WrongPoint if an id is not below the number of points.
void checkIds(const IdArray& ids, std::size_t points);

/// Cells as a file lists them: VTK cell types and point ids, in VTK's point order. A copy shares the arrays.
struct CellList
{
	Array<std::uint8_t> types; // VTK cell type numbers
	// cells + 1 offsets into connectivity. Empty if all cells have one type, which is not polyhedron, and their points
	// follow each other cell by cell.
	Array<std::int64_t> offsets;
	IdArray connectivity;             // point ids
	Array<std::int64_t> face_offsets; // polyhedra: cells + 1 offsets into face_stream, or empty
	Array<std::int64_t> face_stream;  // per polyhedron: faces, then per face its size and point ids
	// Per cell: the cell of the file that it is part of, for fields and ids. Empty: the cells are those of the file.
	Array<std::int64_t> source_cells;
	std::size_t source_points =
	    0; // number of points in the file, if the reader added more behind them; 0: it added none
	// False: the ids may name points that there are not. The first pass over all cells checks them, since a pass of its
	// own takes as long as a scan. Only of cells that are alike, so without offsets.
	bool has_checked_ids = true;

	std::size_t size() const { return types.size(); }
	bool isPolyhedron(std::size_t cell) const { return types[cell] == kPolyhedron; }
	/// Returns the place in the connectivity where the points of a cell begin. isSliceable() must be true for its type.
	std::size_t start(std::size_t cell) const
	{
		return offsets.empty() ? cell * topology(shapeOf(types[cell])).points : static_cast<std::size_t>(offsets[cell]);
	}
	/// Writes the ids of the points of a cell of a table shape, in the order of its shape. A voxel's points are written
	/// as those of a hexahedron. Id: a type with enough bits for the ids.
	template <class Id>
	void points(std::size_t cell, int count, Id* points) const
	{
		const std::size_t first = offsets.empty() ? cell * count : static_cast<std::size_t>(offsets[cell]);
		connectivity.as(
		    [&](auto ids)
		    {
			    for (int v = 0; v < count; ++v)
				    points[v] = static_cast<Id>(ids[first + v]);
		    });
		if (types[cell] == kVoxel)
		{
			std::swap(points[2], points[3]);
			std::swap(points[6], points[7]);
		}
	}
	/// Returns the id of one of these points.
	std::int64_t point(std::size_t cell, int v) const
	{
		return connectivity[start(cell) + (types[cell] == kVoxel ? kVoxelOrder[v] : v)];
	}

	std::size_t faceCount(std::size_t polyhedron) const { return face_stream[face_offsets[polyhedron]]; }
	/// Calls visit(std::span<const std::int64_t>) with the point ids of each face of a polyhedron.
	template <class Visit>
	void forEachFace(std::size_t polyhedron, Visit&& visit) const
	{
		const std::int64_t* stream = face_stream.data() + face_offsets[polyhedron];
		std::int64_t faces = *stream++;
		for (; faces > 0; --faces)
		{
			visit(std::span(stream + 1, static_cast<std::size_t>(*stream)));
			stream += 1 + *stream;
		}
	}
	/// Calls visit(point id) for the points of a cell. A point of a polyhedron is visited once for each of its faces.
	/// isSliceable() must be true for the type of the cell.
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
		const std::size_t first = start(cell);
		const int count = topology(shapeOf(types[cell])).points;
		connectivity.as(
		    [&](auto ids)
		    {
			    for (int v = 0; v < count; ++v)
				    visit(static_cast<std::int64_t>(ids[first + v]));
		    });
	}

	std::size_t bytes() const
	{
		return types.size() + connectivity.bytes() +
		       8 * (offsets.size() + face_offsets.size() + face_stream.size() + source_cells.size());
	}
};

} // namespace vp::grid
