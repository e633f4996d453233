#pragma once

#include "base/union_find.h"
#include "mesh/sheet_mesh.h"

#include <cstdint>
#include <vector>

namespace vp::mesh
{

/// Names of vertices by which polygons meet across seams, also where vertices lie on each other and stay two
/// (SheetMesh::seam_pairs).
class SeamNames
{
public:
	explicit SeamNames(const SheetMesh& mesh) : SeamNames(mesh, [](std::uint32_t, std::uint32_t) { return true; }) {}
	/// isOne(v, w): whether a pair has one name.
	template <class IsOne>
	SeamNames(const SheetMesh& mesh, IsOne&& isOne)
	{
		if (mesh.seam_pairs.empty())
			return;
		UnionFind one(mesh.positions.size());
		for (const auto& [v, w] : mesh.seam_pairs)
			if (isOne(v, w))
				one.join(v, w);
		for (std::uint32_t v = 0; v < one.size(); ++v)
			names_.push_back(one.root(v));
	}

	bool areVertices() const { return names_.empty(); }
	std::uint32_t operator[](std::uint32_t vertex) const { return names_.empty() ? vertex : names_[vertex]; }

private:
	std::vector<std::uint32_t> names_; // empty if all are the vertices
};

} // namespace vp::mesh
