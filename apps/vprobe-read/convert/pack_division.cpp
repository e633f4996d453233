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
    : grid_(grid), types_(grid->GetCellTypesArray()->GetPointer(0),
                          static_cast<std::size_t>(grid->GetCellTypesArray()->GetNumberOfValues())),
      places_(grid->GetPoints()->GetData()), threads_(threads)
{
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

std::size_t PackDivision::ids(std::size_t part) const
{
	std::size_t ids = 0;
	for (const PackRun& run : runs_[part])
		ids += run.ids;
	return ids;
}

std::size_t PackDivision::allPoints() const
{
	std::size_t sum = 0;
	for (const std::vector<std::uint32_t>& of_part : points_)
		sum += of_part.size();
	return sum;
}

std::size_t PackDivision::allIds() const
{
	std::size_t sum = 0;
	for (std::size_t part = 0; part < parts(); ++part)
		sum += ids(part);
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
	return std::ranges::all_of(types_, [this](std::uint8_t type) { return type == types_[0]; });
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
		if (type == read::kPolyhedron || (read::cellDimension(type) == 3 && !read::canBeSliced(type)))
			throw Refusal(fmt::format("has {}, which are not packed yet; use it as it is",
			                          type == read::kPolyhedron ? "polyhedra" : "curved cells"));
	const vtkIdType points = grid_->GetNumberOfPoints();
	withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    const auto all = static_cast<std::size_t>(offsets[types_.size()]);
		    if (std::any_of(ids, ids + all, [&](auto id) { return id < 0 || id >= points; }))
			    throw damaged("a cell has a point that is not there");
	    });
}

std::array<double, 3> PackDivision::place(std::size_t point) const
{
	std::array<double, 3> at;
	if (places_->GetDataType() == VTK_FLOAT)
		std::copy_n(static_cast<const float*>(places_->GetVoidPointer(0)) + 3 * point, 3, at.begin());
	else if (places_->GetDataType() == VTK_DOUBLE)
		std::copy_n(static_cast<const double*>(places_->GetVoidPointer(0)) + 3 * point, 3, at.begin());
	else
		places_->GetTuple(static_cast<vtkIdType>(point), at.data());
	return at;
}

// Where the middle of a cell's points lies. A cell without a place is put at the beginning.
template <class Id>
std::uint64_t PackDivision::keyOf(const Id* begin, const Id* end, const PackBox& bounds) const
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

// Counts a cell that nobody sees. marks: of all cells, or none.
template <class Id>
bool PackDivision::isSeen(std::size_t cell, const Id* begin, const Id* end, std::span<const std::uint8_t> marks)
{
	const auto hasPlace = [this](Id id)
	{ return std::ranges::all_of(place(static_cast<std::size_t>(id)), read::isPlace); };
	vtkIdType* count = read::cellDimension(types_[cell]) < 3                      ? &left_out_.flat
	                   : !marks.empty() && (marks[cell] & cells::kHiddenCellBits) ? &left_out_.hidden
	                   : !std::all_of(begin, end, hasPlace)                       ? &left_out_.unplaced
	                                                                              : nullptr;
	if (count)
		++*count;
	return !count;
}

void PackDivision::divideCells(std::size_t most_cells)
{
	vtkUnsignedCharArray* ghosts = cells::ghostMarks(grid_);
	const auto marks =
	    ghosts ? std::span<const std::uint8_t>(ghosts->GetPointer(0), types_.size()) : std::span<const std::uint8_t>();
	PackBox bounds;
	for (std::size_t p = 0; p < static_cast<std::size_t>(grid_->GetNumberOfPoints()); ++p)
		bounds.include(place(p));
	std::vector<CellOnCurve> cells(types_.size()), unseen;
	constexpr std::size_t at_once = 1 << 14;
	withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    forEach((cells.size() + at_once - 1) / at_once,
		            [&](std::size_t run)
		            {
			            for (std::size_t c = run * at_once; c < std::min(cells.size(), (run + 1) * at_once); ++c)
				            cells[c] = {keyOf(ids + offsets[c], ids + endOf(c, offsets), bounds),
				                        static_cast<std::uint32_t>(c)};
		            });
		    std::erase_if(cells,
		                  [&](const CellOnCurve& cell)
		                  {
			                  const std::size_t c = cell.second;
			                  if (isSeen(c, ids + offsets[c], ids + endOf(c, offsets), marks))
				                  return false;
			                  unseen.push_back(cell);
			                  return true;
		                  });
	    });
	cell_ends_ = divide(cells, most_cells, threads_);
	seen_parts_ = cell_ends_.size();
	for (std::size_t end = 0; end < unseen.size();)
	{
		end = std::min(end + most_cells, unseen.size());
		cell_ends_.push_back(cells.size() + end);
	}
	order_.reserve(types_.size());
	for (const std::vector<CellOnCurve>* list : {&cells, &unseen})
		for (const CellOnCurve& cell : *list)
			order_.push_back(cell.second);
}

void PackDivision::choosePoints()
{
	points_.resize(cell_ends_.size());
	runs_.resize(cell_ends_.size());
	withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    forEach(cell_ends_.size(),
		            [&](std::size_t part)
		            {
			            // For each point the last part that was seen to have it, plus 1.
			            thread_local std::vector<std::uint32_t> last_part;
			            thread_local const PackDivision* division = nullptr; // whose points these are
			            if (std::exchange(division, this) != this)
				            last_part.assign(static_cast<std::size_t>(grid_->GetNumberOfPoints()), 0);
			            const std::span<const std::uint32_t> cells = this->cells(part);
			            runs_[part].resize((cells.size() + cells_of_run_ - 1) / cells_of_run_);
			            for (std::size_t c = 0; c < cells.size(); ++c)
			            {
				            PackRun& run = runs_[part][c / cells_of_run_];
				            for (auto i = offsets[cells[c]]; i < endOf(cells[c], offsets); ++i)
				            {
					            const auto id = static_cast<std::uint32_t>(ids[i]);
					            if (part < seen_parts_)
						            run.box.include(place(id));
					            ++run.ids;
					            if (std::exchange(last_part[id], static_cast<std::uint32_t>(part + 1)) != part + 1)
						            points_[part].push_back(id);
				            }
			            }
			            std::sort(points_[part].begin(), points_[part].end());
		            });
	    });
}

} // namespace vp::reader::convert
