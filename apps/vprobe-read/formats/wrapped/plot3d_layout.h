#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vp::reader::wrapped
{

// How a PLOT3D grid file is laid out. Nothing in such a file says so: the layout is the one whose size fits the file's.
struct Plot3dLayout
{
	bool binary = true;
	bool little_endian = false;
	bool byte_counts = false; // Fortran's record lengths before and after each record
	bool multi_grid = false;  // starts with a number of blocks
	bool doubles = false;
	bool blanking = false;                            // an integer per point after the coordinates
	bool flat = false;                                // two coordinates per point
	std::vector<std::array<std::uint64_t, 3>> blocks; // points along each axis
};

// Throws a Refusal if no layout fits.
Plot3dLayout findPlot3dLayout(const std::string& file);

// Throws a Refusal if a binary q file is shorter than the solution on such a grid.
void refuseShortSolution(const std::string& solution, const Plot3dLayout& grid);

} // namespace vp::reader::wrapped
