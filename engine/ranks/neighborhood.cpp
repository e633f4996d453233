#include "ranks/neighborhood.h"

#include <algorithm>

namespace vp::ranks
{

namespace
{

bool touch(const Box& a, const Box& b)
{
	for (int axis = 0; axis < 3; ++axis)
		if (!(a.lo[axis] <= b.hi[axis] && b.lo[axis] <= a.hi[axis]))
			return false;
	return true;
}

bool holds(const Box& box, const Vec3& place)
{
	return touch(box, {place, place});
}

// Returns how far rounding may move a place out of the bounds of its cell.
double roundingOf(const std::vector<Box>& boxes)
{
	constexpr double kRounding = 1e-6;
	Box all;
	for (const Box& box : boxes)
		all.include(box);
	return kRounding * all.diagonal();
}

} // namespace

std::vector<Box> boxesOf(Team& team, const grid::BlockSet& blocks)
{
	Box own;
	for (const grid::Block& block : blocks.blocks)
		if (std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid) > 0) // others hold no cells here
			own.include(block.bounds);
	MessageWriter message;
	message.put(own);
	std::vector<Box> boxes;
	for (const Bytes& bytes : team.gatherAll(message.take()))
		boxes.push_back(MessageReader(bytes).get<Box>());
	return boxes;
}

std::vector<Box> boxesOfOthers(const Team& team, const std::vector<Box>& boxes)
{
	const double by = roundingOf(boxes);
	std::vector<Box> others;
	for (int rank = 0; rank < team.size(); ++rank)
		if (const Box& box = boxes[static_cast<std::size_t>(rank)]; rank != team.rank() && !box.empty())
			others.push_back({box.lo - by, box.hi + by});
	return others;
}

bool touchesAny(const Box& box, std::span<const Box> others)
{
	return std::ranges::any_of(others, [&](const Box& other) { return touch(box, other); });
}

Neighborhood::Neighborhood(Team& team, const std::vector<Box>& boxes, double grown)
    : team_(team), boxes_(boxes), messages_(boxes.size())
{
	const double by = grown + roundingOf(boxes);
	for (Box& box : boxes_)
	{
		box.lo -= by;
		box.hi += by;
	}
	const Box& own = boxes_[static_cast<std::size_t>(team.rank())];
	for (int rank = 0; rank < team.size(); ++rank)
	{
		if (rank != team.rank() && !touch(own, boxes_[static_cast<std::size_t>(rank)]))
			continue;
		near_.push_back(rank);
		if (rank != team.rank())
			with_.push_back(rank);
	}
}

int Neighborhood::ownerOf(const Vec3& place) const
{
	const auto found =
	    std::ranges::find_if(near_, [&](int rank) { return holds(boxes_[static_cast<std::size_t>(rank)], place); });
	return found == near_.end() ? team_.rank() : *found;
}

std::vector<Bytes> Neighborhood::exchange()
{
	std::vector<Bytes> bytes;
	for (MessageWriter& message : messages_)
	{
		bytes.push_back(message.take());
		message = {};
	}
	return team_.exchange(std::move(bytes), with_);
}

} // namespace vp::ranks
