#include "mesh/clip_outside.h"

#include "base/parallel_for.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace vp::mesh
{

namespace
{

// Writes the bits of the vertices at `positions`. outsideOf(way from the origin): the bits.
template <class OutsideOf>
bool writeOutside(const Vec3& from, std::span<const Vec3> positions, std::uint8_t* outside, OutsideOf outsideOf)
{
	const Vec3 origin = from; // a copy, that what is written cannot be thought to change what is read
	unsigned found = 0;
	for (std::size_t v = 0; v < positions.size(); ++v)
	{
		const unsigned of_vertex = outsideOf(positions[v] - origin);
		outside[v] = static_cast<std::uint8_t>(of_vertex);
		found |= of_vertex;
	}
	return found != 0;
}

bool findOutsideIn(const Vec3& origin, std::span<const ClipSide> clip_sides, std::span<const Vec3> positions,
                   std::uint8_t* outside)
{
	// Those of a window are two pairs that face each other: one product tells of both.
	const auto faceEachOther = [&](std::size_t a, std::size_t b) { return clip_sides[a].axis == -clip_sides[b].axis; };
	if (clip_sides.size() == 4 && faceEachOther(0, 1) && faceEachOther(2, 3))
		return writeOutside(
		    origin, positions, outside,
		    [x = clip_sides[0].axis, y = clip_sides[2].axis, x0 = clip_sides[0].least, x1 = -clip_sides[1].least,
		     y0 = clip_sides[2].least, y1 = -clip_sides[3].least](const Vec3& way)
		    {
			    const double along_x = glm::dot(way, x);
			    const double along_y = glm::dot(way, y);
			    return static_cast<unsigned>(along_x < x0) | static_cast<unsigned>(along_x > x1) << 1 |
			           static_cast<unsigned>(along_y < y0) << 2 | static_cast<unsigned>(along_y > y1) << 3;
		    });
	std::array<ClipSide, kMaxClipSides> sides;
	std::ranges::copy(clip_sides, sides.begin());
	return writeOutside(origin, positions, outside,
	                    [sides, count = clip_sides.size()](const Vec3& way)
	                    {
		                    unsigned bits = 0;
		                    for (std::size_t side = 0; side < count; ++side)
			                    bits |= static_cast<unsigned>(glm::dot(way, sides[side].axis) < sides[side].least)
			                            << side;
		                    return bits;
	                    });
}

} // namespace

bool findOutside(const Vec3& origin, std::span<const ClipSide> sides, std::span<const Vec3> positions,
                 RawVector<std::uint8_t>& outside)
{
	outside.resize(positions.size());
	std::atomic<bool> any{false};
	constexpr std::size_t kGrain = 4096;
	tracedFor(tbb::blocked_range<std::size_t>(0, outside.size(), kGrain),
	          [&](const auto& range)
	          {
		          if (findOutsideIn(origin, sides, positions.subspan(range.begin(), range.size()),
		                            outside.data() + range.begin()))
			          any = true;
	          });
	return any;
}

} // namespace vp::mesh
