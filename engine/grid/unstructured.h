#pragma once

#include "base/huge_vector.h"
#include "grid/cell_list.h"
#include "grid/grid.h"
#include "grid/points.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace vp::grid
{

// Two cells that meet without sharing the points of a face, such as at a 2:1 interface. A link works in both
// directions.
struct FaceLink
{
	std::size_t cell_a; // index into the CellList
	int face_a;
	std::size_t cell_b;
	int face_b;
};

/// Cells of any shape, in one of two states.
///
/// *Listed*: the arrays as they came. Nothing is copied or built. The id of a cell is its place in the list, the id of
/// a point its place among the points. The list may contain cells that are not three-dimensional; their ids are not
/// cells here. Every cell can be read, but no cell knows its neighbors. Code that needs neighbors or records needs the
/// other state.
///
/// *Linked*: the result of build(). Faces are matched, and cells and points are renumbered along a Morton curve, so
/// that neighbors in space are close in memory. sourceCell() and sourcePoint() return the numbers of the source.
//
// A linked cell is one record, so a traversal finds everything about it in one or two cache lines. The record begins
// with the ids of its points: 4 ids if all cells are tetrahedra, else 8. In a cell with fewer than 8 points the last id
// is kShapeMark + shape. The first id of a polyhedron is its number in the face lists. The GPU reads the same ids.
// Behind them are 4 or 6 numbers that say what is across each face: a cell, kNoCell, or kMaxBlockIds + a place in a
// list of several cells. Those of polyhedra are stored elsewhere.
class UnstructuredGrid
{
public:
	static constexpr std::uint32_t kShapeMark = 0xFFFFFFF0u;

	// Face slots (4 a cell where all are tetrahedra, else 6, and one per face of a polyhedron) are numbered in 32 bits.
	static constexpr std::size_t kMaxFaceSlots = 0xFFFFFFFFu;

	UnstructuredGrid() = default;

	/// Returns a listed grid, which shares the arrays. The preconditions are those of build(). Throws std::length_error
	/// if there are too many cells or points, as build() does. Makes one pass over the types.
	static UnstructuredGrid listed(Points points, CellList cells);
	/// The same for cells that are read in runs (cell_runs.h): all of them count, and are three-dimensional. Looks at
	/// none.
	static UnstructuredGrid listedInRuns(Points points, CellList cells);
	/// Returns the list of a listed grid, null if the grid is linked.
	const CellList* list() const { return list_.get(); }
	/// Returns true if neighbors are known, that is, if the grid is linked.
	bool hasNeighbors() const { return !list_; }

	// Preconditions (the reader checks them): ids within the points, types known, sizes right. Cells of dimension below
	// three are left out and counted. Throws std::length_error past kMaxFaceSlots or kMaxBlockIds.
	static UnstructuredGrid build(const Points& points, const CellList& cells, std::vector<FaceLink> links = {});

	/// Links some cells of a listed grid, as if there were no others. The ids of these cells' points were checked.
	/// cells: their ids, each once. sourceCell() and sourcePoint() return the numbers that the listed grid has. Throws
	/// as build() does.
	static UnstructuredGrid buildPart(const UnstructuredGrid& listed, std::span<const CellId> cells);

	std::size_t cellCount() const { return cell_count_; }
	std::size_t pointCount() const { return points_.size(); }
	// Linked grid: points from this number on belong to no cell. Listed grid: the number of all points.
	std::size_t usedPointCount() const { return used_points_; }
	std::size_t leftOut() const { return left_out_; } // cells of dimension below three
	// Counts of the file. Curved cells come as several linear ones with added points (see CellList::source_cells).
	std::size_t sourceCellCount() const { return source_cell_count_; }
	std::size_t sourcePointCount() const { return source_point_count_; }
	bool splitsCells() const { return source_cell_count_ < cell_count_; } // several cells have one sourceCell()

	Vec3 point(PointId p) const { return points_[p]; }
	CellShape shape(CellId c) const
	{
		if (list_)
			return shapeOf(list_->types[c]);
		if (width_ == 4)
			return CellShape::tetrahedron;
		const std::uint32_t last = record(c)[7];
		return last >= kShapeMark ? static_cast<CellShape>(last - kShapeMark) : CellShape::hexahedron;
	}
	CellPoints cellPoints(CellId c) const
	{
		CellPoints points;
		points.size = topology(shape(c)).points;
		if (list_)
		{
			list_->points(c, points.size, points.id.data());
			return points;
		}
		std::copy_n(record(c), points.size, points.id.begin());
		return points;
	}
	int faceCount(CellId c) const;
	void cellFaces(CellId c, CellFaces& faces) const;
	template <class Visit>
	void forEachNeighbor(CellId c, int f, Visit&& visit) const
	{
		const std::uint32_t n = across(c)[f];
		if (n < kMaxBlockIds)
			visit(n);
		else if (n != kNoCell)
			for (const CellId other : several_[n - kMaxBlockIds])
				visit(other);
	}
	// Returns the cell across a face of a table shape; kMaxBlockIds or more if there is none or there are several.
	std::uint32_t soleNeighbor(CellId c, int f) const { return record(c)[width_ + f]; }
	// Returns true if every face of a cell of any shape has another cell across.
	bool hasAllNeighbors(CellId c) const
	{
		const std::uint32_t* numbers = across(c);
		return std::find(numbers, numbers + faceCount(c), kNoCell) == numbers + faceCount(c);
	}
	// Returns true if there are links between cells that do not share the points of a face.
	bool hasLinks() const { return has_links_; }
	// Returns true if three or more cells share the points of a face. Where there are links nobody looks.
	bool hasCrowds() const { return !has_links_ && !several_.empty(); }
	std::size_t sourcePoint(PointId p) const { return list_ ? p : source_points_[p]; }
	std::size_t sourceCell(CellId c) const
	{
		if (list_)
			return list_->source_cells.empty() ? c : static_cast<std::size_t>(list_->source_cells[c]);
		return source_cells_[c];
	}

	int recordWidth() const { return width_; }
	int recordStride() const { return width_ + face_width_; }
	const HugeVector<std::uint32_t>& records() const { return records_; }
	const std::uint32_t* record(CellId c) const { return records_.data() + std::size_t(c) * recordStride(); }
	const Points& coordinates() const { return points_; }
	std::size_t geometryBytes() const;  // coordinates, records or the list, faces of polyhedra
	std::size_t adjacencyBytes() const; // neighbors and source numbers

private:
	bool isPolyhedron(CellId c) const { return shape(c) == CellShape::polyhedron; }
	// Per face of a cell of any shape.
	const std::uint32_t* across(CellId c) const
	{
		if (isPolyhedron(c))
			return polyhedron_neighbors_.data() + polyhedron_faces_[record(c)[0]];
		return record(c) + width_;
	}

	std::shared_ptr<const CellList> list_; // only for a listed grid, which has nothing else but points and counts
	std::size_t cell_count_ = 0;
	std::size_t left_out_ = 0;
	std::size_t source_cell_count_ = 0;
	std::size_t source_point_count_ = 0;
	std::size_t used_points_ = 0;
	bool has_links_ = false;
	int width_ = 8;      // ids per record
	int face_width_ = 6; // neighbor slots per cell of a table shape
	Points points_;
	HugeVector<std::uint32_t> records_;
	std::vector<std::vector<CellId>> several_;
	HugeVector<std::uint32_t> source_points_;
	HugeVector<std::uint32_t> source_cells_;
	// Polyhedra by the number in their record: their faces, the points of these, and where their neighbors start.
	std::vector<std::uint32_t> polyhedron_faces_; // polyhedra + 1 offsets into face_points_start_
	std::vector<std::uint32_t> face_points_start_;
	std::vector<PointId> face_points_;
	std::vector<std::uint32_t> polyhedron_neighbors_; // per face of a polyhedron

	friend class UnstructuredBuilder;
};

static_assert(Grid<UnstructuredGrid>);

} // namespace vp::grid
