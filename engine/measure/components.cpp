#include "measure/components.h"

namespace vp::measure
{

UnionFind joinedVertices(const mesh::SheetMesh& mesh)
{
	UnionFind pieces(mesh.positions.size()); // every vertex belongs to a polygon
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		for (const std::uint32_t v : mesh.polygon(p).subspan(1))
			pieces.join(mesh.polygon(p)[0], v);
	for (const auto& [v, w] : mesh.seam_pairs)
		pieces.join(v, w);
	return pieces;
}

std::size_t countComponents(const mesh::SheetMesh& mesh)
{
	return joinedVertices(mesh).count();
}

} // namespace vp::measure
