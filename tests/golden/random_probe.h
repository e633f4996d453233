#pragma once

#include "synthetic_scene.h"

#include "shared/slice_types.h"

#include <random>
#include <vector>

namespace vp::render::test
{

// A sheet as the test knows it, polygons and all.
struct KnownSheet
{
	SheetDrawing drawing; // without records
	std::vector<vp::shared::PolygonRecord> records;
};

// 2 to 16 sheets that cross each other at random, each with a window, a magnification and an opacity of its own, in
// convex polygons of 3 to 6 corners. One in four lies in the plane of the sheet before it.
std::vector<KnownSheet> randomProbe(std::mt19937& random);

// At a random place around the origin, far enough to see all of it.
Camera randomCamera(std::mt19937& random);

} // namespace vp::render::test
