#pragma once

#include "base/array.h"
#include "base/ids.h"
#include "grid/points.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vp::grid
{

struct BlockSet;

// A named part of the boundary in a file, such as an inlet or a wall: an OpenFOAM patch or an Exodus side set.
struct Patch
{
	struct Face
	{
		std::uint32_t block;
		CellId cell;
		std::uint32_t face;
	};
	std::string name;
	std::vector<Face> faces;
	std::size_t lost =
	    0; // faces in the file without a boundary face at their place: inside a block, or faces of curved cells
};

// A patch as a file lists it: polygons with their own points.
struct PatchPolygons
{
	std::string name;
	Points points;
	Array<std::int64_t> starts; // polygons + 1 offsets into corners
	Array<std::int64_t> corners;

	std::size_t polygons() const { return starts.size() - 1; }
};

// Returns the boundary faces of the blocks that lie on the polygons: their corners have exactly the same places, in any
// order. If two faces coincide, as on a seam, it is the face of the first block. The time depends on the size of the
// boundary.
std::vector<Patch> findPatches(const BlockSet& blocks, std::span<const PatchPolygons> polygons);

/// Returns the faces of all patches with a name in one block, in their order.
std::vector<Patch::Face> facesOfPatches(const BlockSet& blocks, const std::string& name, std::uint32_t block);

} // namespace vp::grid
