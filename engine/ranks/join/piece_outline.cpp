#include "ranks/join/piece_outline.h"

#include "base/place_key.h"

#include <array>
#include <cstdint>
#include <set>
#include <unordered_map>

namespace vp::ranks
{

namespace
{

using render::EdgeCurves;
using render::Segment;

// Indices of the curves along i and j, at the first layer of points and at the last one.
constexpr std::size_t kBottom[] = {0, 1, 4, 6};
constexpr std::size_t kTop[] = {2, 3, 5, 7};
constexpr std::size_t kUpward = 8; // the first of the curves along k

bool areStacked(std::span<const EdgeCurves> pieces)
{
	for (std::size_t p = 0; p < pieces.size(); ++p)
		if (pieces[p][kUpward].empty())
			return false;
	for (std::size_t p = 1; p < pieces.size(); ++p)
		for (std::size_t c = 0; c < std::size(kTop); ++c)
			if (pieces[p - 1][kTop[c]] != pieces[p][kBottom[c]])
				return false;
	return true;
}

EdgeCurves stacked(std::span<const EdgeCurves> pieces)
{
	EdgeCurves whole = pieces.front();
	for (const std::size_t top : kTop)
		whole[top] = pieces.back()[top];
	for (std::size_t c = kUpward; c < whole.size(); ++c)
		for (const EdgeCurves& piece : pieces.subspan(1))
			whole[c].insert(whole[c].end(), piece[c].begin() + 1, piece[c].end());
	return whole;
}

template <class Visit>
void forSegments(const std::vector<Vec3>& curve, const Visit& visit)
{
	for (std::size_t i = 1; i < curve.size(); ++i)
		if (curve[i - 1] != curve[i])
			visit(Segment{curve[i - 1], curve[i]});
}

// Whichever way it runs.
std::uint64_t keyOf(const Segment& segment)
{
	return placeKey(segment.a) + placeKey(segment.b);
}

} // namespace

std::vector<Segment> outlineOfPieces(std::span<const EdgeCurves> pieces)
{
	std::vector<Segment> segments;
	if (areStacked(pieces))
	{
		for (const std::vector<Vec3>& curve : stacked(pieces))
			forSegments(curve, [&](const Segment& segment) { segments.push_back(segment); });
		return segments;
	}
	std::unordered_map<std::uint64_t, std::size_t> holders;
	for (const EdgeCurves& piece : pieces)
	{
		std::set<std::uint64_t> own;
		for (const std::vector<Vec3>& curve : piece)
			forSegments(curve, [&](const Segment& segment) { own.insert(keyOf(segment)); });
		for (const std::uint64_t key : own)
			++holders[key];
	}
	for (std::size_t c = 0; c < std::tuple_size_v<EdgeCurves>; ++c)
		for (const EdgeCurves& piece : pieces)
			forSegments(piece[c],
			            [&](const Segment& segment)
			            {
				            if (holders[keyOf(segment)] == 1)
					            segments.push_back(segment);
			            });
	return segments;
}

} // namespace vp::ranks
