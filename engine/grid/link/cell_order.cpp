#include "grid/link/cell_order.h"

#include "base/ids.h"
#include "base/parallel_reduce.h"
#include "grid/link/for_ranges.h"
#include "grid/link/morton.h"

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vp::grid
{

namespace
{

Box finiteBounds(const Points& points)
{
	return parallelReduce(
	    points.size(), 65536, Box{},
	    [&](const tbb::blocked_range<std::size_t>& range, Box box)
	    {
		    for (std::size_t p = range.begin(); p < range.end(); ++p)
			    if (const Vec3 x = points[p]; std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z))
				    box.include(x);
		    return box;
	    },
	    [](Box a, const Box& b)
	    {
		    a.include(b);
		    return a;
	    });
}

using Counts = std::array<std::size_t, 256>; // number of cells of each VTK type

Counts countTypes(std::span<const std::uint8_t> types)
{
	return parallelReduce(
	    types.size(), 65536, Counts{},
	    [&](const tbb::blocked_range<std::size_t>& range, Counts counts)
	    {
		    // Most lists hold long runs of one type, and many types are compared in one step.
		    const std::uint8_t first = types[range.begin()];
		    unsigned others = 0;
		    for (std::size_t c = range.begin(); c < range.end(); ++c)
			    others |= types[c] ^ first;
		    if (others == 0)
			    counts[first] += range.size();
		    else
			    for (std::size_t c = range.begin(); c < range.end(); ++c)
				    ++counts[types[c]];
		    return counts;
	    },
	    [](Counts a, const Counts& b)
	    {
		    for (std::size_t type = 0; type < a.size(); ++type)
			    a[type] += b[type];
		    return a;
	    });
}

class Orderer
{
public:
	Orderer(const Points& points, const CellList& cells) : points_(points), cells_(cells) {}

	CellOrder order()
	{
		choose();
		const MortonCurve curve(finiteBounds(points_));
		orderCells(curve);
		orderPoints(curve);
		return std::move(order_);
	}

private:
	std::size_t keptCell(std::size_t n) const { return kept_.empty() ? n : kept_[n]; }

	void choose()
	{
		const std::size_t count = cells_.size();
		const CellCounts counts = countCells(points_, cells_);
		const std::size_t kept = counts.kept;
		order_.left_out = counts.left_out;
		if (kept < count)
		{
			kept_.reserve(kept);
			for (std::size_t c = 0; c < count; ++c)
				if (isSliceable(cells_.types[c]))
					kept_.push_back(c);
		}
		order_.cells.resize(kept);
		order_.has_polyhedra = counts.polyhedra > 0;
		order_.all_tetrahedra = kept > 0 && kept == counts.tetrahedra;
	}

	void orderCells(const MortonCurve& curve)
	{
		const std::size_t count = order_.cells.size();
		KeyedIds items(count);
		used_.resize(points_.size());
		forRanges(count,
		          [&](std::size_t n)
		          {
			          Vec3 sum(0.0);
			          int points = 0;
			          cells_.forEachPoint(keptCell(n),
			                              [&](std::int64_t p)
			                              {
				                              sum += points_[p];
				                              ++points;
				                              const std::atomic_ref<std::uint8_t> used(used_[p]);
				                              if (!used.load(std::memory_order_relaxed))
					                              used.store(1, std::memory_order_relaxed);
			                              });
			          items[n] = {curve(sum / static_cast<double>(points)), static_cast<std::uint32_t>(n)};
		          });
		sortByKey(items);
		forRanges(count, [&](std::size_t c) { order_.cells[c] = static_cast<std::uint32_t>(keptCell(items[c].id)); });
	}

	// Along the same curve as the cells; points of no cell at the end.
	void orderPoints(const MortonCurve& curve)
	{
		const std::size_t count = points_.size();
		KeyedIds items(count);
		forRanges(count,
		          [&](std::size_t p)
		          {
			          const std::uint64_t unused_last = used_[p] ? 0 : MortonCurve::kLast + 1;
			          items[p] = {curve(points_[p]) | unused_last, static_cast<std::uint32_t>(p)};
		          });
		used_ = {};
		sortByKey(items);
		order_.points.resize(count);
		order_.rank.resize(count);
		forRanges(count,
		          [&](std::size_t p)
		          {
			          order_.points[p] = items[p].id;
			          order_.rank[items[p].id] = static_cast<std::uint32_t>(p);
		          });
		order_.used_points = count;
		while (order_.used_points > 0 && items[order_.used_points - 1].key > MortonCurve::kLast)
			--order_.used_points;
	}

	const Points& points_;
	const CellList& cells_;
	CellOrder order_;
	std::vector<std::size_t> kept_;  // places in the list of the cells, empty where all are
	std::vector<std::uint8_t> used_; // per source point: whether a cell has it
};

} // namespace

CellCounts countCells(const Points& points, const CellList& cells)
{
	const Counts of_type = countTypes(cells.types.span());
	CellCounts counts;
	for (int type = 0; type < 256; ++type)
	{
		const auto vtk_type = static_cast<std::uint8_t>(type);
		if (isSliceable(vtk_type))
			counts.kept += of_type[type];
		else if (const int dimension = vtkDimension(vtk_type); dimension >= 0 && dimension < 3)
			counts.left_out += of_type[type];
	}
	counts.tetrahedra = of_type[kTetra];
	counts.polyhedra = of_type[kPolyhedron];
	counts.alike = cells.size() > 0 && counts.polyhedra == 0 && counts.kept == cells.size() &&
	               of_type[cells.types[0]] == cells.size();
	if (counts.kept > kMaxBlockIds || points.size() > kMaxBlockIds)
		throw std::length_error("a block holds at most 3221225472 cells or points");
	if (cells.size() > 0xFFFFFFFFu)
		throw std::length_error("a block lists at most 4294967295 cells");
	return counts;
}

std::size_t countSources(const CellList& cells)
{
	std::vector<bool> seen;
	std::size_t count = 0;
	for (std::size_t c = 0; c < cells.size(); ++c)
	{
		if (!isSliceable(cells.types[c]))
			continue;
		const auto source = static_cast<std::size_t>(cells.source_cells[c]);
		if (source >= seen.size())
			seen.resize(source + 1);
		count += !seen[source];
		seen[source] = true;
	}
	return count;
}

CellOrder orderCells(const Points& points, const CellList& cells)
{
	return Orderer(points, cells).order();
}

} // namespace vp::grid
