#pragma once

#include "known_surface.h"

#include <vector>

namespace vp::render::test
{

// What a picture should be, found without a GPU: every polygon is rasterized in double into a list at each pixel, lists
// are sorted by depth (sheets in one plane by their number, a surface in a sheet's plane behind it) and blended over
// white.
struct PixelList
{
	Rgb color{};
	std::size_t fragments = 0; // of sheets and surfaces, at the pixel's center
	bool on_edge = false; // an edge of a polygon or a window, or a crossing of two of them, is too near to tell sides
};
std::vector<PixelList> blendedLists(const Scene& scene, const std::vector<KnownSheet>& sheets,
                                    const std::vector<KnownSurface>& surfaces = {});

struct ListComparison
{
	std::size_t pixels = 0;
	std::size_t several = 0;  // with more than one fragment
	std::size_t edges = 0;    // that are on an edge
	std::size_t edge_off = 0; // of those, by more than the tolerance
	double worst = 0.0;       // of the others, of a channel
};
constexpr double kBlendTolerance = 2.0; // of 255
ListComparison compareLists(const std::vector<PixelList>& lists, const Picture& picture);

} // namespace vp::render::test
