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

inline void order(PointId& a, PointId& b)
{
	const PointId lower = std::min(a, b);
	b = std::max(a, b);
	a = lower;
}

// Of the points `corners` of a table shape, three or four.
inline FaceKey keyOf(const std::uint32_t* record, const std::array<std::uint8_t, 4>& corners, int size)
{
	FaceKey key;
	auto& ids = key.ids;
	for (int i = 0; i < 3; ++i)
		ids[i] = record[corners[i]];
	if (size == 4)
	{
		ids[3] = record[corners[3]];
		order(ids[0], ids[1]);
		order(ids[2], ids[3]);
		order(ids[0], ids[2]);
		order(ids[1], ids[3]);
		order(ids[1], ids[2]);
	}
	else
	{
		order(ids[0], ids[1]);
		order(ids[1], ids[2]);
		order(ids[0], ids[1]);
	}
	if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[3])
		std::fill(std::unique(ids.begin(), ids.begin() + size), ids.end(), kNoPoint);
	return key;
}

} // namespace vp::grid
