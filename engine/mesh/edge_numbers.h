#pragma once

#include "base/ids.h"
#include "base/raw_vector.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

// A cut edge by its points, the one on the positive side first: so cells about it agree without asking which is lower.
inline std::uint64_t edgeKey(PointId positive, PointId negative)
{
	return std::uint64_t(positive) << 32 | negative;
}
inline PointId positiveOf(std::uint64_t edge)
{
	return static_cast<PointId>(edge >> 32);
}
inline PointId negativeOf(std::uint64_t edge)
{
	return static_cast<PointId>(edge);
}
inline PointId lowerOf(std::uint64_t edge)
{
	return std::min(positiveOf(edge), negativeOf(edge));
}
inline PointId higherOf(std::uint64_t edge)
{
	return std::max(positiveOf(edge), negativeOf(edge));
}

struct NumberedEdges
{
	RawVector<std::uint64_t> edges;   // each edge once, in the order in which they are first met
	RawVector<std::uint32_t> numbers; // per edge that was asked for: its index in `edges`
};

// Numbers edges of a small part of a mesh. Open addressing over four-byte numbers, with the edges beside in their
// order: so little memory that it stays in a core's cache, with so much room that there is hardly a second place to
// look at, and no branch that depends on whether an edge is new.
inline NumberedEdges numberEdges(std::span<const std::uint64_t> asked)
{
	constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;
	constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ull; // Fibonacci hashing: 2^64 / golden ratio, upper bits
	std::vector<std::uint32_t> slots(std::bit_ceil(2 * asked.size() + 64), kEmpty);
	const int shift = 64 - std::countr_zero(slots.size());
	NumberedEdges found;
	found.edges.resize(asked.size() + 1);
	found.numbers.resize(asked.size());
	std::uint32_t* slot = slots.data();
	std::uint64_t* edges = found.edges.data();
	std::uint32_t count = 0;
	// The number in a slot, or the next one where it is empty. Bits in place of a choice: the compiler would branch.
	const auto numberIn = [&](std::size_t at)
	{
		const std::uint32_t mask = 0u - static_cast<std::uint32_t>(slot[at] < count);
		return count ^ ((count ^ slot[at]) & mask);
	};
	for (std::size_t i = 0; i < asked.size(); ++i)
	{
		const std::uint64_t edge = asked[i];
		std::size_t at = (edge * kGolden) >> shift;
		edges[count] = edge; // to stay, should it be new
		std::uint32_t number = numberIn(at);
		while (edges[number] != edge)
		{
			at = (at + 1) & (slots.size() - 1);
			number = numberIn(at);
		}
		slot[at] = number;
		found.numbers[i] = number;
		count += number == count;
	}
	found.edges.resize(count);
	return found;
}

} // namespace vp::mesh
