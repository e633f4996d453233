#pragma once

#include "base/union_find.h"
#include "grid/block.h"
#include "mesh/seam_values.h"
#include "mesh/seam_vertices.h"
#include "mesh/sheet_mesh.h"

#include <span>

namespace vp::mesh
{

// Says what happens to a vertex at which a cell meets several smaller ones. The larger cell's value there is linear
// along its polygon.
enum class Hanging
{
	keep,       // each side keeps its values: where they differ, there are two vertices
	interpolate // one vertex, with the larger cell's value, so that both sides are one smooth picture
};

// Gives the larger cells' polygons corners where hanging vertices lie on their sides, so that polygons meet in whole
// sides. That is the hanging vertex itself if it lies on the side and, to keep, all arrays agree. Else it is another
// vertex, on the side and with the larger cell's values, and mesh.seam_pairs tells that it belongs to the hanging one.
// vertices: those at ends of a side are left alone; they are named as the polygons name them. joined: vertices that are
// one, by which the caller names them afterwards.
void linkHanging(std::span<const HangingVertex> vertices, Hanging hanging, SeamValues& values, UnionFind& joined,
                 SheetMesh& mesh);

// Then gives hanging vertices the values of the larger cells. The polygons name what stands for joined vertices.
void interpolateHanging(const grid::BlockSet& blocks, std::span<const HangingVertex> vertices, UnionFind& joined,
                        SheetMesh& mesh);

} // namespace vp::mesh
