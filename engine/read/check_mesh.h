#pragma once

#include "grid/patches.h"
#include "grid/points.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <cmath>
#include <stdexcept>

namespace vp::read
{

// Why what was handed over cannot be used; stays within the checks.
class Unusable : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

// Cutting multiplies up to six lengths: areas, volumes, their ratios. Beyond this they might overflow. Written so that
// NaN is no place either.
constexpr double kMaxCoordinate = 1e50;
inline bool isPlace(double coordinate)
{
	return std::abs(coordinate) <= kMaxCoordinate;
}

// Throw Unusable. The arrays' sizes are what they say; their contents are not trusted.
void checkCoordinates(const grid::Points& points);
void checkAxis(const Array<double>& axis);
void checkCells(const grid::CellList& cells, std::size_t points);
// That the cells can be those of a lattice, hidden ones empty.
void checkLattice(const grid::Lattice& lattice, std::size_t points, const grid::CellList& cells);
void checkPolygons(const grid::PatchPolygons& polygons);
void checkSourceCells(const Array<std::int64_t>& source_cells, std::size_t count);

} // namespace vp::read
