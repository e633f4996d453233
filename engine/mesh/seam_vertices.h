#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace vp::mesh
{

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

// A vertex of a small cell that lies on an edge of a larger cell's polygon, where that cell meets several smaller ones.
struct HangingVertex
{
	std::uint32_t vertex;
	std::size_t polygon; // the larger cell's polygon
	std::uint32_t from;  // first end of the polygon's edge
	std::uint32_t to;
	double at; // along that edge; 0 or 1 where the vertex is the same place as `from` or `to`

	bool isAtEnd() const { return at == 0.0 || at == 1.0; }
	std::uint32_t end() const { return at == 0.0 ? from : to; }
};

struct SeamVertices
{
	// Vertices that lie on each other where faces of one size meet: both on the same edge of the faces, or on the same
	// corner.
	std::vector<VertexPair> pairs;
	std::vector<HangingVertex> hanging; // where a large face meets small ones
};

// The vertices where the polygons of a mesh meet across a seam of the interfaces. The polygons must still name the
// vertices of their own cells. Takes time that follows the cut of the seams.
SeamVertices seamVertices(const grid::BlockSet& blocks, const grid::Interfaces& interfaces, const SheetMesh& mesh);

} // namespace vp::mesh
