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

// A part of the boundary that a file names, such as an inlet or a wall: an OpenFOAM patch, an Exodus side set.
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
	std::size_t lost = 0; // faces in the file that no boundary face lies on: within a block, or of curved cells
};

// A patch as a file lists it: polygons over points of its own.
struct PatchPolygons
{
	std::string name;
	Points points;
	Array<std::int64_t> starts; // polygons + 1 offsets into corners
	Array<std::int64_t> corners;

	std::size_t polygons() const { return starts.size() - 1; }
};

// The boundary faces of the blocks that lie on the polygons: with their corners at exactly the same places, in whatever
// order. Of two that coincide, as on a seam, the first block's. Time follows the boundary.
std::vector<Patch> findPatches(const BlockSet& blocks, std::span<const PatchPolygons> polygons);

/// The faces of all patches of a name in one block, in their order.
std::vector<Patch::Face> facesOfPatches(const BlockSet& blocks, const std::string& name, std::uint32_t block);

} // namespace vp::grid
