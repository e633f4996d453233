#pragma once

#include "known_surface.h"

#include <vector>

namespace vp::render::test
{

// Computes a picture without a GPU: every polygon is rasterized in double precision into a list at each pixel, lists
// are sorted by depth (sheets in one plane by their number, a surface in a sheet's plane behind it) and blended over
// white.
struct PixelList
{
	Rgb color{};
	std::size_t fragments = 0; // fragments of sheets and surfaces at the pixel's center
	bool on_edge = false; // an edge of a polygon or a window, or a crossing of two of them, is too near to tell sides
};
// A place in the picture may be off by so much, in pixels, where corners are put on a grid of 1 / 2^bits.
constexpr double edgeReach(std::uint32_t bits)
{
	return 0.015 + 1.5 / static_cast<double>(1u << bits);
}
constexpr double kEdgeReach = edgeReach(8); // reach of the compute rasterizer

// edge_reach: pixels so near to an edge are on it.
std::vector<PixelList> blendedLists(const Scene& scene, const std::vector<KnownSheet>& sheets,
                                    const std::vector<KnownSurface>& surfaces = {}, double edge_reach = kEdgeReach);

struct ListComparison
{
	std::size_t pixels = 0;
	std::size_t several = 0;  // with more than one fragment
	std::size_t edges = 0;    // that are on an edge
	std::size_t edge_off = 0; // pixels on edges that differ by more than the tolerance
	double worst = 0.0;       // largest difference of a channel at the other pixels
};
constexpr double kBlendTolerance = 2.0; // in steps of 1 / 255
ListComparison compareLists(const std::vector<PixelList>& lists, const Picture& picture);

} // namespace vp::render::test
