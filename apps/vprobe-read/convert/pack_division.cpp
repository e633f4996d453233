#include "pack_division.h"

#include "octree_parts.h"
#include "read/cell_types.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/quick/tasks.h"

#include <vtkDataArray.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vp::reader::convert
{

void PackBox::include(const std::array<double, 3>& at)
{
	for (std::size_t axis = 0; axis < 3; ++axis)
		if (std::isfinite(at[axis]))
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

void PackDivision::forEach(std::size_t count, const std::function<void(std::size_t)>& work) const
{
	quick::Tasks tasks(threads_);
	tasks.add(count, [&](std::size_t number, arrays::Scratch&) { work(number); });
	tasks.run();
}

void PackDivision::refuseUnpackable() const
{
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

void PackDivision::divideCells(std::size_t most_cells)
{
	PackBox bounds;
	for (std::size_t p = 0; p < static_cast<std::size_t>(grid_->GetNumberOfPoints()); ++p)
		bounds.include(place(p));
	std::vector<CellOnCurve> cells(types_.size());
	constexpr std::size_t at_once = 1 << 14;
	withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    forEach((cells.size() + at_once - 1) / at_once,
		            [&](std::size_t run)
		            {
			            for (std::size_t c = run * at_once; c < std::min(cells.size(), (run + 1) * at_once); ++c)
				            cells[c] = {keyOf(ids + offsets[c], ids + offsets[c + 1], bounds),
				                        static_cast<std::uint32_t>(c)};
		            });
	    });
	cell_ends_ = divide(cells, most_cells, threads_);
	order_.reserve(cells.size());
	for (const CellOnCurve& cell : cells)
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
			            thread_local std::vector<std::uint32_t> last_part; // plus 1, that had a point
			            last_part.resize(static_cast<std::size_t>(grid_->GetNumberOfPoints()));
			            const std::span<const std::uint32_t> cells = this->cells(part);
			            runs_[part].resize((cells.size() + cells_of_run_ - 1) / cells_of_run_);
			            for (std::size_t c = 0; c < cells.size(); ++c)
			            {
				            PackRun& run = runs_[part][c / cells_of_run_];
				            for (auto i = offsets[cells[c]]; i < offsets[cells[c] + 1]; ++i)
				            {
					            const auto id = static_cast<std::uint32_t>(ids[i]);
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
