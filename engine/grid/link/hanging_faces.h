#pragma once

#include "grid/block.h"
#include "grid/face_tolerance.h"

#include <span>
#include <vector>

namespace vp::grid
{

/// A boundary face that lies on no other of its size.
struct LooseFace
{
	std::uint32_t block;
	BoundaryIndex::Face face;
	FaceTolerance tolerance;
};

/// Links faces that lie within a larger one, as where a cell meets several smaller ones: links[b] of block b grows. In
/// the larger face's plane, within the tolerance and what the face is warped, and with the cells on either side of it.
void linkHangingFaces(const BlockSet& blocks, std::span<const LooseFace> faces,
                      std::vector<std::vector<SeamLink>>& links);

} // namespace vp::grid
