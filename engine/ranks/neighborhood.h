#pragma once

#include "grid/block.h"
#include "ranks/team.h"

#include <span>
#include <vector>

namespace vp::ranks
{

/// The boxes of the blocks that each rank holds.
std::vector<Box> boxesOf(Team& team, const grid::BlockSet& blocks);

/// Those of the others that hold cells, grown for the rounding of places.
std::vector<Box> boxesOfOthers(const Team& team, const std::vector<Box>& boxes);

/// Returns true if a box touches one of the others.
bool touchesAny(const Box& box, std::span<const Box> others);

/// The ranks whose boxes touch that of this rank, once all have grown by a length. What ranks know of one place, they
/// bring together at its owner. So messages go between neighbors alone, however many ranks there are.
class Neighborhood
{
public:
	Neighborhood(Team& team, const std::vector<Box>& boxes, double grown);

	/// The lowest rank whose box holds the place: the same for all ranks whose boxes hold it.
	int ownerOf(const Vec3& place) const;
	MessageWriter& messageFor(const Vec3& place) { return messages_[static_cast<std::size_t>(ownerOf(place))]; }
	MessageWriter& messageFor(int rank) { return messages_[static_cast<std::size_t>(rank)]; }
	/// Sends all messages that have been written. Returns what came from each rank.
	std::vector<Bytes> exchange();
	const std::vector<int>& ranks() const { return with_; } // others; ascending

private:
	Team& team_;
	std::vector<Box> boxes_; // grown
	std::vector<int> with_;
	std::vector<int> near_; // the same, and this one
	std::vector<MessageWriter> messages_;
};

} // namespace vp::ranks
