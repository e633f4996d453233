#pragma once

#include "base/ids.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace vp::grid
{

constexpr PointId kNoPoint = 0xFFFFFFFFu;

// The distinct points of a face, ascending; kNoPoint in what is left of the four places. Faces of more than four
// are compared apart.
struct FaceKey
{
	std::array<PointId, 4> ids{kNoPoint, kNoPoint, kNoPoint, kNoPoint};

	PointId lowest() const { return ids[0]; }
	bool hasArea() const { return ids[2] != kNoPoint; }
	bool operator==(const FaceKey& other) const
	{
		return ids[1] == other.ids[1] && ids[2] == other.ids[2] && ids[3] == other.ids[3] && ids[0] == other.ids[0];
	}
	// The lowest is left out: only faces that share it are compared.
	std::uint32_t hash() const { return ids[1] * 0x9E3779B1u ^ ids[2] * 0x85EBCA77u ^ ids[3] * 0xC2B2AE3Du; }
};

// Which comes first cannot be foreseen, so there is no branch.
inline void order(PointId& a, PointId& b)
{
	const PointId exchange = (a ^ b) & (0u - static_cast<PointId>(b < a));
	a ^= exchange;
	b ^= exchange;
}

// Returns the key of sorted points some of which are equal. This is rare, and a function of its own: it needs the key
// in memory, where it is written in four-byte pieces and read in eight-byte pieces, and processors wait a dozen cycles
// for that.
[[gnu::noinline]] inline FaceKey withoutRepeats(FaceKey key, int size)
{
	std::fill(std::unique(key.ids.begin(), key.ids.begin() + size), key.ids.end(), kNoPoint);
	return key;
}

// Returns the key of the points `corners` of a table shape, which are three or four.
inline FaceKey keyOf(const std::uint32_t* record, const std::array<std::uint8_t, 4>& corners, int size)
{
	PointId a = record[corners[0]];
	PointId b = record[corners[1]];
	PointId c = record[corners[2]];
	PointId d = size == 4 ? record[corners[3]] : kNoPoint;
	order(a, b);
	order(c, d);
	order(a, c);
	order(b, d);
	order(b, c);
	if (a == b || b == c || c == d) [[unlikely]]
		return withoutRepeats({{a, b, c, d}}, size);
	return {{a, b, c, d}};
}

// The lowest point of such a face, kNoPoint where it has fewer than three distinct ones.
inline PointId lowestOf(const std::uint32_t* record, const std::array<std::uint8_t, 4>& corners, int size)
{
	const PointId a = record[corners[0]];
	const PointId b = record[corners[1]];
	const PointId c = record[corners[2]];
	const PointId d = size == 4 ? record[corners[3]] : kNoPoint;
	if (a == b || b == c || c == d || d == a || a == c || b == d)
	{
		const FaceKey key = keyOf(record, corners, size);
		return key.hasArea() ? key.lowest() : kNoPoint;
	}
	return std::min(std::min(a, b), std::min(c, d));
}

} // namespace vp::grid
