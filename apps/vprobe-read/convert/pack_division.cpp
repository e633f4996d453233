#include "pack_division.h"

#include "octree_parts.h"
#include "read/check_mesh.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/cell_lists.h"
#include "vprobe-read/cells/visible_cells.h"
#include "vprobe-read/quick/tasks.h"

#include <vtkDataArray.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <utility>

namespace vp::reader::convert
{

void PackBox::include(const std::array<double, 3>& at)
{
	for (std::size_t axis = 0; axis < 3; ++axis)
		if (read::isPlace(at[axis]))
		{
			lo[axis] = std::min(lo[axis], at[axis]);
			hi[axis] = std::max(hi[axis], at[axis]);
		}
}

PackDivision::PackDivision(vtkUnstructuredGrid* grid, std::size_t most_cells, int threads)
    : grid_(grid), polyhedra_(grid), types_(polyhedra_.types()), places_(grid->GetPoints()->GetData()),
      threads_(threads)
{
	if (places_->GetDataType() == VTK_FLOAT)
		singles_ = static_cast<const float*>(places_->GetVoidPointer(0));
	else if (places_->GetDataType() == VTK_DOUBLE)
		doubles_ = static_cast<const double*>(places_->GetVoidPointer(0));
	// Whoever cuts the file gets a box for each run, and takes a million of them.
	constexpr std::size_t most_runs = 1 << 19;
	while (types_.size() / cells_of_run_ > most_runs)
		cells_of_run_ *= 2;
	refuseUnpackable();
	divideCells(most_cells);
	choosePoints();
}

std::span<const std::uint32_t> PackDivision::cells(std::size_t part) const
{
	const std::size_t begin = part == 0 ? 0 : cell_ends_[part - 1];
	return std::span(order_).subspan(begin, cell_ends_[part] - begin);
}

std::size_t PackDivision::sumOf(std::size_t part, std::uint32_t PackRun::*count) const
{
	std::size_t sum = 0;
	for (const PackRun& run : runs_[part])
		sum += run.*count;
	return sum;
}

std::size_t PackDivision::sumOf(std::uint32_t PackRun::*count) const
{
	std::size_t sum = 0;
	for (std::size_t part = 0; part < parts(); ++part)
		sum += sumOf(part, count);
	return sum;
}

std::size_t PackDivision::allPoints() const
{
	std::size_t sum = 0;
	for (const std::vector<std::uint32_t>& of_part : points_)
		sum += of_part.size();
	return sum;
}

std::size_t PackDivision::allRuns() const
{
	std::size_t sum = 0;
	for (const std::vector<PackRun>& of_part : runs_)
		sum += of_part.size();
	return sum;
}

bool PackDivision::areAlike() const
{
	return !polyhedra_.hasPolyhedra() &&
	       std::ranges::all_of(types_, [this](std::uint8_t type) { return type == types_[0]; });
}

void PackDivision::forEach(std::size_t count, const std::function<void(std::size_t)>& work) const
{
	quick::Tasks tasks(threads_);
	tasks.add(count, [&](std::size_t number, arrays::Scratch&) { work(number); });
	tasks.run();
}

void PackDivision::refuseUnpackable() const
{
	constexpr vtkIdType most = 0xFFFFFFFF;
	if (grid_->GetNumberOfPoints() > most || grid_->GetNumberOfCells() > most)
		throw Refusal("has more than 4 294 967 295 points or cells; pack it in several files");
	for (const std::uint8_t type : types_)
		if (read::cellDimension(type) == 3 && !read::canBeSliced(type))
			throw Refusal("has curved cells, which are not packed yet; use it as it is");
	const vtkIdType points = grid_->GetNumberOfPoints();
	withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    constexpr std::size_t at_once = 1 << 18;
		    const auto all = static_cast<std::size_t>(offsets[types_.size()]);
		    forEach((all + at_once - 1) / at_once,
		            [&](std::size_t block)
		            {
			            const auto* end = ids + std::min(all, (block + 1) * at_once);
			            if (std::any_of(ids + block * at_once, end, [&](auto id) { return id < 0 || id >= points; }))
				            throw damaged("a cell has a point that is not there");
		            });
	    });
	if (polyhedra_.hasPolyhedra())
		refuseBadFaces();
}

void PackDivision::refuseBadFaces() const
{
	const vtkIdType points = grid_->GetNumberOfPoints();
	constexpr std::size_t at_once = 1 << 12;
	forEach((types_.size() + at_once - 1) / at_once,
	        [&](std::size_t block)
	        {
		        for (std::size_t cell = block * at_once; cell < std::min(types_.size(), (block + 1) * at_once); ++cell)
			        polyhedra_.forEachFace(
			            cell,
			            [points](std::span<const vtkIdType> face)
			            {
				            if (std::ranges::any_of(face, [&](vtkIdType id) { return id < 0 || id >= points; }))
					            throw damaged("a face has a point that is not there");
			            });
	        });
}

// Where the middle of a cell's points lies. A cell without a place is put at the beginning.
template <class Id>
std::uint64_t PackDivision::placeOnCurve(const Id* begin, const Id* end, const PackBox& bounds) const
{
	std::array<double, 3> middle{};
	for (const Id* id = begin; id != end; ++id)
	{
		const auto at = place(static_cast<std::size_t>(*id));
		for (std::size_t axis = 0; axis < 3; ++axis)
			middle[axis] += at[axis] / static_cast<double>(end - begin);
	}
	constexpr double most = (1 << 21) - 1;
	std::array<std::uint32_t, 3> along{};
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const double length = bounds.hi[axis] - bounds.lo[axis];
		const double where = length > 0.0 ? (middle[axis] - bounds.lo[axis]) / length * most : 0.0;
		along[axis] = where > 0.0 ? static_cast<std::uint32_t>(std::min(where, most)) : 0; // NaN too
	}
	return mortonKey(along[0], along[1], along[2]);
}

// marks: of all cells, or none.
template <class Id>
bool PackDivision::isSeen(std::size_t cell, const Id* begin, const Id* end, std::span<const std::uint8_t> marks) const
{
	const auto hasPlace = [this](vtkIdType id)
	{ return std::ranges::all_of(place(static_cast<std::size_t>(id)), read::isPlace); };
	bool is_seen = read::cellDimension(types_[cell]) == 3 &&
	               (marks.empty() || !(marks[cell] & cells::kHiddenCellBits)) && std::all_of(begin, end, hasPlace);
	polyhedra_.forEachFace(cell, [&](std::span<const vtkIdType> face)
	                       { is_seen = is_seen && std::ranges::all_of(face, hasPlace); });
	return is_seen;
}

void PackDivision::divideCells(std::size_t most_cells)
{
	vtkUnsignedCharArray* ghosts = cells::ghostMarks(grid_);
	const auto marks =
	    ghosts ? std::span<const std::uint8_t>(ghosts->GetPointer(0), types_.size()) : std::span<const std::uint8_t>();
	PackBox bounds;
	for (std::size_t p = 0; p < static_cast<std::size_t>(grid_->GetNumberOfPoints()); ++p)
		bounds.include(place(p));
	HugeVector<CellOnCurve> cells;
	withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    const auto placesOf = [&](std::size_t first, std::span<std::uint64_t> places)
		    {
			    for (std::size_t i = 0; i < places.size(); ++i)
			    {
				    const auto *begin = ids + offsets[first + i], *end = ids + endOf(first + i, offsets);
				    places[i] =
				        isSeen(first + i, begin, end, marks) ? placeOnCurve(begin, end, bounds) : kBehindTheCurve;
			    }
		    };
		    cells = alongCurve(types_.size(), placesOf, threads_);
	    });
	order_.reserve(cells.size());
	for (const CellOnCurve& cell : cells)
		order_.push_back(cell.cell);
	const auto seen = static_cast<std::size_t>(std::partition_point(cells.begin(), cells.end(),
	                                                                [](const CellOnCurve& cell)
	                                                                { return cell.place < kBehindTheCurve; }) -
	                                           cells.begin());
	cell_ends_ = divide(std::span(cells).first(seen), most_cells);
	seen_parts_ = cell_ends_.size();
	for (std::size_t end = seen; end < cells.size();)
	{
		end = std::min(end + most_cells, cells.size());
		cell_ends_.push_back(end);
	}
	countLeftOut(std::span(order_).subspan(seen), marks);
}

void PackDivision::countLeftOut(std::span<const std::uint32_t> cells, std::span<const std::uint8_t> marks)
{
	for (const std::uint32_t cell : cells)
		if (read::cellDimension(types_[cell]) < 3)
			++left_out_.flat;
		else if (!marks.empty() && (marks[cell] & cells::kHiddenCellBits))
			++left_out_.hidden;
		else
			++left_out_.unplaced;
}

void PackDivision::choosePoints()
{
	points_.resize(parts());
	runs_.resize(parts());
	std::vector<std::size_t> first_runs; // the number of the first run of each part
	std::size_t runs = 0;
	for (std::size_t part = 0; part < parts(); ++part)
	{
		first_runs.push_back(runs);
		runs_[part].resize((cells(part).size() + cells_of_run_ - 1) / cells_of_run_);
		runs += runs_[part].size();
	}
	withLists([&](const auto* offsets, const auto* ids)
	          { forEach(parts(), [&](std::size_t part) { choosePointsOf(part, first_runs[part], offsets, ids); }); });
}

template <class Id>
void PackDivision::choosePointsOf(std::size_t part, std::size_t first_run, const Id* offsets, const Id* ids)
{
	// For each point the last run that was seen to have it, plus 1.
	thread_local std::vector<std::uint32_t> last_run;
	thread_local std::vector<std::uint32_t> of_run;
	thread_local const PackDivision* division = nullptr; // whose points these are
	if (std::exchange(division, this) != this)
		last_run.assign(static_cast<std::size_t>(grid_->GetNumberOfPoints()), 0);
	std::vector<std::uint32_t>& of_part = points_[part];
	std::span<const std::uint32_t> cells = this->cells(part);
	auto number = static_cast<std::uint32_t>(first_run);
	for (PackRun& run : runs_[part])
	{
		++number;
		of_run.clear();
		const auto include = [&](std::uint32_t id)
		{
			const std::uint32_t last = std::exchange(last_run[id], number);
			if (last == number)
				return;
			of_run.push_back(id);
			if (last <= first_run)
				of_part.push_back(id);
			if (part < seen_parts_)
				run.box.include(place(id));
		};
		for (const std::uint32_t cell : cells.first(std::min(cells_of_run_, cells.size())))
		{
			for (auto i = offsets[cell]; i < endOf(cell, offsets); ++i, ++run.ids)
				include(static_cast<std::uint32_t>(ids[i]));
			polyhedra_.forEachFace(cell,
			                       [&](std::span<const vtkIdType> face)
			                       {
				                       ++run.faces;
				                       run.face_ids += static_cast<std::uint32_t>(face.size());
				                       for (const vtkIdType id : face)
					                       include(static_cast<std::uint32_t>(id));
			                       });
		}
		run.points.assign(of_run.begin(), of_run.end());
		cells = cells.subspan(std::min(cells_of_run_, cells.size()));
	}
	std::sort(of_part.begin(), of_part.end());
}

} // namespace vp::reader::convert
