#pragma once

#include "base/ids.h"
#include "grid/boundary.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::grid
{

struct BlockSet;

// How the size of a face compares with the face across a seam.
enum class Hang : std::uint8_t
{
	none,  // both have the same size
	small, // the face is a part of the other, as at the edge of a finer level
	large  // the other is a part of the face
};

// A boundary face, and another face at the same place that does not share its points. The other face belongs to another
// block, or to the same block where points are not merged, as where an O-grid closes or nodes hang. A face that lies on
// up to eight others is linked to each of them. If there are more, it is linked to some, whose links lead to all.
struct SeamLink
{
	CellId cell;
	std::uint32_t face;
	std::uint32_t block; // block of the cell across
	CellId other;
	std::uint32_t other_face;
	Hang hang = Hang::none;

	auto operator<=>(const SeamLink&) const = default;
};

// The seams of one block, seen from this block.
class BlockSeams
{
public:
	BlockSeams() = default;
	explicit BlockSeams(std::vector<SeamLink> links); // in any order

	bool empty() const { return links_.empty(); }
	std::span<const SeamLink> all() const { return links_; } // ascending
	std::span<const SeamLink> ofCell(CellId cell) const;
	std::span<const SeamLink> of(CellId cell, std::uint32_t face) const;

private:
	std::vector<SeamLink> links_;
};

// Two blocks that meet, or one block that meets itself (a == b).
struct Interface
{
	std::uint32_t a;
	std::uint32_t b;   // a <= b
	std::size_t faces; // pairs of faces
};

// The places where the blocks of a set meet. Empty before matchInterfaces().
struct Interfaces
{
	std::vector<BlockSeams> blocks;    // one per block
	std::vector<Interface> interfaces; // in ascending order
	std::size_t seam_faces = 0;        // boundary faces that lie on another face
	std::size_t boundary_faces = 0;    // the others: the boundary of the domain

	// Returns null if the block meets nothing.
	const BlockSeams* of(std::size_t block) const
	{
		return block < blocks.size() && !blocks[block].empty() ? &blocks[block] : nullptr;
	}
};

// Matches the boundary faces of all blocks by their corners and fills blocks.interfaces. Two faces match when each
// corner of one lies on a corner of the other, within the tolerance of face_tolerance.h. Faces on either side of a cell
// thinner than the tolerance do not match. Repeated corners count once; faces with fewer than three match nothing. A
// face without a match that lies within a larger one, with the cells on either side, is linked to it as well (Hang).
// Near-linear in the number of boundary faces, on all cores, the same result for any number of threads.
void matchInterfaces(BlockSet& blocks);

/// The same for some of the boundary faces: faces[b] of block b. Only these are counted.
Interfaces interfacesAmong(const BlockSet& blocks, std::span<const std::vector<BoundaryIndex::Face>> faces);

} // namespace vp::grid
