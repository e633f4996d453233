#pragma once

#include <imgui/imgui.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace vp::app
{

// A small picture of a built-in data set: its box, and three sheets through its middle. Coordinates are 0 to 1, y down.
struct DemoPicture
{
	struct Polygon
	{
		std::uint32_t first; // index of its first corner
		std::uint32_t count;
	};
	std::vector<std::array<ImVec2, 2>> box;
	std::vector<ImVec2> corners;
	std::vector<ImU32> colors;
	std::vector<Polygon> polygons; // the farthest first

	void draw(ImDrawList& list, const ImVec2& lo, const ImVec2& size) const;
};

// Cuts a small data set of that kind, which takes some milliseconds. Returns an empty picture if it cannot be cut.
DemoPicture makeDemoPicture(std::string_view name);

} // namespace vp::app
