#include "write/set_arrays.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::write
{

std::vector<SetArray> arraysOf(const grid::BlockSet& blocks, grid::Association association)
{
	std::vector<SetArray> sources;
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		for (const grid::Field& field : blocks.blocks[b].fields)
		{
			if (field.association != association)
				continue;
			auto source =
			    std::find_if(sources.begin(), sources.end(), [&](const SetArray& s) { return s.name == field.name; });
			if (source == sources.end())
			{
				source = sources.insert(source, {field.name, 0, field.type, field.categorical, {}});
				source->per_block.resize(blocks.blocks.size());
			}
			if (source->per_block[b])
				continue; // a second array of the name: the first is the one that --array finds
			source->per_block[b] = &field;
			source->components = std::max(source->components, field.components);
			source->categorical = source->categorical && field.categorical && source->type == field.type;
			if (source->type != field.type)
				source->type = grid::NumberType::float64;
		}
	return sources;
}

grid::NumberType interpolatedType(const SetArray& array)
{
	const grid::NumberType source = array.type;
	if (array.categorical)
		return source;
	const bool fits = source == grid::NumberType::float32 || grid::byteSize(source) <= 2;
	return fits ? grid::NumberType::float32 : grid::NumberType::float64;
}

std::string componentName(const std::string& name, int components, int component)
{
	if (components == 1)
		return name;
	if (components <= 3)
		return fmt::format("{}_{}", name, "xyz"[component]);
	return fmt::format("{}_{}", name, component);
}

} // namespace vp::write
