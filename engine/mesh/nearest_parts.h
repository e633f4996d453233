#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <span>
#include <vector>

namespace vp::mesh
{

/// A mesh whose polygons are parted where another point of their cell becomes the nearest one.
struct NearestParts
{
	SheetMesh mesh;             // each part has the cell of its polygon; SheetMesh::is_inner marks sides between parts
	std::vector<double> values; // per polygon: the value of the nearest point
};

/// Parts the polygons of a mesh, on all cores. Each place belongs to the nearest point of its cell, or to the one with
/// the lesser value if two are as near. So on a lattice a point has its voxel, as far as that lies within the cells.
/// Points of one value make one part, and a polygon whose cell has one value stays as it is. Vertices on sides that
/// polygons shared are shared by their parts, too.
///
/// fields: a point array, per block, null where a block lacks it: the value is NaN there. component: from 0, or
/// grid::kMagnitude.
NearestParts nearestParts(const grid::BlockSet& blocks, const SheetMesh& mesh,
                          std::span<const grid::Field* const> fields, int component);

} // namespace vp::mesh
