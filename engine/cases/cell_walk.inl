#pragma once

#include "cases/cell_walk.h"

#include <algorithm>

namespace vp::cases
{

namespace detail
{

// The part of a polygon that lies in one face. From the crossing at which the face's boundary leaves the positive side
// to one at which it comes back: so it runs counter-clockwise round the cut seen from the positive side.
struct Segment
{
	CutEdge from;
	CutEdge to;
	std::uint32_t face;
};

// Segment s has the ends 2 s (its `from`) and 2 s + 1 (its `to`).
struct SegmentEnd
{
	std::uint32_t edge; // key of the cut edge it lies on
	std::uint32_t id;
};

struct WalkScratch
{
	std::vector<Crossing> crossings;    // crossings of one face
	std::vector<Crossing> unpaired;     // crossings that have no partner yet
	std::vector<Segment> segments;      // segments of all faces
	std::vector<SegmentEnd> ends;       // by edge
	std::vector<std::uint32_t> partner; // per end: the one where the polygon goes on
	std::vector<std::uint8_t> done;     // per segment
};

WalkScratch& walkScratch(); // this thread's scratch memory

// Puts the crossings of one face into `crossings`. Returns false if the face does not belong to this cell.
bool findCrossings(const WalkFaces& faces, int f, std::span<const std::uint8_t> positive,
                   std::vector<Crossing>& crossings);

// Joins the crossings around one face.
void addSegments(std::span<const Crossing> crossings, std::uint32_t face, Pairing pairing, WalkScratch& scratch);

// Joins the segments at their cut edges into polygons.
void tracePolygons(WalkScratch& scratch, CellCut& cut);

} // namespace detail

template <class PairingOf>
void walkCell(const WalkFaces& faces, std::span<const std::uint8_t> positive, PairingOf&& pairing, CellCut& cut)
{
	cut.edges.clear();
	cut.starts.assign(1, 0);
	cut.face_cuts.clear();
	cut.ambiguous = false;
	cut.open = false;
	detail::WalkScratch& scratch = detail::walkScratch();
	scratch.segments.clear();
	for (int f = 0; f < faces.size(); ++f)
	{
		if (!detail::findCrossings(faces, f, positive, scratch.crossings))
			cut.open = true;
		// The count is even; no more than fits a byte and is.
		const std::size_t cuts = std::min<std::size_t>(scratch.crossings.size(), 254);
		cut.face_cuts.push_back(static_cast<std::uint8_t>(cuts));
		if (cuts == 0)
			continue;
		const bool ambiguous = cuts >= 4;
		cut.ambiguous = cut.ambiguous || ambiguous;
		const Pairing chosen = ambiguous ? pairing(f, std::span(scratch.crossings)) : Pairing::positive_apart;
		detail::addSegments(scratch.crossings, static_cast<std::uint32_t>(f), chosen, scratch);
	}
	detail::tracePolygons(scratch, cut);
}

} // namespace vp::cases
