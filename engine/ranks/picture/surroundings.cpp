#include "ranks/picture/surroundings.h"

#include "ranks/data/share.h"
#include "ranks/join/boundary_edges.h"
#include "ranks/join/piece_outline.h"
#include "render/scene/farthest_points.h"

#include <algorithm>
#include <map>

namespace vp::ranks
{

namespace
{

bool isCurvilinear(const grid::Block& block)
{
	return std::holds_alternative<grid::CurvilinearGrid>(block.grid);
}

bool isUnstructured(const grid::Block& block)
{
	return std::holds_alternative<grid::UnstructuredGrid>(block.grid);
}

grid::BlockSet alone(grid::Block block)
{
	grid::BlockSet set;
	set.blocks.push_back(std::move(block));
	return set;
}

/// Lines or points of each block, from the rank that holds it, in the order of blocks.
template <class T, class OfBlock>
std::vector<T> ofAllRanks(const Ranks& ranks, const grid::BlockSet& blocks, const OfBlock& of_block)
{
	MessageWriter message;
	const Share& share = ranks.share();
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
		message.putAll(of_block(blocks.blocks[b]));
	std::vector<T> all;
	for (const Bytes& bytes : ranks.team()->gatherAll(message.take()))
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			const auto some = reader.getAll<T>();
			all.insert(all.end(), some.begin(), some.end());
		}
	return all;
}

/// Of the blocks that one process would have: pieces of one grid have one box.
std::vector<render::Segment> boxOutlines(const Ranks& ranks, const grid::BlockSet& blocks)
{
	std::map<std::uint32_t, grid::Block> wholes;
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		if (!isCurvilinear(blocks.blocks[b]))
			wholes[ranks.share().whole[b]].bounds.include(blocks.blocks[b].bounds);
	std::vector<render::Segment> segments;
	for (auto& [number, block] : wholes)
	{
		const auto box = render::outlineOf(alone(std::move(block)), render::Outline::box);
		segments.insert(segments.end(), box.begin(), box.end());
	}
	return segments;
}

/// Of all curvilinear grids, whose pieces may lie in several ranks.
std::vector<render::Segment> curvedOutlines(const Ranks& ranks, const grid::BlockSet& blocks)
{
	MessageWriter message;
	const Share& share = ranks.share();
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
		if (const auto* grid = std::get_if<grid::CurvilinearGrid>(&blocks.blocks[b].grid))
		{
			message.put(share.whole[b]);
			for (const std::vector<Vec3>& curve : render::edgeCurves(*grid))
				message.putAll(curve);
		}
	std::map<std::uint32_t, std::vector<render::EdgeCurves>> wholes;
	for (const Bytes& bytes : ranks.team()->gatherAll(message.take()))
		for (MessageReader reader(bytes); !reader.atEnd();)
			for (std::vector<Vec3>& curve : wholes[reader.get<std::uint32_t>()].emplace_back())
				curve = reader.getAll<Vec3>();
	std::vector<render::Segment> segments;
	for (const auto& [number, pieces] : wholes)
	{
		const std::vector<render::Segment> some = outlineOfPieces(pieces);
		segments.insert(segments.end(), some.begin(), some.end());
	}
	return segments;
}

/// A curvilinear grid without a list of its boundary is within its box: the pieces of one grid have one.
bool isWithinItsBox(const grid::Block& block)
{
	return isCurvilinear(block) && block.boundary.patches.empty();
}

void addCornersOfCurved(const Ranks& ranks, const grid::BlockSet& blocks, std::vector<Vec3>& points)
{
	MessageWriter message;
	const Share& share = ranks.share();
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
		if (isWithinItsBox(blocks.blocks[b]))
			message.put(share.whole[b]);
	std::map<std::uint32_t, Box> boxes;
	for (const Bytes& bytes : ranks.team()->gatherAll(message.take()))
		for (MessageReader reader(bytes); !reader.atEnd();)
			boxes[reader.get<std::uint32_t>()];
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		if (const auto box = boxes.find(share.whole[b]); box != boxes.end())
			box->second.include(blocks.blocks[b].bounds);
	for (const auto& [number, box] : boxes)
		for (int i = 0; i < 8 && !box.empty(); ++i)
			points.push_back(render::corner(box, i));
}

/// The farthest points of all unstructured blocks among those of each rank.
std::vector<Vec3> farthestOfAll(const Ranks& ranks, const grid::BlockSet& blocks)
{
	grid::Block joined;
	for (const grid::Block& block : blocks.blocks)
		if (isUnstructured(block))
			joined.bounds.include(block.bounds);
	MessageWriter message;
	message.putAll(render::farthestPoints(blocks));
	std::vector<double> coordinates;
	for (const Bytes& bytes : ranks.team()->gatherAll(message.take()))
		for (const Vec3& point : MessageReader(bytes).getAll<Vec3>())
			coordinates.insert(coordinates.end(), {point.x, point.y, point.z});
	joined.grid = grid::UnstructuredGrid::listed(grid::Points(Array<double>(std::move(coordinates))), {});
	return render::farthestPoints(alone(std::move(joined)));
}

} // namespace

Result<Surroundings> surroundingsOf(const Ranks& ranks, const grid::BlockSet& blocks, render::Outline outline)
{
	if (!ranks.team())
		return Surroundings{render::outlineOf(blocks, outline), render::extentOf(blocks)};
	Surroundings around;
	if (outline == render::Outline::box)
	{
		around.outline = boxOutlines(ranks, blocks);
		const std::vector<render::Segment> curved = curvedOutlines(ranks, blocks);
		around.outline.insert(around.outline.end(), curved.begin(), curved.end());
	}
	if (outline == render::Outline::edges)
	{
		Result<std::vector<render::Segment>> edges = boundaryEdgesOfAll(*ranks.team(), ranks.share(), blocks);
		if (!edges)
			return edges.error();
		around.outline = std::move(*edges);
	}
	if (std::ranges::any_of(blocks.blocks, isUnstructured))
		around.extent = farthestOfAll(ranks, blocks);
	const auto structured = ofAllRanks<Vec3>(ranks, blocks,
	                                         [](const grid::Block& block) {
		                                         return isUnstructured(block) || isWithinItsBox(block)
		                                                    ? std::vector<Vec3>()
		                                                    : render::extentOf(alone(block));
	                                         });
	around.extent.insert(around.extent.end(), structured.begin(), structured.end());
	addCornersOfCurved(ranks, blocks, around.extent);
	return around;
}

} // namespace vp::ranks
