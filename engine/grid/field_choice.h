#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::grid
{

// The array that is shown. It is known by its name, since the blocks of a set may hold their arrays in different
// orders, or lack some.
struct FieldChoice
{
	std::string name;
	grid::Association association = grid::Association::point;
	int component = 0; // or grid::kMagnitude

	const grid::Field* in(const grid::Block& block) const; // null if the block does not have it
	std::vector<const grid::Field*> inEach(const grid::BlockSet& blocks) const;
	bool operator==(const FieldChoice&) const = default;
	std::string title(const grid::BlockSet& blocks) const; // "v magnitude", "v y", "s"
};

/// Returns true if a block holds the array and marks it as one that names categories (Field::categorical).
bool isCategorical(const BlockSet& blocks, const std::optional<FieldChoice>& field);

/// Returns the component that a text names: "magnitude", "x", "y", "z", a number from 0, or "xx", "xy" and so on, which
/// are numbers below kMagnitude until chooseField() knows the array. Returns nothing for any other text.
std::optional<int> parseComponent(std::string_view text);
std::string componentText(int component);

/// Returns the name of a component of an array: "x" of a vector, "xy" of a tensor of six (xx yy zz xy yz xz) or nine
/// components, else its number.
std::string componentName(int component, int components);

/// Returns the array with the given name. array: "[point:|cell:]NAME". An empty name means the first point array, else
/// the first cell array, else none. component: nothing means the magnitude of a vector. If no block has the array,
/// returns an input error that lists the arrays. setting: the name of the setting in the error.
Result<std::optional<FieldChoice>> chooseField(const grid::BlockSet& blocks, const std::string& array,
                                               std::optional<int> component = {}, const char* setting = "`array`");

// Returns the range of the chosen values over all blocks. NaN is ignored.
std::pair<double, double> fieldRange(const grid::BlockSet& blocks, const FieldChoice& choice);

} // namespace vp::grid
