#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::grid
{

// The array that is shown, by name: a block set's blocks may hold their arrays in different places, or lack some.
struct FieldChoice
{
	std::string name;
	grid::Association association = grid::Association::point;
	int component = 0; // or grid::kMagnitude

	const grid::Field* in(const grid::Block& block) const; // null where the block lacks it
	std::vector<const grid::Field*> inEach(const grid::BlockSet& blocks) const;
	bool operator==(const FieldChoice&) const = default;
	std::string title(const grid::BlockSet& blocks) const; // "v magnitude", "v y", "s"
};

/// "magnitude", "x", "y", "z" or a number from 0, as a component's number or kMagnitude; none for another text.
std::optional<int> parseComponent(std::string_view text);
std::string componentText(int component);

/// array: "[point:|cell:]NAME"; empty takes the first point array, else the first cell array, else none. component:
/// none takes the magnitude of a vector. An array that no block has is an input error that lists those there are.
/// setting: what the error calls it.
Result<std::optional<FieldChoice>> chooseField(const grid::BlockSet& blocks, const std::string& array,
                                               std::optional<int> component = {}, const char* setting = "`array`");

// Range of the chosen values over all blocks, NaN left out.
std::pair<double, double> fieldRange(const grid::BlockSet& blocks, const FieldChoice& choice);

} // namespace vp::grid
