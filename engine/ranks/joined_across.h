#pragma once

#include "ranks/team.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::ranks
{

/// Things of two ranks that hang together, such as pieces of a mesh, each by its number at its rank.
struct Link
{
	int rank;
	std::uint32_t number;
	int other;
	std::uint32_t other_number;

	auto operator<=>(const Link&) const = default;
};

/// The connected components of the items of all ranks.
struct JoinedAcross
{
	std::size_t count = 0;             // number of components
	std::vector<std::uint8_t> marks{}; // per own item: the bits of all items in its component
};

/// own: the bits of this rank's things. links: those that this rank knows; others may know the same.
JoinedAcross joinOverRanks(Team& team, std::span<const std::uint8_t> own, std::vector<Link> links);

} // namespace vp::ranks
