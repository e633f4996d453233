#include "grid/block.h"
#include "grid/link/face_matcher.h"

#include <algorithm>
#include <tuple>

namespace vp::grid
{

namespace
{

// Returns how many faces lie on another.
std::size_t distinctFaces(const BlockSeams& seams)
{
	std::size_t count = 0;
	const std::span<const SeamLink> links = seams.all();
	for (std::size_t i = 0; i < links.size(); ++i)
		count += i == 0 || links[i].cell != links[i - 1].cell || links[i].face != links[i - 1].face;
	return count;
}

Interfaces matched(const BlockSet& set, const FacesOfBlocks& faces)
{
	Interfaces result;
	std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
	std::uint32_t block = 0;
	for (std::vector<SeamLink>& links : matchFaces(set, faces))
	{
		for (const SeamLink& link : links)
			if (std::tie(block, link.cell, link.face) < std::tie(link.block, link.other, link.other_face))
				pairs.emplace_back(block, link.block);
		result.blocks.emplace_back(std::move(links));
		const std::size_t seams = distinctFaces(result.blocks.back());
		result.seam_faces += seams;
		result.boundary_faces += faces[block].size() - seams;
		++block;
	}
	std::ranges::sort(pairs);
	for (const auto& [a, b] : pairs)
	{
		if (result.interfaces.empty() || result.interfaces.back().a != a || result.interfaces.back().b != b)
			result.interfaces.push_back({a, b, 0});
		++result.interfaces.back().faces;
	}
	return result;
}

} // namespace

void matchInterfaces(BlockSet& set)
{
	FacesOfBlocks faces;
	for (const Block& block : set.blocks)
		faces.emplace_back(block.boundary.faces);
	set.interfaces = matched(set, faces);
	set.matches_seams = true;
}

Interfaces interfacesAmong(const BlockSet& set, std::span<const std::vector<BoundaryIndex::Face>> faces)
{
	return matched(set, FacesOfBlocks(faces.begin(), faces.end()));
}

} // namespace vp::grid
