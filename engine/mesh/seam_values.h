#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <cstdint>
#include <vector>

namespace vp::mesh
{

/// Compares the point arrays of the two sides of a seam.
class SeamValues
{
public:
	SeamValues(const grid::BlockSet& blocks, const SheetMesh& mesh);

	/// Returns true if each array has one value at both vertices (isSameValue()). Vertices may be added to the mesh
	/// meanwhile.
	bool agree(std::uint32_t v, std::uint32_t w);
	/// Returns true if the blocks of both vertices have arrays of the same names and kinds.
	bool haveSameArrays(std::uint32_t v, std::uint32_t w) const;

private:
	std::uint32_t blockOf(std::uint32_t vertex) const;
	const grid::Field* likeOf(const grid::Field& field, std::uint32_t block) const;

	const grid::BlockSet& blocks_;
	const SheetMesh& mesh_;
	std::vector<std::size_t> arrays_;         // per block, its point arrays
	std::vector<const grid::Field*> in_each_; // the array at hand in the blocks at hand
};

} // namespace vp::mesh
