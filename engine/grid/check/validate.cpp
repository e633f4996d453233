#include "base/parallel_for.h"
#include "grid/block.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace vp::grid
{

namespace
{

template <class... Args>
void require(bool holds, fmt::format_string<Args...> format, Args&&... args)
{
	if (!holds)
		throw std::logic_error(fmt::format(format, std::forward<Args>(args)...));
}

// A coordinate that is not a number lies in no box and counts as held.
bool boxHolds(const Box& box, const Vec3& p)
{
	for (int axis = 0; axis < 3; ++axis)
		if (p[axis] < box.lo[axis] || p[axis] > box.hi[axis])
			return false;
	return true;
}

bool boxHolds(const Box& outer, const Box& inner)
{
	return inner.lo.x > inner.hi.x || (boxHolds(outer, inner.lo) && boxHolds(outer, inner.hi));
}

bool hasThreePoints(std::span<const PointId> face)
{
	return std::set<PointId>(face.begin(), face.end()).size() >= 3;
}

template <Grid G>
void checkCell(const G& grid, CellId c, const Box& bounds, CellFaces& faces)
{
	grid.cellFaces(c, faces);
	require(faces.size() == grid.faceCount(c), "cell {}: {} faces listed, {} counted", c, faces.size(),
	        grid.faceCount(c));
	if (grid.shape(c) != CellShape::polyhedron)
		require(grid.cellPoints(c).size == topology(grid.shape(c)).points, "cell {}: number of points", c);
	for (const PointId p : faces.points)
	{
		require(p < grid.pointCount(), "cell {}: point {} out of range", c, p);
		const Vec3 x = grid.point(p);
		const bool finite = std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
		require(!finite || boxHolds(bounds, x), "cell {}: point {} outside the bounds", c, p);
	}
	for (int f = 0; f < faces.size(); ++f)
		grid.forEachNeighbor(c, f,
		                     [&](CellId n)
		                     {
			                     require(n < grid.cellCount(), "cell {} face {}: neighbor {} out of range", c, f, n);
			                     require(n != c, "cell {} face {}: neighbor of itself", c, f);
			                     bool known = false;
			                     for (int g = 0; g < grid.faceCount(n); ++g)
				                     grid.forEachNeighbor(n, g, [&](CellId back) { known = known || back == c; });
			                     require(known, "cell {} face {}: neighbor {} does not know it", c, f, n);
		                     });
}

template <Grid G>
void checkCells(const G& grid, const Box& bounds)
{
	require(grid.cellCount() <= kMaxBlockIds && grid.pointCount() <= kMaxBlockIds, "too many cells or points");
	tracedFor(tbb::blocked_range<std::size_t>(0, grid.cellCount(), 1024),
	          [&](const auto& range)
	          {
		          CellFaces faces;
		          for (std::size_t c = range.begin(); c < range.end(); ++c)
			          checkCell(grid, static_cast<CellId>(c), bounds, faces);
	          });
}

// Source numbers of cells or points: no two alike, and all within the arrays.
template <class Source>
void checkSources(std::size_t count, std::size_t distinct, Source&& source, const Block& block, Association association)
{
	std::vector<std::size_t> numbers(count);
	for (std::size_t i = 0; i < count; ++i)
		numbers[i] = source(i);
	std::ranges::sort(numbers);
	const char* name = associationName(association);
	const std::size_t found = static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
	require(found == distinct, "{} {}s have {} sources instead of {}", count, name, found, distinct);
	numbers.resize(found);
	for (const Field& field : block.fields)
	{
		require(field.components > 0, "array {}: no components", field.name);
		const std::size_t bytes = field.stored ? field.stored->layout().byteCount() : field.bytes.size();
		require(bytes == field.tuples() * field.components * byteSize(field.type), "array {}: part of a tuple",
		        field.name);
		if (field.association == association)
			require(numbers.empty() || numbers.back() < field.tuples(), "array {}: {} tuples are too few", field.name,
			        field.tuples());
	}
}

template <Grid G>
void checkBoundary(const G& grid, const BoundaryIndex& index)
{
	std::uint32_t next = 0;
	for (const BoundaryIndex::Range& patch : index.patches)
	{
		require(patch.begin == next && patch.end > patch.begin && patch.end - patch.begin <= 16,
		        "patches out of order");
		next = patch.end;
	}
	require(next == index.faces.size(), "faces in no patch");
	next = 0;
	for (const BoundaryIndex::Range& group : index.groups)
	{
		require(group.begin == next && group.end > group.begin && group.end - group.begin <= 64, "groups out of order");
		require(group.end <= index.patches.size(), "group beyond the patches");
		next = group.end;
		for (std::uint32_t p = group.begin; p < group.end; ++p)
			require(boxHolds(group.box, index.patches[p].box), "patch {} outside its group's box", p);
	}
	require(next == index.patches.size(), "patches in no group");

	CellFaces faces;
	for (const BoundaryIndex::Range& patch : index.patches)
		for (std::uint32_t i = patch.begin; i < patch.end; ++i)
		{
			const auto [cell, f] = index.faces[i];
			require(cell < grid.cellCount() && static_cast<int>(f) < grid.faceCount(cell),
			        "boundary face {} out of range", i);
			grid.cellFaces(cell, faces);
			for (const PointId p : faces[f])
				require(boxHolds(patch.box, grid.point(p)), "boundary face {} outside its patch's box", i);
		}
}

// Each face without neighbor once, and no other.
template <Grid G>
void checkBoundaryComplete(const G& grid, const BoundaryIndex& index)
{
	std::vector<std::pair<CellId, std::uint32_t>> listed;
	for (const BoundaryIndex::Face& face : index.faces)
		listed.emplace_back(face.cell, face.face);
	std::ranges::sort(listed);
	std::vector<std::pair<CellId, std::uint32_t>> expected;
	CellFaces faces;
	for (std::size_t c = 0; c < grid.cellCount(); ++c)
	{
		const CellId cell = static_cast<CellId>(c);
		for (int f = 0; f < grid.faceCount(cell); ++f)
		{
			bool alone = true;
			grid.forEachNeighbor(cell, f, [&](CellId) { alone = false; });
			if (!alone)
				continue;
			grid.cellFaces(cell, faces);
			if (!std::is_same_v<G, UnstructuredGrid> || hasThreePoints(faces[f]))
				expected.emplace_back(cell, static_cast<std::uint32_t>(f));
		}
	}
	require(listed == expected, "boundary index: {} faces listed, {} have no neighbor", listed.size(), expected.size());
}

} // namespace

void validate(const Block& block)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    checkCells(grid, block.bounds);
		    checkSources(
		        grid.pointCount(), grid.pointCount(),
		        [&](std::size_t p) { return grid.sourcePoint(static_cast<PointId>(p)); }, block, Association::point);
		    std::size_t cells = grid.cellCount();
		    if constexpr (requires { grid.sourceCellCount(); })
			    cells = grid.sourceCellCount();
		    checkSources(
		        grid.cellCount(), cells, [&](std::size_t c) { return grid.sourceCell(static_cast<CellId>(c)); }, block,
		        Association::cell);
		    checkBoundary(grid, block.boundary);
		    checkBoundaryComplete(grid, block.boundary);
		    require(block.vantage.empty() == (grid.cellCount() == 0), "vantage points");
		    for (const std::vector<CellId>* cells : {&block.vantage, &block.inverted})
		    {
			    require(std::ranges::adjacent_find(*cells, std::greater_equal<>{}) == cells->end(),
			            "vantage or inverted cells not ascending");
			    require(cells->empty() || cells->back() < grid.cellCount(), "vantage or inverted cell out of range");
		    }
	    },
	    block.grid);
}

} // namespace vp::grid
