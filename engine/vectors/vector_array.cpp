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
std::vector<slice::FieldChoice> vectorArrays(const grid::BlockSet& blocks)
{
	std::vector<slice::FieldChoice> arrays;
	for (const grid::Association wanted : {grid::Association::point, grid::Association::cell})
		for (const grid::Block& block : blocks.blocks)
			for (const grid::Field& field : block.fields)
			{
				const slice::FieldChoice array{field.name, field.association, grid::kMagnitude};
				if (field.association == wanted && field.components == kVectorComponents &&
				    std::ranges::find(arrays, array) == arrays.end())
					arrays.push_back(array);
			}
	return arrays;
}

std::string listed(const std::vector<slice::FieldChoice>& arrays)
{
	std::vector<std::string> names;
	for (const slice::FieldChoice& array : arrays)
		names.push_back(fmt::format("{}:{}", grid::associationName(array.association), array.name));
	return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

int componentsOf(const grid::BlockSet& blocks, const slice::FieldChoice& array)
{
	for (const grid::Block& block : blocks.blocks)
		if (const grid::Field* field = array.in(block))
			return field->components;
	return 0;
}

} // namespace

Result<slice::FieldChoice> chooseVectors(const grid::BlockSet& blocks, const std::string& array)
{
	const std::vector<slice::FieldChoice> arrays = vectorArrays(blocks);
	if (array.empty() && arrays.empty())
		return Error{ExitCode::input, "--vectors: the input has no array of three components"};
	if (array.empty())
		return arrays.front();
	Result<std::optional<slice::FieldChoice>> chosen = slice::chooseField(blocks, array, "");
	if (!chosen)
		return Error{ExitCode::input, fmt::format("--vector-array {}: no such array; arrays of three components: {}",
		                                          array, listed(arrays))};
	slice::FieldChoice choice = **chosen;
	choice.component = grid::kMagnitude;
	if (std::ranges::find(arrays, choice) != arrays.end())
		return choice;
	const int components = componentsOf(blocks, choice);
	return Error{ExitCode::input,
	             fmt::format("--vector-array {}: has {} component{}, a vector has three; arrays of three: {}", array,
	                         components, components == 1 ? "" : "s", listed(arrays))};
}

} // namespace vp::vectors
