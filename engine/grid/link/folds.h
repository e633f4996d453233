#pragma once

#include "base/ids.h"
#include "grid/structured.h"
#include "grid/unstructured.h"

#include <vector>

namespace vp::grid
{

// The cells at which a grid may be folded over, in ascending order: those that are not turned one way throughout (see
// turnOf()), and, among those that are not turned the way that most cells of the block are, those that lie on the same
// side of a face as the cell across. Files often number the points of some cells the other way round: such cells are
// turned otherwise, but nothing is folded there, and they are not listed. Only through such a cell can a plane's cut
// close within the block, where the boundary does not reach it:
//
// The cells' maps, glued at their faces, carry the cut's surface within them into the plane. A face is crossed only
// where its points' signs differ, so a piece whose cut faces all have a neighbor is a closed surface. Were all its
// cells turned one way (or numbered so that they are), the map would keep its sense everywhere, and be open (around a
// cut edge it may wind several times): the image of the closed surface would be open and compact, and the plane holds
// no such set but the empty one.
//
// Cells are taken to meet in whole faces, two at most on each, one on each side. Where three or more have a face, as
// where cells are given twice, two of them lie on the same side of it, and all are listed.
//
// Cells of an unstructured grid are compared with the cells across by the points of the shared face. Where these are
// not the same points, or several cells lie across, a cell that is turned otherwise is listed.
//
// A polyhedron is filled from its center (the mean of its points) by tetrahedra to its triangles, pyramids to its
// quads, and fans about the mean of larger faces. Since files list its faces either way round, it asks no majority: it
// is listed where it is not filled one way, or lies on the same side of a face as the cell across.
//
// One pass on all cores and a byte a cell while it runs; a curvilinear grid is settled in boxes of cells that are
// alike.
std::vector<CellId> foldedCells(const UniformGrid& grid);
std::vector<CellId> foldedCells(const RectilinearGrid& grid);
std::vector<CellId> foldedCells(const CurvilinearGrid& grid);
std::vector<CellId> foldedCells(const UnstructuredGrid& grid);

} // namespace vp::grid
