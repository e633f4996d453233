#include "read/placed_cells.h"

#include "base/parallel_for.h"
#include "grid/curved/curved_types.h"
#include "read/cell_types.h"

#include <fmt/format.h>

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace vp::read
{

namespace
{

constexpr std::size_t kPlaceGrain = 1 << 16;

template <class Number>
bool areAllWithin(const Number* numbers, std::size_t count, Number most)
{
	std::atomic<bool> all = true;
	parallelFor(tbb::blocked_range<std::size_t>(0, count, kPlaceGrain),
	            [&, most](const tbb::blocked_range<std::size_t>& range)
	            {
		            // Without a way out, so that the compiler makes it several numbers at a time.
		            unsigned bad = 0;
		            for (std::size_t i = range.begin(); i < range.end(); ++i)
			            bad |= static_cast<unsigned>(!(std::abs(numbers[i]) <= most));
		            if (bad)
			            all = false;
	            });
	return all;
}

bool isPlaced(const Vec3& at)
{
	return isPlace(at.x) && isPlace(at.y) && isPlace(at.z);
}

// A mark for each point: whether it has no place.
std::vector<std::uint8_t> unplacedPoints(const grid::Points& points)
{
	std::vector<std::uint8_t> marks(points.size());
	parallelFor(tbb::blocked_range<std::size_t>(0, marks.size(), kPlaceGrain),
	            [&](const auto& range)
	            {
		            for (std::size_t p = range.begin(); p < range.end(); ++p)
			            marks[p] = !isPlaced(points[p]);
	            });
	return marks;
}

[[noreturn]] void refuseUnplaced(const grid::Points& points, const std::vector<std::uint8_t>& unplaced,
                                 std::size_t cells)
{
	const std::size_t bad = static_cast<std::size_t>(std::ranges::find(unplaced, 1) - unplaced.begin());
	const Vec3 at = points[bad];
	const bool is_finite = std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z);
	throw NonePlaced(fmt::format("every cell has a point without a place; the coordinates of point {} are {}", bad,
	                             is_finite ? "larger than 1e50" : "not finite numbers"),
	                 cells);
}

bool hasUnplaced(const grid::CellList& cells, std::size_t cell, const std::vector<std::uint8_t>& unplaced)
{
	bool has = false;
	const auto look = [&](std::int64_t p) { has |= unplaced[static_cast<std::size_t>(p)] != 0; };
	if (cells.isPolyhedron(cell))
	{
		cells.forEachPoint(cell, look);
		return has;
	}
	const std::size_t alike = cells.connectivity.size() / cells.size();
	const std::size_t begin = cells.offsets.empty() ? cell * alike : static_cast<std::size_t>(cells.offsets[cell]);
	const std::size_t end = cells.offsets.empty() ? begin + alike : static_cast<std::size_t>(cells.offsets[cell + 1]);
	for (std::size_t i = begin; i < end; ++i)
		look(cells.connectivity[i]);
	return has;
}

// Offsets for cells that were alike and are so no more.
void writeOffsets(grid::CellList& cells)
{
	if (!cells.offsets.empty())
		return;
	const auto alike = static_cast<std::int64_t>(cells.connectivity.size() / cells.size());
	std::vector<std::int64_t> offsets(cells.size() + 1);
	for (std::size_t c = 0; c < offsets.size(); ++c)
		offsets[c] = static_cast<std::int64_t>(c) * alike;
	cells.offsets = Array(std::move(offsets));
}

// Marks all parts of a cell of the file if one of them is marked. Returns the number of cells of the file.
std::size_t markWhole(const Array<std::int64_t>& source_cells, std::size_t sources, std::vector<std::uint8_t>& marks)
{
	if (source_cells.empty())
		return static_cast<std::size_t>(std::ranges::count(marks, 1));
	std::vector<std::uint8_t> whole(sources);
	for (std::size_t c = 0; c < marks.size(); ++c)
		whole[static_cast<std::size_t>(source_cells[c])] |= marks[c];
	for (std::size_t c = 0; c < marks.size(); ++c)
		marks[c] = whole[static_cast<std::size_t>(source_cells[c])];
	return static_cast<std::size_t>(std::ranges::count(whole, 1));
}

} // namespace

bool areAllPlaces(const grid::Points& points)
{
	// All finite numbers of single precision are places.
	return points.isDouble() ? areAllWithin(points.doubles(), 3 * points.size(), kMaxCoordinate)
	                         : areAllWithin(points.floats(), 3 * points.size(), std::numeric_limits<float>::max());
}

std::size_t leaveOutUnplaced(CellMesh& mesh)
{
	grid::CellList& cells = mesh.cells;
	if (areAllPlaces(mesh.points))
		return 0;
	if (!cells.has_checked_ids)
		grid::checkIds(cells.connectivity, mesh.points.size());
	cells.has_checked_ids = true;
	const std::vector<std::uint8_t> unplaced = unplacedPoints(mesh.points);
	const auto is_cut = [&](std::size_t c)
	{ return canBeSliced(cells.types[c]) || (mesh.curved && grid::isCurved(cells.types[c])); };
	std::vector<std::uint8_t> marks(cells.size());
	parallelFor(tbb::blocked_range<std::size_t>(0, marks.size(), kPlaceGrain),
	            [&](const auto& range)
	            {
		            for (std::size_t c = range.begin(); c < range.end(); ++c)
			            marks[c] = is_cut(c) && hasUnplaced(cells, c, unplaced);
	            });
	const std::size_t count = markWhole(cells.source_cells, mesh.source_cell_count, marks);
	if (count == 0)
		return 0;
	writeOffsets(cells);
	std::vector<std::uint8_t> types(cells.types.data(), cells.types.data() + cells.size());
	bool any = false;
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		any |= is_cut(c) && !marks[c];
		if (marks[c])
			types[c] = kEmptyCell;
	}
	if (!any)
		refuseUnplaced(mesh.points, unplaced, count);
	cells.types = Array(std::move(types));
	return count;
}

std::size_t takePlacedLattice(const std::array<std::uint32_t, 3>& points_along, grid::Points points,
                              CheckedBlock& block)
{
	if (areAllPlaces(points))
	{
		block.mesh = grid::CurvilinearGrid(points_along, std::move(points));
		return 0;
	}
	const grid::Lattice lattice(points_along);
	const std::vector<std::uint8_t> unplaced = unplacedPoints(points);
	std::vector<std::uint8_t> types(lattice.cellCount(), kEmptyCell);
	std::vector<std::int64_t> offsets{0};
	std::vector<std::int64_t> corners;
	offsets.reserve(types.size() + 1);
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		const grid::CellPoints ids = lattice.cellPoints(static_cast<CellId>(c));
		if (std::none_of(ids.begin(), ids.end(), [&](PointId p) { return unplaced[p] != 0; }))
		{
			types[c] = kHexahedron;
			corners.insert(corners.end(), ids.begin(), ids.end());
		}
		offsets.push_back(static_cast<std::int64_t>(corners.size()));
	}
	const auto left_out = static_cast<std::size_t>(std::ranges::count(types, kEmptyCell));
	if (corners.empty())
		refuseUnplaced(points, unplaced, left_out);
	CellMesh mesh;
	mesh.points = std::move(points);
	mesh.cells.types = Array(std::move(types));
	mesh.cells.offsets = Array(std::move(offsets));
	mesh.cells.connectivity = std::move(corners);
	block.hidden_lattice = lattice;
	block.mesh = std::move(mesh);
	return left_out;
}

void removeUnplaced(grid::PatchPolygons& polygons)
{
	if (areAllPlaces(polygons.points))
		return;
	std::vector<std::int64_t> starts{0};
	std::vector<std::int64_t> corners;
	for (std::size_t p = 0; p < polygons.polygons(); ++p)
	{
		const auto of =
		    polygons.corners.span().subspan(static_cast<std::size_t>(polygons.starts[p]),
		                                    static_cast<std::size_t>(polygons.starts[p + 1] - polygons.starts[p]));
		if (!std::ranges::all_of(of, [&](std::int64_t corner)
		                         { return isPlaced(polygons.points[static_cast<std::size_t>(corner)]); }))
			continue;
		corners.insert(corners.end(), of.begin(), of.end());
		starts.push_back(static_cast<std::int64_t>(corners.size()));
	}
	polygons.starts = Array(std::move(starts));
	polygons.corners = Array(std::move(corners));
}

ReadWarning unplacedWarning(std::size_t cells)
{
	const auto words = [](const char* cells_are, const char* each)
	{
		return fmt::format("{} left out: a point of {} has coordinates that are not finite, or larger than 1e50",
		                   cells_are, each);
	};
	return {cells, words("cells are", "each"), words("cell is", "it")};
}

} // namespace vp::read
