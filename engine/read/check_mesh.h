#pragma once

#include "grid/patches.h"
#include "grid/points.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

namespace vp::read
{

// The reason why data cannot be used. Only the checks throw and catch it.
class Unusable : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

// Cutting multiplies up to six lengths for areas, volumes and their ratios. Above this limit they might overflow. The
// comparison also rejects NaN.
constexpr double kMaxCoordinate = 1e50;
inline bool isPlace(double coordinate)
{
	return std::abs(coordinate) <= kMaxCoordinate;
}

// These throw Unusable. The sizes of the arrays are checked already; their contents are not trusted.
void checkAxis(const Array<double>& axis);
// may_be_curved: cells may be those of grid::CurvedCells. Returns whether some are curved. Where has_checked_ids is
// false, and the cells are alike and not curved, ids are left to the first pass over the cells.
bool checkCells(grid::CellList& cells, std::size_t points, bool may_be_curved = false);
// Checks that the cells can be those of a lattice, where hidden cells are empty.
void checkLattice(const grid::Lattice& lattice, std::size_t points, const grid::CellList& cells);
void checkPolygons(const grid::PatchPolygons& polygons);
// Returns true if the faces can be those of a polyhedron. stream: as in grid::CellList, to its end.
bool isPolyhedron(std::span<const std::int64_t> stream, std::size_t points);
void checkSourceCells(const Array<std::int64_t>& source_cells, std::size_t count);

} // namespace vp::read
