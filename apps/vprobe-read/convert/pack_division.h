#pragma once

#include "pack_faces.h"
#include "read/cell_types.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vp::reader::convert
{

// The ends of a box. Points without a place count nowhere, and without a point `lo` is beyond `hi`.
struct PackBox
{
	std::array<double, 3> lo{INFINITY, INFINITY, INFINITY};
	std::array<double, 3> hi{-INFINITY, -INFINITY, -INFINITY};

	void include(const std::array<double, 3>& at);
};

// Cells that follow each other in a part.
struct PackRun
{
	PackBox box;
	std::uint32_t ids = 0;             // that the cells list
	std::uint32_t faces = 0;           // that polyhedra have
	std::uint32_t face_ids = 0;        // that these faces list
	std::vector<std::uint32_t> points; // that they have, each once
};

// Divides the cells of a grid into parts that lie together in space. Cells that nobody sees come last, in parts of
// their own, and have no boxes: so no cut reads them, and the boxes together are the bounds of the grid.
class PackDivision
{
public:
	// Throws a Refusal for cells that a pack has no place for, and for ids that are no points.
	PackDivision(vtkUnstructuredGrid* grid, std::size_t most_cells, int threads);

	std::size_t parts() const { return cell_ends_.size(); }
	// Return what a part has, as the grid numbers it: cells in their order there, points ascending.
	std::span<const std::uint32_t> cells(std::size_t part) const;
	std::span<const std::uint32_t> points(std::size_t part) const { return points_[part]; }
	const std::vector<PackRun>& runs(std::size_t part) const { return runs_[part]; }
	std::size_t cellsOfRun() const { return cells_of_run_; } // the last run of a part may have fewer
	// Return sums over the runs of a part: how many ids its cells list, faces its polyhedra have, and ids these list.
	std::size_t ids(std::size_t part) const { return sumOf(part, &PackRun::ids); }
	std::size_t faces(std::size_t part) const { return sumOf(part, &PackRun::faces); }
	std::size_t faceIds(std::size_t part) const { return sumOf(part, &PackRun::face_ids); }
	// Return sums over all parts.
	std::size_t allPoints() const;
	std::size_t allIds() const { return sumOf(&PackRun::ids); }
	std::size_t allFaces() const { return sumOf(&PackRun::faces); }
	std::size_t allFaceIds() const { return sumOf(&PackRun::face_ids); }
	std::size_t allRuns() const;

	// Counts the cells that nobody sees.
	struct LeftOut
	{
		vtkIdType flat = 0;     // fewer than three dimensions
		vtkIdType hidden = 0;   // ghosts, refined and blanked ones, where they are not flat
		vtkIdType unplaced = 0; // with a point without a place (read::isPlace), where they are neither
	};
	const LeftOut& leftOut() const { return left_out_; }

	std::span<const std::uint8_t> types() const { return types_; } // as the grid numbers its cells, without prisms
	bool areAlike() const;                                         // whether all have one type, and are no polyhedra
	const PackFaces& polyhedra() const { return polyhedra_; }
	std::array<double, 3> place(std::size_t point) const
	{
		std::array<double, 3> at;
		if (singles_)
			std::copy_n(singles_ + 3 * point, 3, at.begin());
		else if (doubles_)
			std::copy_n(doubles_ + 3 * point, 3, at.begin());
		else
			places_->GetTuple(static_cast<vtkIdType>(point), at.data());
		return at;
	}

	// Calls use(OFFSETS, IDS) with the lists of the grid as they are kept.
	template <class Use>
	void withLists(Use&& use) const
	{
		vtkCellArray* cells = grid_->GetCells();
		if (cells->IsStorage64Bit())
			use(cells->GetOffsetsArray64()->GetPointer(0), cells->GetConnectivityArray64()->GetPointer(0));
		else
			use(cells->GetOffsetsArray32()->GetPointer(0), cells->GetConnectivityArray32()->GetPointer(0));
	}
	// Returns where the ids of a cell end. Some files list more points than its type has: the first ones are used.
	template <class Id>
	Id endOf(std::size_t cell, const Id* offsets) const
	{
		const auto size = static_cast<Id>(read::slicedCellSize(types_[cell]));
		return size > 0 ? std::min(offsets[cell + 1], static_cast<Id>(offsets[cell] + size)) : offsets[cell + 1];
	}
	// Calls work(NUMBER) for each of so many, on all threads. Each thread's numbers ascend.
	void forEach(std::size_t count, const std::function<void(std::size_t)>& work) const;

private:
	std::size_t sumOf(std::size_t part, std::uint32_t PackRun::*count) const;
	std::size_t sumOf(std::uint32_t PackRun::*count) const;
	void refuseUnpackable() const;
	void refuseBadFaces() const;
	void divideCells(std::size_t most_cells);
	void countLeftOut(std::span<const std::uint32_t> cells, std::span<const std::uint8_t> marks);
	void choosePoints();
	template <class Id>
	void choosePointsOf(std::size_t part, std::size_t first_run, const Id* offsets, const Id* ids);
	template <class Id>
	bool isSeen(std::size_t cell, const Id* begin, const Id* end, std::span<const std::uint8_t> marks) const;
	template <class Id>
	std::uint64_t placeOnCurve(const Id* begin, const Id* end, const PackBox& bounds) const;

	vtkUnstructuredGrid* grid_;
	PackFaces polyhedra_;
	std::span<const std::uint8_t> types_;
	vtkDataArray* places_;
	const float* singles_ = nullptr; // the places, if they are of this type
	const double* doubles_ = nullptr;
	int threads_;
	std::size_t cells_of_run_ = 512;
	LeftOut left_out_;
	std::size_t seen_parts_ = 0;       // come first
	std::vector<std::uint32_t> order_; // the cells, part by part
	std::vector<std::size_t> cell_ends_;
	std::vector<std::vector<std::uint32_t>> points_;
	std::vector<std::vector<PackRun>> runs_;
};

} // namespace vp::reader::convert
