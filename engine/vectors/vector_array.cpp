#include "vectors/vector_array.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace vp::vectors
{

namespace
{

// Point arrays first, each once.
std::vector<grid::FieldChoice> vectorArrays(const grid::BlockSet& blocks)
{
	std::vector<grid::FieldChoice> arrays;
	for (const grid::Association wanted : {grid::Association::point, grid::Association::cell})
		for (const grid::Block& block : blocks.blocks)
			for (const grid::Field& field : block.fields)
			{
				const grid::FieldChoice array{field.name, field.association, grid::kMagnitude};
				if (field.association == wanted && field.components == kVectorComponents &&
				    std::ranges::find(arrays, array) == arrays.end())
					arrays.push_back(array);
			}
	return arrays;
}

std::string unitsOf(const grid::BlockSet& blocks, const grid::FieldChoice& array)
{
	for (const grid::Block& block : blocks.blocks)
		if (const grid::Field* field = array.in(block))
			return field->units;
	return {};
}

// Returns the array that is the velocity by its name, else by its units, else the first.
const grid::FieldChoice& usualVelocity(const grid::BlockSet& blocks, const std::vector<grid::FieldChoice>& arrays)
{
	for (const char* name : {"Velocity", "U", "velocity", "v", "V", "vel"})
		if (const auto named = std::ranges::find(arrays, name, &grid::FieldChoice::name); named != arrays.end())
			return *named;
	for (const grid::FieldChoice& array : arrays)
		if (const std::string units = unitsOf(blocks, array); units == "m/s" || units == "m s-1" || units == "m s^-1")
			return array;
	return arrays.front();
}

std::string listed(const std::vector<grid::FieldChoice>& arrays)
{
	std::vector<std::string> names;
	for (const grid::FieldChoice& array : arrays)
		names.push_back(fmt::format("{}:{}", grid::associationName(array.association), array.name));
	return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

int componentsOf(const grid::BlockSet& blocks, const grid::FieldChoice& array)
{
	for (const grid::Block& block : blocks.blocks)
		if (const grid::Field* field = array.in(block))
			return field->components;
	return 0;
}

} // namespace

Result<grid::FieldChoice> chooseVectors(const grid::BlockSet& blocks, const std::string& array)
{
	const std::vector<grid::FieldChoice> arrays = vectorArrays(blocks);
	if (array.empty() && arrays.empty())
		return Error{ErrorKind::input, "`vectors`: the input has no array of three components"};
	if (array.empty())
		return usualVelocity(blocks, arrays);
	Result<std::optional<grid::FieldChoice>> chosen = grid::chooseField(blocks, array);
	if (!chosen)
		return Error{ErrorKind::input, fmt::format("`vector_array` {}: no such array; arrays of three components: {}",
		                                           array, listed(arrays))};
	grid::FieldChoice choice = **chosen;
	choice.component = grid::kMagnitude;
	if (std::ranges::find(arrays, choice) != arrays.end())
		return choice;
	const int components = componentsOf(blocks, choice);
	return Error{ErrorKind::input,
	             fmt::format("`vector_array` {}: has {} component{}, a vector has three; arrays of three: {}", array,
	                         components, components == 1 ? "" : "s", listed(arrays))};
}

} // namespace vp::vectors
