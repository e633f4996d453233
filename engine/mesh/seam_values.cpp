#include "mesh/seam_values.h"

#include "mesh/mesh_values.h"

#include <algorithm>

namespace vp::mesh
{

namespace
{

bool isPointField(const grid::Field& field)
{
	return field.association == grid::Association::point;
}

} // namespace

SeamValues::SeamValues(const grid::BlockSet& blocks, const SheetMesh& mesh)
    : blocks_(blocks), mesh_(mesh), in_each_(blocks.blocks.size())
{
	for (const grid::Block& block : blocks.blocks)
		arrays_.push_back(static_cast<std::size_t>(std::ranges::count_if(block.fields, isPointField)));
}

std::uint32_t SeamValues::blockOf(std::uint32_t vertex) const
{
	return vertex < mesh_.edges.size() ? mesh_.edges[vertex].block : mesh_.rimShares(vertex)[0].block;
}

const grid::Field* SeamValues::likeOf(const grid::Field& field, std::uint32_t block) const
{
	const std::vector<grid::Field>& fields = blocks_.blocks[block].fields;
	const auto found = std::ranges::find_if(
	    fields, [&](const grid::Field& other)
	    { return isPointField(other) && other.name == field.name && other.components == field.components; });
	return found == fields.end() ? nullptr : &*found;
}

bool SeamValues::haveSameArrays(std::uint32_t v, std::uint32_t w) const
{
	const std::uint32_t other = blockOf(w);
	return arrays_[blockOf(v)] == arrays_[other] &&
	       std::ranges::all_of(blocks_.blocks[blockOf(v)].fields, [&](const grid::Field& field)
	                           { return !isPointField(field) || likeOf(field, other) != nullptr; });
}

bool SeamValues::agree(std::uint32_t v, std::uint32_t w)
{
	const std::uint32_t block = blockOf(v);
	const std::uint32_t other = blockOf(w);
	if (arrays_[block] != arrays_[other])
		return false;
	for (const grid::Field& field : blocks_.blocks[block].fields)
	{
		if (!isPointField(field))
			continue;
		const grid::Field* like = block == other ? &field : likeOf(field, other);
		if (!like)
			return false;
		in_each_[block] = &field;
		in_each_[other] = like;
		for (int c = 0; c < field.components; ++c)
		{
			const double a = vertexValue(blocks_, mesh_, v, in_each_, c);
			const double b = vertexValue(blocks_, mesh_, w, in_each_, c);
			if (a != b && !isSameValue(a, b,
			                           std::max(vertexScale(blocks_, mesh_, v, in_each_, c),
			                                    vertexScale(blocks_, mesh_, w, in_each_, c))))
				return false;
		}
	}
	return true;
}

} // namespace vp::mesh
