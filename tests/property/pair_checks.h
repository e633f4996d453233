#pragma once

#include "random_sets.h"
#include "sliced_sheet.h"
#include "test_grids.h"

namespace vp::test
{

// A set, a plane and the cut, with what the checks below need to know.
struct Pair
{
	const RawSet& raw;
	const grid::BlockSet& set;
	TestPlane asked; // as the sheet is asked for
	TestPlane plane; // with the sheet's unit normal, to the last bit
	SlicedSheet sheet;
	// No point within rounding of the plane: every cut edge is cut at one place of its own.
	bool generic;
};

// Points closer than this to a plane may change sides by rounding of coordinates and of the distance.
double roundingOf(const grid::BlockSet& set, const TestPlane& plane);
bool isGeneric(const grid::BlockSet& set, const TestPlane& plane);

// Traversal, exhaustive scan and block tree find the same cells.
void checkCells(const Pair& pair);
// Finite vertices, on the plane and on their edge, with the linear field's value; polygons with area, facing the
// normal.
void checkVertices(const Pair& pair);
// Each cell's polygons have the area of its section, computed anew in long double.
void checkAreas(const Pair& pair);
// Every edge of the mesh belongs to two polygons that run along it in opposite directions, or to one on the boundary.
void checkWatertight(const Pair& pair);
// The other side of the normal, a shift by an ulp, a rigid motion, another order of cells and points.
void checkInvariance(const Pair& pair, unsigned seed);
// The fastest way to find cells makes the same mesh as the traversal, of the whole sheet or within a window.
void checkFinders(const Pair& pair, cut::Cutter& cutter, const std::optional<probe::Window>& window);

// Returns the area of all polygons, as vector areas along the sheet's normal.
double areaOf(const SlicedSheet& sheet);

} // namespace vp::test
