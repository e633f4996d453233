#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <cstdint>
#include <vector>

namespace vp::mesh
{

/// The edges of polygons that lie within a cell of the file, where the grid's cells are parts of the file's: refined
/// curved cells, or those that a reader has cut. Lines of the mesh leave them out, since the file's cells have no faces
/// there. Both are empty if no cell has parts.
struct PartEdges
{
	std::vector<std::uint8_t> is_inner; // per entry of polygon_vertices: 1 if the edge to the next one is such an edge
	// Per polygon: the width (4 area / perimeter) of what the sheet cuts of the whole cell, as a multiple of the
	// polygon's own. Lines fade by the width.
	std::vector<float> widths;

	bool isInner(std::size_t entry) const { return entry < is_inner.size() && is_inner[entry]; }
	float widthOf(std::size_t polygon) const { return polygon < widths.size() ? widths[polygon] : 1.0f; }
};

/// Returns true if a cell of the grid may be a part of a cell of the file.
bool hasParts(const grid::BlockSet& blocks);

/// Takes n log n time for n edges of cells with parts.
PartEdges partEdges(const grid::BlockSet& blocks, const SheetMesh& mesh);

} // namespace vp::mesh
