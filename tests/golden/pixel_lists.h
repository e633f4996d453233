#pragma once

#include "synthetic_scene.h"

#include "shared/slice_types.h"

#include <glm/vec2.hpp>

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

// What a picture should be, found without a GPU: every polygon is rasterised in double into a list at each pixel, lists
// are sorted by depth (sheets in one plane by their number) and blended over white.
struct PixelList
{
	Rgb color{};
	std::size_t sheets = 0; // that are at the pixel's centre
	bool on_edge = false;   // an edge of a polygon or a window, or a crossing of two sheets, is too near to tell sides
};
std::vector<PixelList> blendedLists(const Scene& scene, const std::vector<KnownSheet>& sheets);

struct ListComparison
{
	std::size_t pixels = 0;
	std::size_t several = 0;  // with more than one sheet
	std::size_t edges = 0;    // that are on an edge
	std::size_t edge_off = 0; // of those, by more than the tolerance
	double worst = 0.0;       // of the others, of a channel
};
constexpr double kBlendTolerance = 2.0; // of 255
ListComparison compareLists(const std::vector<PixelList>& lists, const Picture& picture);

} // namespace vp::render::test
