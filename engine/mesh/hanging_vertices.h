#pragma once

#include "grid/block.h"
#include "mesh/seam_vertices.h"
#include "mesh/sheet_mesh.h"
#include "mesh/union_find.h"

#include <span>

namespace vp::mesh
{

// Which value a vertex has where a cell meets several smaller ones. It is one vertex, so both sides have this value.
enum class Hanging
{
	keep,       // that of the smaller cell's points
	interpolate // linear along the larger cell's polygon
};

// Makes hanging vertices corners of the larger cells' polygons, which have no T-junctions then. `joined`: vertices that
// are one, among them the hanging ones at the ends of edges. The polygons name the vertices that stand for them.
void linkHanging(const grid::BlockSet& blocks, std::span<const HangingVertex> vertices, Hanging hanging,
                 UnionFind& joined, SheetMesh& mesh);

} // namespace vp::mesh
