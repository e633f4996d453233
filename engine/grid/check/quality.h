#pragma once

#include "grid/block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::grid
{

// A cell of a block set, in its block's numbering.
struct SetCell
{
	std::uint32_t block;
	CellId cell;

	auto operator<=>(const SetCell&) const = default;
};

struct SetPoint
{
	std::uint32_t block;
	PointId point;

	auto operator<=>(const SetPoint&) const = default;
};

// Faults of the cells and points of a block set. Cells and points are in ascending order.
struct Quality
{
	// With a point that is listed twice, or two points at one place, unless they are degenerate.
	std::vector<SetCell> collapsed;
	// Hexahedra, wedges and pyramids that list corners twice and are simpler cells for all that: what they list twice
	// is joined by their edges, and the rest is a wedge, a pyramid or a tetrahedron with a volume. They are cut as
	// such.
	std::vector<SetCell> degenerate;
	// Turned inside out: cells of an unstructured block whose faces, as VTK numbers them, run clockwise seen from
	// outside. Of structured blocks and of polyhedra, whose order says nothing by itself: those turned the other way
	// than most.
	std::vector<SetCell> inverted;
	// Whose edges at some corner span a volume of the other sign than the cell's. Of hexahedra, wedges, and the base of
	// pyramids.
	std::vector<SetCell> twisted;
	// Points where one with a lower number lies already: exactly, within a block.
	std::vector<SetPoint> coincident;
	// Where points of a structured block coincide all along a seam, the grid only closes there: coincident points in
	// cells that are neither collapsed nor of an unstructured block are no fault. Nor are they if cells have points of
	// their own (haveOwnPoints()).
	bool coincident_at_fault = false;
	std::vector<SetPoint> orphans; // points of no cell
	// Faces of more than two cells, by the cells around them, lowest first. Cells that share the points of a face, or
	// whose boundary faces lie on one another; a 2:1 interface is none.
	std::vector<std::vector<SetCell>> nonmanifold_faces;
	// Only in unstructured blocks: a cell of each edge with more than two faces of the domain's boundary, and a cell of
	// each point at which the boundary touches itself without an edge.
	std::vector<SetCell> nonmanifold_edges;
	std::vector<SetCell> nonmanifold_points;
	// Pairs of cells that hold a point in common, deeper than contact; see findOverlaps().
	std::vector<std::pair<SetCell, SetCell>> overlaps;
	std::size_t overlap_samples = 0; // cells that were looked at for that
};

// On all cores. matchInterfaces() has been called.
Quality checkQuality(const BlockSet& blocks);

// Returns true if no point belongs to two cells of the file, as discontinuous Galerkin methods write them. The copies
// of points have values of their own, so they are not meant to be merged.
bool haveOwnPoints(const UnstructuredGrid& grid);

// Parts of checkQuality().
void findCellFaults(const BlockSet& blocks, Quality& quality);     // collapsed, degenerate, inverted, twisted
void findPointFaults(const BlockSet& blocks, Quality& quality);    // coincident, orphans
void findTopologyFaults(const BlockSet& blocks, Quality& quality); // nonmanifold
// Looks whether the center of a cell, or a point halfway from there to a corner, lies inside another cell, by more than
// a hundredth of the way from the other's face to its center. Of each block 20 000 cells at most are looked at, evenly
// spread, against all cells of all blocks; for each, up to 16 others are told. Images and rectilinear grids do not
// overlap themselves and are not asked.
void findOverlaps(const BlockSet& blocks, Quality& quality);

// Two blocks that have room in common.
struct BlockOverlap
{
	std::uint32_t a;
	std::uint32_t b;     // a < b
	std::size_t cells;   // number of sampled cells that contain a point of the other block
	std::size_t samples; // number of sampled cells of both blocks
};

struct BlockOverlaps
{
	std::vector<BlockOverlap> pairs; // those that overlap, ascending
	std::size_t near = 0;            // pairs of blocks whose bounds have room in common
	std::size_t looked_at = 0;       // how many of these were looked at
};

// For each pair of blocks whose bounds have room in common up to 500 cells of either, evenly spread over those within
// the other's bounds, are looked at as findOverlaps() does; no others cost anything. Above 200 pairs fewer cells of
// each are looked at, 16 at least; above 6250 pairs, or where their blocks are large, not all pairs are.
BlockOverlaps findBlockOverlaps(const BlockSet& blocks);

} // namespace vp::grid
