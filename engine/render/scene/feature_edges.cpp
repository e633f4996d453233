#include "render/scene/feature_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace vp::render
{

namespace
{

struct FaceEdge
{
	std::uint64_t points; // lower id in the high half
	Vec3f normal;         // of the face, outwards, unit
};

template <class G>
std::vector<FaceEdge> boundaryEdges(const G& grid, const grid::BoundaryIndex& boundary)
{
	std::vector<FaceEdge> edges;
	edges.reserve(4 * boundary.faces.size());
	grid::CellFaces faces;
	for (const auto& boundary_face : boundary.faces)
	{
		grid.cellFaces(boundary_face.cell, faces);
		const auto face = faces[static_cast<int>(boundary_face.face)];
		// Newell's normal: right for bent faces, zero for those that collapsed.
		const Vec3 origin = grid.point(face[0]);
		Vec3 normal(0.0);
		double reach = 0.0;
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const Vec3 a = grid.point(face[i]) - origin;
			const Vec3 b = grid.point(face[(i + 1) % face.size()]) - origin;
			normal += glm::cross(a, b);
			reach = std::max(reach, glm::length(b));
		}
		const double area = glm::length(normal);
		if (!(area > 1e-12 * reach * reach))
			continue; // the faces around a collapsed one meet in its edge
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const auto [low, high] = std::minmax(face[i], face[(i + 1) % face.size()]);
			if (low != high)
				edges.push_back({std::uint64_t(low) << 32 | high, Vec3f(normal / area)});
		}
	}
	return edges;
}

} // namespace

void addFeatureEdges(const grid::Block& block, std::vector<Segment>& segments)
{
	const float cosine = std::cos(static_cast<float>(kFeatureAngle * std::numbers::pi / 180.0));
	std::visit(
	    [&](const auto& grid)
	    {
		    std::vector<FaceEdge> edges = boundaryEdges(grid, block.boundary);
		    std::sort(edges.begin(), edges.end(),
		              [](const FaceEdge& a, const FaceEdge& b) { return a.points < b.points; });
		    for (std::size_t first = 0, next; first < edges.size(); first = next)
		    {
			    next = first + 1;
			    while (next < edges.size() && edges[next].points == edges[first].points)
				    ++next;
			    if (next - first == 2 && glm::dot(edges[first].normal, edges[first + 1].normal) >= cosine)
				    continue;
			    const Vec3 a = grid.point(static_cast<PointId>(edges[first].points >> 32));
			    const Vec3 b = grid.point(static_cast<PointId>(edges[first].points));
			    if (a != b)
				    segments.push_back({a, b});
		    }
	    },
	    block.grid);
}

} // namespace vp::render
