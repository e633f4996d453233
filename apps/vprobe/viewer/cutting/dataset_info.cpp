#include "viewer/cutting/dataset_info.h"

#include "render/scene/outline.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

// Returns each array once, though many blocks have it. Arrays of points come first.
std::vector<DatasetInfo::Array> arraysOf(const grid::BlockSet& blocks)
{
	std::vector<DatasetInfo::Array> arrays;
	for (const grid::Association association : {grid::Association::point, grid::Association::cell})
		for (const grid::Block& block : blocks.blocks)
			for (const grid::Field& field : block.fields)
			{
				const std::string word = fmt::format("{}:{}", grid::associationName(association), field.name);
				if (field.association == association &&
				    std::ranges::find(arrays, word, &DatasetInfo::Array::word) == arrays.end())
					arrays.push_back({word, field.name, association, field.components});
			}
	return arrays;
}

} // namespace

DatasetInfo factsOf(const session::Session& session, const std::vector<std::string>& inputs)
{
	const grid::BlockSet& blocks = session.blocks();
	DatasetInfo facts;
	facts.inputs = inputs;
	facts.kind = blocks.kind();
	facts.cells = blocks.sourceCellCount();
	facts.points = blocks.sourcePointCount();
	facts.blocks = blocks.blocks.size();
	facts.bounds = blocks.bounds();
	facts.extent = render::extentOf(blocks);
	facts.arrays = arraysOf(blocks);
	facts.times = blocks.times;
	for (const grid::Patch& patch : blocks.patches)
		facts.patches.push_back(patch.name);
	facts.memory = grid::memoryOf(blocks);
	facts.device = session.device()->name();
	facts.classifier = session::classifierName(session);
	facts.structured = std::ranges::all_of(blocks.blocks, [](const grid::Block& block)
	                                       { return !std::holds_alternative<grid::UnstructuredGrid>(block.grid); });
	return facts;
}

} // namespace vp::app
