#pragma once

#include "base/ids.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace vp::mesh
{

// The value of a point field at a vertex: linear along the edge, from the lower point; of a categorical one the value
// at the nearer end, in the middle the lesser of the two. component may be grid::kMagnitude: the length of the
// interpolated tuple.
double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at);

// The same for any vertex of a mesh. fields: per block, null where a block lacks it; NaN then.
double vertexValue(const grid::BlockSet& blocks, const SheetMesh& mesh, std::size_t vertex,
                   std::span<const grid::Field* const> fields, int component);

/// Returns how large the numbers are that a vertex's value is interpolated from; 0 for names of categories, which are
/// equal or not.
double vertexScale(const grid::BlockSet& blocks, const SheetMesh& mesh, std::size_t vertex,
                   std::span<const grid::Field* const> fields, int component);

/// Returns true if two values are copies of one number, perhaps written in single precision, and interpolated at places
/// a rounding apart.
inline bool isSameValue(double a, double b, double scale)
{
	constexpr double kApart = 1e-5;
	return a == b || std::abs(a - b) <= kApart * scale || (std::isnan(a) && std::isnan(b));
}

// Returns vertexValue() of every vertex, computed on all cores. An array that does not jump at vertices that lie on
// each other at a seam (SheetMesh::seam_pairs) has one value at all of them, to the last bit.
RawVector<double> vertexValues(const grid::BlockSet& blocks, const SheetMesh& mesh,
                               std::span<const grid::Field* const> fields, int component);

// Returns the value of a cell array on each polygon; NaN where a block lacks it.
std::vector<double> polygonValues(const grid::BlockSet& blocks, const SheetMesh& mesh,
                                  std::span<const grid::Field* const> fields, int component);

double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell);

} // namespace vp::mesh
