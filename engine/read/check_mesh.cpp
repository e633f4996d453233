#include "read/check_mesh.h"

#include "base/parallel_reduce.h"
#include "grid/curved/curved_cells.h"
#include "read/cell_types.h"

#include <fmt/format.h>

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <type_traits>

namespace vp::read
{

namespace
{

constexpr std::size_t kNone = ~std::size_t(0);
constexpr std::size_t kGrain = 1 << 16;

// The first i below n for which bad(i) holds, on all cores; kNone where there is none. There mostly is none: so each
// range is passed over once without a way out, as the compiler makes it several numbers at a time, and searched only
// then.
template <class Bad>
std::size_t firstWhere(std::size_t n, Bad&& bad)
{
	return parallelReduce(
	    n, kGrain, kNone,
	    [&](const tbb::blocked_range<std::size_t>& range, std::size_t found)
	    {
		    if (found != kNone)
			    return found;
		    unsigned any = 0;
		    for (std::size_t i = range.begin(); i < range.end(); ++i)
			    any |= static_cast<unsigned>(bad(i));
		    if (any)
			    for (found = range.begin(); !bad(found);)
				    ++found;
		    return found;
	    },
	    [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

void checkOffsets(const Array<std::int64_t>& offsets, std::size_t end, const char* what)
{
	if (offsets.empty())
		throw Unusable(fmt::format("there are no {} offsets", what));
	if (offsets[0] != 0 || offsets[offsets.size() - 1] != static_cast<std::int64_t>(end))
		throw Unusable(fmt::format("the {} offsets do not match what they point into", what));
	const std::size_t falls =
	    firstWhere(offsets.size() - 1, [at = offsets.data()](std::size_t c) { return at[c] > at[c + 1]; });
	if (falls != kNone)
		throw Unusable(fmt::format("the {} offsets fall at cell {}", what, falls));
}

} // namespace

bool isPolyhedron(std::span<const std::int64_t> stream, std::size_t points)
{
	// A closed body has four faces at least, of three points at least.
	if (stream.empty() || stream[0] < 4 || stream[0] > static_cast<std::int64_t>(stream.size()))
		return false;
	std::size_t at = 1;
	for (std::int64_t face = 0; face < stream[0]; ++face)
	{
		if (at >= stream.size() || stream[at] < 3 || stream[at] > static_cast<std::int64_t>(stream.size() - at - 1))
			return false;
		const std::size_t end = at + 1 + static_cast<std::size_t>(stream[at]);
		for (++at; at < end; ++at)
			if (static_cast<std::uint64_t>(stream[at]) >= points)
				return false;
	}
	return at == stream.size();
}

void checkAxis(const Array<double>& axis)
{
	const auto bad = firstWhere(axis.size(), [&](std::size_t i) { return !isPlace(axis[i]); });
	if (bad != kNone)
		throw Unusable(fmt::format("coordinate {} of an axis is {}", bad,
		                           std::isfinite(axis[bad]) ? "larger than 1e50" : "not a finite number"));
	const auto values = axis.span();
	if (!std::is_sorted(values.begin(), values.end()) && !std::is_sorted(values.rbegin(), values.rend()))
		throw Unusable("the coordinates of an axis neither rise nor fall throughout");
}

namespace
{

// That lists without offsets are what these would say: cells of one type, one after the other.
void checkAlike(const grid::CellList& cells)
{
	const std::uint8_t type = cells.types[0];
	const auto wanted = static_cast<std::size_t>(slicedCellSize(type));
	if (wanted == 0 || cells.connectivity.size() / wanted != cells.size() || cells.connectivity.size() % wanted != 0)
		throw Unusable(
		    fmt::format("{} cells of type {} list {} points", cells.size(), type, cells.connectivity.size()));
	if (const std::size_t bad =
	        firstWhere(cells.size(), [types = cells.types.data(), type](std::size_t c) { return types[c] != type; });
	    bad != kNone)
		throw Unusable(fmt::format("cell {} of type {} lists no points", bad, cells.types[bad]));
}

// Returns true if all cells are of one type, and the offsets are those of so many points each. sizes: as below.
bool areAlike(const grid::CellList& cells, const std::array<int, 256>& sizes)
{
	const std::uint8_t* types = cells.types.data();
	const std::int64_t* offsets = cells.offsets.data();
	const std::int64_t size = sizes[types[0]];
	if (size <= 0 || offsets[0] != 0)
		return false;
	const auto alikeIn = [=, type = types[0]](const tbb::blocked_range<std::size_t>& range, bool so_far)
	{
		unsigned other_types = 0;
		for (std::size_t c = range.begin(); c < range.end(); ++c)
			other_types |= types[c] ^ type;
		std::int64_t others = 0;
		for (std::size_t c = range.begin(); c < range.end(); ++c)
			others |= (offsets[c + 1] - offsets[c]) ^ size;
		return so_far && other_types == 0 && others == 0;
	};
	return cells.connectivity.size() == cells.types.size() * static_cast<std::size_t>(size) &&
	       parallelReduce(cells.types.size(), kGrain, true, alikeIn, std::logical_and<>());
}

struct Types
{
	bool alike = false; // all of one type with a table
	bool curved = false;
};

Types checkTypes(const grid::CellList& cells, bool may_be_curved)
{
	if (cells.offsets.empty() && !may_be_curved)
	{
		checkAlike(cells);
		return {true, false};
	}
	// Per type: how many points its cells list, 0 for any number, -1 where there may be no such cell.
	std::array<int, 256> sizes;
	for (std::size_t t = 0; t < sizes.size(); ++t)
	{
		const auto type = static_cast<std::uint8_t>(t);
		const int dimension = cellDimension(type);
		const bool may_be = canBeSliced(type) || (dimension >= 0 && dimension < 3);
		sizes[t] = may_be_curved && grid::isCurved(type) ? grid::fixedNodes(type) : may_be ? slicedCellSize(type) : -1;
	}
	const std::uint8_t* types = cells.types.data();
	if (!cells.offsets.empty() && areAlike(cells, sizes))
		return {true, grid::isCurved(types[0])};
	const bool curved =
	    may_be_curved && firstWhere(cells.size(), [=](std::size_t c) { return grid::isCurved(types[c]); }) != kNone;
	if (curved)
		sizes[kPolyhedron] = -1;
	checkOffsets(cells.offsets, cells.connectivity.size(), "cell");
	const auto bad_type = [&sizes, types, offsets = cells.offsets.data()](std::size_t c)
	{
		const int wanted = sizes[types[c]];
		return (wanted != 0) & (offsets[c + 1] - offsets[c] != wanted);
	};
	if (const std::size_t bad = firstWhere(cells.types.size(), bad_type); bad != kNone)
		throw Unusable(fmt::format("cell {} of type {} lists {} points", bad, cells.types[bad],
		                           cells.offsets[bad + 1] - cells.offsets[bad]));
	return {false, curved};
}

} // namespace

bool checkCells(grid::CellList& cells, std::size_t points, bool may_be_curved)
{
	const auto [alike, curved] = checkTypes(cells, may_be_curved);
	if (!cells.has_checked_ids && alike && !curved)
		return false;
	try
	{
		grid::checkIds(cells.connectivity, points);
	}
	catch (const grid::WrongPoint& wrong)
	{
		throw Unusable(wrong.what());
	}
	cells.has_checked_ids = true;
	if (alike && cells.face_offsets.empty())
		return curved;

	const auto is_polyhedron = [types = cells.types.data()](std::size_t c) { return types[c] == kPolyhedron; };
	if (cells.face_offsets.empty())
	{
		if (firstWhere(cells.types.size(), is_polyhedron) != kNone)
			throw Unusable("polyhedra without faces");
		return curved;
	}
	checkOffsets(cells.face_offsets, cells.face_stream.size(), "face");
	const auto bad_faces = [&](std::size_t c)
	{
		const auto begin = static_cast<std::size_t>(cells.face_offsets[c]);
		const auto end = static_cast<std::size_t>(cells.face_offsets[c + 1]);
		return is_polyhedron(c) && !isPolyhedron(cells.face_stream.span().subspan(begin, end - begin), points);
	};
	if (const std::size_t bad = firstWhere(cells.types.size(), bad_faces); bad != kNone)
		throw Unusable(fmt::format("the faces of polyhedron {} do not make sense", bad));
	return curved;
}

void checkLattice(const grid::Lattice& lattice, std::size_t points, const grid::CellList& cells)
{
	if (lattice.pointCount() != points || lattice.cellCount() != cells.types.size() || !cells.source_cells.empty())
		throw Unusable("a lattice has another number of points or cells than it should");
	const auto foreign = [&](std::size_t c) { return cells.types[c] != kEmptyCell && cells.types[c] != kHexahedron; };
	if (const std::size_t bad = firstWhere(cells.types.size(), foreign); bad != kNone)
		throw Unusable(fmt::format("cell {} of a lattice is no hexahedron", bad));
}

void checkPolygons(const grid::PatchPolygons& polygons)
{
	if (polygons.starts.size() < 1)
		throw Unusable("a patch without offsets");
	checkOffsets(polygons.starts, polygons.corners.size(), "patch");
	const auto outside = [&](std::size_t i)
	{ return static_cast<std::uint64_t>(polygons.corners[i]) >= polygons.points.size(); };
	if (firstWhere(polygons.corners.size(), outside) != kNone)
		throw Unusable(fmt::format("the patch {} names points that it does not have", polygons.name));
}

void checkSourceCells(const Array<std::int64_t>& source_cells, std::size_t count)
{
	const auto outside = [&](std::size_t c) { return static_cast<std::uint64_t>(source_cells[c]) >= count; };
	if (const std::size_t bad = firstWhere(source_cells.size(), outside); bad != kNone)
		throw Unusable(fmt::format("cell {} is part of cell {} of {}", bad, source_cells[bad], count));
}

} // namespace vp::read
