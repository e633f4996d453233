#pragma once

#include "vprobe-read/boxes/amr_cover.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

// The header of a plot file of AMReX or BoxLib, a folder.
struct AmrexPlot
{
	std::vector<std::string> names; // names of components
	double time = 0.0;
	std::array<double, 3> lo{};                     // the least corner of the domain
	std::vector<std::array<double, 3>> sizes;       // the sizes of a level's cells
	std::vector<std::array<std::int64_t, 3>> first; // the first cell of a level's domain, at `lo`
	std::vector<std::string> folders;               // folders of levels, with the start of their files' names
	bool is_cartesian = true;
	boxes::AmrLevels levels; // boxes without files
};

// Where the values of a level's boxes are.
struct AmrexBoxData
{
	std::array<std::int64_t, 3> lo, hi;
	std::string file;
	std::uint64_t offset;
};

// Throws a Refusal for a plot of fewer than three dimensions.
AmrexPlot parseAmrexHeader(std::string_view text);
std::vector<AmrexBoxData> parseAmrexLevel(std::string_view text);

// The values of one component of a box, as a file has them from an offset on: those of the box alone.
std::vector<double> amrexValues(std::string_view file, const AmrexBoxData& box, std::size_t components,
                                std::size_t component);

} // namespace vp::reader::codes
