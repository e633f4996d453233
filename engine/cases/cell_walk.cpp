#include "cases/cell_walk.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vp::cases::detail
{

namespace
{

constexpr std::uint32_t kNoEnd = 0xFFFFFFFFu;

// Beyond this many ends on one edge the cell is nonsense, and any pairing will do that takes no time.
constexpr std::size_t kMaxCompared = 64;

std::uint32_t keyOf(CutEdge edge)
{
	return std::uint32_t(edge.positive) << 16 | edge.negative;
}

// Pairs the ends on one cut edge. Two of them in a cell that closes; more in one folded on itself, where a beginning is
// paired with an end of another face before anything else, so that polygons keep their sense and pass on to the next
// face.
void pairEnds(std::span<const SegmentEnd> ends, std::span<const Segment> segments, std::vector<std::uint32_t>& partner)
{
	const auto join = [&](const SegmentEnd& a, const SegmentEnd& b)
	{
		partner[a.id] = b.id;
		partner[b.id] = a.id;
	};
	if (ends.size() == 2 || ends.size() > kMaxCompared)
	{
		for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
			join(ends[i], ends[i + 1]);
		return;
	}
	const auto pairWhere = [&](auto&& fit)
	{
		for (std::size_t a = 0; a < ends.size(); ++a)
			for (std::size_t b = a + 1; b < ends.size() && partner[ends[a].id] == kNoEnd; ++b)
				if (partner[ends[b].id] == kNoEnd && fit(ends[a].id, ends[b].id))
					join(ends[a], ends[b]);
	};
	const auto otherFace = [&](std::uint32_t a, std::uint32_t b)
	{ return segments[a / 2].face != segments[b / 2].face; };
	pairWhere([&](std::uint32_t a, std::uint32_t b) { return a % 2 != b % 2 && otherFace(a, b); });
	pairWhere(otherFace);
	pairWhere([](std::uint32_t, std::uint32_t) { return true; });
}

// Follows a polygon from where it enters a segment until it closes or there is no way on. Edges are taken at the
// entries; where the way ends, its last exit too, and the polygon is closed straight, as the missing face would.
void trace(std::uint32_t entry, std::span<const Segment> segments, WalkScratch& scratch, CellCut& cut)
{
	const auto begin = static_cast<std::ptrdiff_t>(cut.edges.size());
	const auto edgeAt = [&](std::uint32_t end) { return end % 2 ? segments[end / 2].to : segments[end / 2].from; };
	std::size_t steps = 0;
	std::size_t backward = 0;
	while (entry != kNoEnd && !scratch.done[entry / 2])
	{
		scratch.done[entry / 2] = 1;
		cut.edges.push_back(edgeAt(entry));
		++steps;
		backward += entry % 2;
		const std::uint32_t exit = entry ^ 1;
		entry = scratch.partner[exit];
		if (entry == kNoEnd)
		{
			cut.open = true;
			cut.edges.push_back(edgeAt(exit));
		}
	}
	// Two edges enclose nothing.
	if (cut.edges.size() - begin < 3)
	{
		cut.edges.resize(begin);
		return;
	}
	if (2 * backward > steps)
		std::reverse(cut.edges.begin() + begin, cut.edges.end());
	cut.starts.push_back(static_cast<std::uint32_t>(cut.edges.size()));
}

} // namespace

WalkScratch& walkScratch()
{
	thread_local WalkScratch scratch;
	return scratch;
}

bool findCrossings(const WalkFaces& faces, int f, std::span<const std::uint8_t> positive,
                   std::vector<Crossing>& crossings)
{
	crossings.clear();
	if (faces.starts[f] > faces.starts[f + 1] || faces.starts[f + 1] > faces.points.size())
		return false;
	const std::span<const std::uint16_t> face = faces[f];
	if (std::ranges::any_of(face, [&](std::uint16_t p) { return p >= positive.size(); }))
		return false;
	for (std::size_t i = 0; i < face.size(); ++i)
	{
		const std::uint16_t here = face[i];
		const std::uint16_t next = face[i + 1 < face.size() ? i + 1 : 0];
		if (!positive[here] == !positive[next])
			continue;
		if (positive[here])
			crossings.push_back({{here, next}, true});
		else
			crossings.push_back({{next, here}, false});
	}
	return true;
}

void addSegments(std::span<const Crossing> crossings, std::uint32_t face, Pairing pairing, WalkScratch& scratch)
{
	const auto add = [&](const Crossing& leaving, const Crossing& back)
	{
		// A face that runs along an edge and back again leaves nothing between.
		if (leaving.edge != back.edge)
			scratch.segments.push_back({leaving.edge, back.edge, face});
	};
	if (pairing == Pairing::in_order)
	{
		scratch.unpaired.clear();
		for (const Crossing& crossing : crossings)
		{
			if (scratch.unpaired.empty() || scratch.unpaired.back().leaves == crossing.leaves)
			{
				scratch.unpaired.push_back(crossing);
				continue;
			}
			const Crossing& other = scratch.unpaired.back();
			add(crossing.leaves ? crossing : other, crossing.leaves ? other : crossing);
			scratch.unpaired.pop_back();
		}
		return;
	}
	// Around the face, leaving and coming back take turns. The crossing before a leaving one began the same positive
	// run, the one after it ends the negative run that it begins.
	const std::size_t count = crossings.size();
	for (std::size_t i = 0; i < count; ++i)
		if (crossings[i].leaves)
			add(crossings[i],
			    crossings[pairing == Pairing::negative_apart ? (i + 1) % count : (i + count - 1) % count]);
}

void tracePolygons(WalkScratch& scratch, CellCut& cut)
{
	const std::vector<Segment>& segments = scratch.segments;
	scratch.ends.clear();
	for (std::uint32_t s = 0; s < segments.size(); ++s)
	{
		scratch.ends.push_back({keyOf(segments[s].from), 2 * s});
		scratch.ends.push_back({keyOf(segments[s].to), 2 * s + 1});
	}
	std::ranges::sort(scratch.ends, {}, [](const SegmentEnd& end) { return std::pair(end.edge, end.id); });
	scratch.partner.assign(scratch.ends.size(), kNoEnd);
	scratch.done.assign(segments.size(), 0);
	for (std::size_t i = 0; i < scratch.ends.size();)
	{
		std::size_t next = i + 1;
		while (next < scratch.ends.size() && scratch.ends[next].edge == scratch.ends[i].edge)
			++next;
		pairEnds({scratch.ends.data() + i, next - i}, segments, scratch.partner);
		i = next;
	}
	for (std::uint32_t end = 0; end < scratch.partner.size(); ++end)
		if (scratch.partner[end] == kNoEnd)
			trace(end, segments, scratch, cut);
	for (std::uint32_t s = 0; s < segments.size(); ++s)
		trace(2 * s, segments, scratch, cut);
}

} // namespace vp::cases::detail
