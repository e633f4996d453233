#pragma once

#include "grid/cell_shape.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::cases
{

constexpr int kMaxPolygon = 6; // edges of the polygon of a table shape: a hexahedron has six faces, each cut once

// The cut of a table shape whose S bits are `mask` (bit v: point v is on the positive side).
struct Case
{
	std::uint8_t edges = 0;  // 0: no polygon (nothing cut, or the walk is needed)
	std::uint8_t faces = 0;  // bit f: face f is cut
	bool needs_walk = false; // a face is cut twice, or the cut has several polygons: no entry, walk the cell
	// End points of the cut edges in polygon order: {positive, negative}. Counter-clockwise seen from the positive
	// side.
	std::array<std::array<std::uint8_t, 2>, kMaxPolygon> edge{};
	// The face through which the polygon goes on from this edge to the next one; the first one again behind the last.
	std::array<std::uint8_t, kMaxPolygon> face_after{};
};

// 2^points cases. Computed once, from cell_shape, by walking the faces.
std::span<const Case> caseTable(grid::CellShape shape);

// The same tables for the GPU, four 32-bit words per case, the shapes one after the other at caseTableStart(shape):
//   word 0: number of edges | faces << 8 | needs_walk << 16
//   words 1..3: two edges each, 16 bits an edge: positive point | negative point << 8
std::vector<std::uint32_t> packedCaseTables();
std::uint32_t caseTableStart(grid::CellShape shape); // in cases, not words

} // namespace vp::cases
