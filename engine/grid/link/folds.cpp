#include "grid/link/folds.h"

#include "base/parallel_for.h"
#include "grid/cell_turn.h"
#include "grid/link/edge_boxes.h"
#include "grid/record_reader.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace vp::grid
{

namespace
{

constexpr std::size_t kFoldChunk = 16384; // cells

// One per cell; written by foldedCells() of each grid.
class Turns
{
public:
	explicit Turns(std::size_t cells) : turns_(new Turn[cells]), cells_(cells) {}

	Turn& operator[](std::size_t cell) { return turns_[cell]; }
	Turn operator[](std::size_t cell) const { return turns_[cell]; }

	// The cells that are not turned as most are, ascending. Mixed ones have no voice.
	std::vector<CellId> minority() const
	{
		const std::vector<Count> counts = countChunks();
		std::ptrdiff_t surplus = 0;
		for (const Count& count : counts)
			surplus += count.positive - count.negative;
		const Turn most = surplus >= 0 ? Turn::positive : Turn::negative;
		std::vector<CellId> cells;
		for (std::size_t n = 0; n < counts.size(); ++n)
		{
			const auto [begin, end] = chunk(n);
			const std::ptrdiff_t alike = most == Turn::positive ? counts[n].positive : counts[n].negative;
			if (static_cast<std::size_t>(alike) == end - begin)
				continue;
			for (std::size_t c = begin; c < end; ++c)
				if (turns_[c] != most)
					cells.push_back(static_cast<CellId>(c));
		}
		return cells;
	}

private:
	struct Count
	{
		std::ptrdiff_t positive;
		std::ptrdiff_t negative;
	};

	std::pair<std::size_t, std::size_t> chunk(std::size_t n) const
	{
		return {n * kFoldChunk, std::min(cells_, (n + 1) * kFoldChunk)};
	}
	std::vector<Count> countChunks() const
	{
		std::vector<Count> counts((cells_ + kFoldChunk - 1) / kFoldChunk);
		parallelFor(std::size_t(0), counts.size(),
		            [&](std::size_t n)
		            {
			            const auto [begin, end] = chunk(n);
			            const Turn* turns = turns_.get();
			            counts[n] = {std::count(turns + begin, turns + end, Turn::positive),
			                         std::count(turns + begin, turns + end, Turn::negative)};
		            });
		return counts;
	}

	std::unique_ptr<Turn[]> turns_;
	std::size_t cells_;
};

template <Grid G>
Turn turnOfCell(const G& grid, CellId cell)
{
	const CellPoints ids = grid.cellPoints(cell);
	std::array<Vec3, kMaxShapePoints> points;
	for (int i = 0; i < ids.size; ++i)
		points[i] = grid.point(ids.id[i]);
	return turnOf(grid.shape(cell), {points.data(), static_cast<std::size_t>(ids.size)});
}

// Returns true if three cells or more have a face of this cell, so that two of them lie on the same side of it, or if
// another cell has its first two faces, which means a copy of the cell.
template <int kFaces>
bool isCrowded(const std::uint32_t* across, bool has_crowds)
{
	bool crowded = across[0] == across[1] && across[0] != kNoCell;
	for (int f = 0; f < kFaces && has_crowds; ++f)
		crowded |= across[f] >= kMaxBlockIds && across[f] != kNoCell;
	return crowded;
}

// Mixed where a cell is to be looked at among its neighbors.
template <int kWidth, class Number>
Turn turnOfRecord(const RecordReader<kWidth, Number>& reader, CellId cell, bool has_crowds)
{
	const std::uint32_t* record = reader.record(cell);
	const CellShape shape = reader.shape(record);
	constexpr int kFaces = kWidth == 4 ? 4 : 6;
	if (shape == CellShape::polyhedron || isCrowded<kFaces>(reader.across(record), has_crowds))
		return Turn::mixed;
	std::array<Vec3, kWidth> points;
	const int count = topology(shape).points;
	for (int i = 0; i < count; ++i)
		points[i] = reader.point(record[i]);
	return turnOf(shape, {points.data(), static_cast<std::size_t>(count)});
}

// Cells along i, j and k that are settled at once where their edges are much alike: 2 ns a cell, where one by one it
// is some 50.
constexpr std::array<std::uint32_t, 3> kBrick{16, 8, 8};

// A brick with fewer cells along i is checked cell by cell (see edgeBoxes()).
constexpr std::uint32_t kMinRow = 4;

// Returns the turn of all cells of a brick, or mixed if they must be checked one by one.
Turn turnOfBrick(const CurvilinearGrid& grid, const std::array<std::uint32_t, 3>& lo,
                 const std::array<std::uint32_t, 3>& size)
{
	if (size[0] < kMinRow)
		return Turn::mixed;
	const std::size_t first = 3 * std::size_t(grid.pointId(lo[0], lo[1], lo[2]));
	const std::size_t row = 3 * std::size_t(grid.points()[0]);
	const std::size_t layer = row * grid.points()[1];
	const Points& points = grid.coordinates();
	const auto [u, v, w] = points.isDouble() ? edgeBoxes(points.doubles() + first, row, layer, size)
	                                         : edgeBoxes(points.floats() + first, row, layer, size);
	return turnOfEdges(u, v, w);
}

void settleBrick(const CurvilinearGrid& grid, const std::array<std::uint32_t, 3>& lo, Turns& turns)
{
	std::array<std::uint32_t, 3> size;
	for (int axis = 0; axis < 3; ++axis)
		size[axis] = std::min(kBrick[axis], grid.cells()[axis] - lo[axis]);
	const Turn turn = turnOfBrick(grid, lo, size);
	for (std::uint32_t k = 0; k < size[2]; ++k)
		for (std::uint32_t j = 0; j < size[1]; ++j)
		{
			const CellId first = grid.cell(lo[0], lo[1] + j, lo[2] + k);
			if (turn != Turn::mixed)
			{
				std::fill_n(&turns[first], size[0], turn);
				continue;
			}
			for (std::uint32_t i = 0; i < size[0]; ++i)
				turns[first + i] = turnOfCell(grid, first + i);
		}
}

// Each axis runs one way.
bool isSteady(const RectilinearGrid& grid)
{
	for (int axis = 0; axis < 3; ++axis)
		for (std::uint32_t i = 1; i < grid.points()[axis]; ++i)
		{
			const double step = grid.coordinate(axis, i) - grid.coordinate(axis, i - 1);
			if (!(step * (grid.coordinate(axis, 1) - grid.coordinate(axis, 0)) > 0.0))
				return false;
		}
	return true;
}

// Returns true if one of two cells of table shapes lies on each side of the face that they share: face f of `cell`.
// Returns false if their faces do not have the same points. A cell's faces run counter-clockwise seen from outside if
// it is turned positively, and clockwise otherwise. So on opposite sides of a face two cells that are turned alike run
// around it in opposite senses, and two cells that are turned otherwise in the same sense.
bool lieOnOppositeSides(const UnstructuredGrid& grid, const Turns& turns, CellId cell, int f, CellId other)
{
	if (turns[other] == Turn::mixed || grid.shape(other) == CellShape::polyhedron)
		return false;
	const CellPoints points = grid.cellPoints(cell);
	const auto corners = topology(grid.shape(cell)).facePoints(f);
	const CellPoints other_points = grid.cellPoints(other);
	const ShapeTopology& shape = topology(grid.shape(other));
	const auto has = [&](std::span<const std::uint8_t> face, PointId point)
	{ return std::ranges::any_of(face, [&](std::uint8_t v) { return other_points.id[v] == point; }); };
	for (int g = 0; g < shape.faces; ++g)
	{
		const auto face = shape.facePoints(g);
		if (face.size() != corners.size() ||
		    !std::ranges::all_of(corners, [&](std::uint8_t v) { return has(face, points.id[v]); }))
			continue;
		// Around the other's face, what follows the first point: the second point, or what comes before the first?
		const PointId first = points.id[corners[0]];
		const PointId second = points.id[corners[1]];
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const PointId a = other_points.id[face[i]];
			const PointId b = other_points.id[face[(i + 1) % face.size()]];
			if (first != second && ((a == first && b == second) || (a == second && b == first)))
				return (a == first) == (turns[cell] != turns[other]);
		}
	}
	return false;
}

// Returns true if a cell of a table shape is turned one way, and lies across from the neighbors of all its faces.
bool isSoundAmongNeighbors(const UnstructuredGrid& grid, const Turns& turns, CellId cell)
{
	if (turns[cell] == Turn::mixed)
		return false;
	bool sound = true;
	for (int f = 0; f < grid.faceCount(cell); ++f)
	{
		int across = 0;
		grid.forEachNeighbor(cell, f,
		                     [&](CellId other)
		                     { sound = sound && ++across == 1 && lieOnOppositeSides(grid, turns, cell, f, other); });
	}
	return sound;
}

// Sees how the polyhedra of a grid lie among their neighbors.
class PolyhedronTurns
{
public:
	explicit PolyhedronTurns(const UnstructuredGrid& grid) : grid_(grid), centers_(grid.cellCount())
	{
		parallelFor(tbb::blocked_range<std::size_t>(0, centers_.size(), 1024),
		            [&](const auto& range)
		            {
			            for (std::size_t c = range.begin(); c < range.end(); ++c)
				            centers_[c] = cellCenter(grid_, static_cast<CellId>(c));
		            });
	}

	// Scratch of one thread.
	struct Work
	{
		CellFaces faces;
		CellFaces alike; // all run one way seen from inside
		std::vector<Vec3> points;
		std::vector<PointId> reversed;
	};

	bool isSound(CellId cell, Work& work) const
	{
		grid_.cellFaces(cell, work.faces);
		work.alike.clear();
		for (int f = 0; f < work.faces.size(); ++f)
		{
			const Turn turn = turnOfFace(work.faces[f], centers_[cell], work.points);
			if (turn == Turn::mixed)
				return false;
			const Turn across = turn == Turn::positive ? Turn::negative : Turn::positive;
			bool apart = true;
			grid_.forEachNeighbor(cell, f,
			                      [&](CellId n)
			                      { apart = apart && turnOfFace(work.faces[f], centers_[n], work.points) == across; });
			if (!apart)
				return false;
			work.reversed.assign(work.faces[f].begin(), work.faces[f].end());
			if (turn == Turn::negative)
				std::ranges::reverse(work.reversed);
			work.alike.add(work.reversed);
		}
		return orientedAlike(work.alike);
	}

private:
	// Which way a face runs, seen from `inside`: alike for the whole of it.
	Turn turnOfFace(std::span<const PointId> face, const Vec3& inside, std::vector<Vec3>& points) const
	{
		if (face.size() < 3)
			return Turn::mixed;
		points.clear();
		Vec3 mean(0.0);
		for (const PointId p : face)
		{
			points.push_back(grid_.point(p));
			mean += points.back() / static_cast<double>(face.size());
		}
		if (face.size() <= 4)
		{
			points.push_back(inside);
			return turnOf(face.size() == 3 ? CellShape::tetrahedron : CellShape::pyramid, points);
		}
		int sum = 0;
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const Vec3 part[] = {mean, points[i], points[(i + 1) % face.size()], inside};
			sum += static_cast<int>(turnOf(CellShape::tetrahedron, part));
		}
		const int all = static_cast<int>(face.size());
		return sum == all ? Turn::positive : sum == -all ? Turn::negative : Turn::mixed;
	}

	const UnstructuredGrid& grid_;
	std::vector<Vec3> centers_;
};

} // namespace

std::vector<CellId> foldedCells(const UniformGrid&)
{
	return {}; // boxes
}

std::vector<CellId> foldedCells(const RectilinearGrid& grid)
{
	if (isSteady(grid))
		return {};
	Turns turns(grid.cellCount());
	for (std::size_t c = 0; c < grid.cellCount(); ++c)
		turns[c] = turnOfCell(grid, static_cast<CellId>(c));
	return turns.minority();
}

std::vector<CellId> foldedCells(const CurvilinearGrid& grid)
{
	const auto bricks = [&](int axis) { return (grid.cells()[axis] + kBrick[axis] - 1) / kBrick[axis]; };
	Turns turns(grid.cellCount());
	parallelFor(
	    std::uint32_t(0), bricks(1) * bricks(2),
	    [&](std::uint32_t row)
	    {
		    for (std::uint32_t i = 0; i < bricks(0); ++i)
			    settleBrick(grid, {i * kBrick[0], row % bricks(1) * kBrick[1], row / bricks(1) * kBrick[2]}, turns);
	    });
	return turns.minority();
}

std::vector<CellId> foldedCells(const UnstructuredGrid& grid)
{
	Turns turns(grid.cellCount());
	readRecords(grid,
	            [&](const auto& reader)
	            {
		            parallelFor(tbb::blocked_range<std::size_t>(0, grid.cellCount(), 4096),
		                        [&](const auto& range)
		                        {
			                        for (std::size_t c = range.begin(); c < range.end(); ++c)
				                        turns[c] = turnOfRecord(reader, static_cast<CellId>(c), grid.hasCrowds());
		                        });
	            });
	std::vector<CellId> cells = turns.minority();
	const auto isPolyhedron = [&](CellId c) { return grid.shape(c) == CellShape::polyhedron; };
	std::optional<PolyhedronTurns> polyhedra;
	if (std::ranges::any_of(cells, isPolyhedron))
		polyhedra.emplace(grid);
	std::vector<std::uint8_t> sound(cells.size(), 0);
	parallelFor(tbb::blocked_range<std::size_t>(0, cells.size(), 256),
	            [&](const auto& range)
	            {
		            PolyhedronTurns::Work work;
		            for (std::size_t i = range.begin(); i < range.end(); ++i)
			            sound[i] = isPolyhedron(cells[i]) ? polyhedra->isSound(cells[i], work)
			                                              : isSoundAmongNeighbors(grid, turns, cells[i]);
	            });
	std::size_t kept = 0;
	for (std::size_t i = 0; i < cells.size(); ++i)
		if (!sound[i])
			cells[kept++] = cells[i];
	cells.resize(kept);
	cells.shrink_to_fit();
	return cells;
}

} // namespace vp::grid
