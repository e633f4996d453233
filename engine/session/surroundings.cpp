#include "session/surroundings.h"

#include "render/scene/farthest_points.h"
#include "session/share.h"

#include <algorithm>
#include <map>

namespace vp::session
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
std::vector<T> ofAllRanks(const Session& session, const OfBlock& of_block)
{
	MessageWriter message;
	const Share& share = *session.share;
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
		message.putAll(of_block(session.blocks.blocks[b]));
	std::vector<T> all;
	for (const Bytes& bytes : session.team->gatherAll(message.take()))
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			const auto some = reader.getAll<T>();
			all.insert(all.end(), some.begin(), some.end());
		}
	return all;
}

/// Of the blocks that one process would have: pieces of one grid have one box.
std::vector<render::Segment> boxOutlines(const Session& session)
{
	std::map<std::uint32_t, grid::Block> wholes;
	for (std::size_t b = 0; b < session.blocks.blocks.size(); ++b)
		if (!isCurvilinear(session.blocks.blocks[b]))
			wholes[session.share->whole[b]].bounds.include(session.blocks.blocks[b].bounds);
	std::vector<render::Segment> segments;
	for (auto& [number, block] : wholes)
	{
		const auto box = render::outlineOf(alone(std::move(block)), render::Outline::box);
		segments.insert(segments.end(), box.begin(), box.end());
	}
	return segments;
}

/// The farthest points of all unstructured blocks among those of each rank.
std::vector<Vec3> farthestOfAll(const Session& session)
{
	grid::Block joined;
	for (const grid::Block& block : session.blocks.blocks)
		if (isUnstructured(block))
			joined.bounds.include(block.bounds);
	MessageWriter message;
	message.putAll(render::farthestPoints(session.blocks));
	std::vector<double> coordinates;
	for (const Bytes& bytes : session.team->gatherAll(message.take()))
		for (const Vec3& point : MessageReader(bytes).getAll<Vec3>())
			coordinates.insert(coordinates.end(), {point.x, point.y, point.z});
	joined.grid = grid::UnstructuredGrid::listed(grid::Points(Array<double>(std::move(coordinates))), {});
	return render::farthestPoints(alone(std::move(joined)));
}

} // namespace

Surroundings surroundingsOf(const Session& session, render::Outline outline)
{
	if (!session.team)
		return {render::outlineOf(session.blocks, outline), render::extentOf(session.blocks)};
	Surroundings around;
	if (outline == render::Outline::box)
	{
		around.outline = boxOutlines(session);
		const auto curved =
		    ofAllRanks<render::Segment>(session,
		                                [](const grid::Block& block)
		                                {
			                                return isCurvilinear(block)
			                                           ? render::outlineOf(alone(block), render::Outline::box)
			                                           : std::vector<render::Segment>();
		                                });
		around.outline.insert(around.outline.end(), curved.begin(), curved.end());
	}
	if (std::ranges::any_of(session.blocks.blocks, isUnstructured))
		around.extent = farthestOfAll(session);
	const auto structured =
	    ofAllRanks<Vec3>(session, [](const grid::Block& block)
	                     { return isUnstructured(block) ? std::vector<Vec3>() : render::extentOf(alone(block)); });
	around.extent.insert(around.extent.end(), structured.begin(), structured.end());
	return around;
}

} // namespace vp::session
