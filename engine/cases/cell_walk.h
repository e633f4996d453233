#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vp::cases
{

// A face of a cell as indices into the cell's points, in order around the face.
struct WalkFaces
{
	std::vector<std::uint16_t> points; // points of all faces, one face after the other
	std::vector<std::uint32_t> starts; // faces + 1 offsets

	int size() const { return starts.empty() ? 0 : static_cast<int>(starts.size()) - 1; }
	std::span<const std::uint16_t> operator[](int f) const
	{
		return {points.data() + starts[f], starts[f + 1] - starts[f]};
	}
};

// A cut edge, between a point where S = 1 and one where S = 0.
struct CutEdge
{
	std::uint16_t positive;
	std::uint16_t negative;
	bool operator==(const CutEdge&) const = default;
};

// The cut of one cell: closed polygons as their edges in order, and which faces are cut.
struct CellCut
{
	std::vector<CutEdge> edges;          // edges of all polygons, one polygon after the other
	std::vector<std::uint32_t> starts;   // polygons + 1 offsets
	std::vector<std::uint8_t> face_cuts; // per face: how many of its edges are cut (0, 2, 4 …)
	bool ambiguous = false;              // some face has four or more cut edges
	bool open = false;                   // a walk found no way on: faces that do not close the cell

	int polygons() const { return starts.empty() ? 0 : static_cast<int>(starts.size()) - 1; }
};

// Where a walk around a face crosses the surface.
struct Crossing
{
	CutEdge edge;
	bool leaves; // the positive side
};

// Which crossings of a face that is cut more than once belong together (face_pairs.h).
enum class Pairing
{
	positive_apart, // each run of positive corners is cut off by itself, so the negative ones hang together
	negative_apart, // the other way round
	in_order        // each crossing goes with the next one in their order that runs the other way
};

// Walks the faces of a cell from cut edge to cut edge until each polygon closes (the paper's construction of the
// table). positive[p] is S at point p. On a face with more than two cut edges, pairing(f, crossings) decides, alike for
// both cells that share the face, and puts the crossings in order if that counts. Where every face lists its points
// counter-clockwise from outside, a polygon runs counter-clockwise seen from its positive side.
template <class PairingOf>
void walkCell(const WalkFaces& faces, std::span<const std::uint8_t> positive, PairingOf&& pairing, CellCut& cut);

} // namespace vp::cases

#include "cases/cell_walk.inl"
