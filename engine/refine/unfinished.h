#pragma once

#include <cstddef>
#include <cstdint>

namespace vp::refine
{

/// Cells that are shown as far as they were refined, since a tolerance would have made too many parts of them.
struct Unfinished
{
	std::size_t cells = 0;
	std::uint32_t first = 0; // the one with the lowest number, where there is any
	bool by_cut = false;     // that cell alone has few enough parts, but all cells of the cut have too many
};

} // namespace vp::refine
