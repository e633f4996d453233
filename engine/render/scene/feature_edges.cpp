#include "render/scene/feature_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace vp::render
{

namespace
{

struct FaceEdge
{
	std::uint64_t points; // lower id in the high half
	Vec3f normal;         // outward unit normal of the face
	bool is_inside;       // the face is not on the boundary
};

// is_inside: per face; or empty if all faces are on the boundary.
template <class G>
std::vector<FaceEdge> boundaryEdges(const G& grid, const grid::BoundaryIndex& boundary,
                                    const std::vector<bool>& is_inside)
{
	std::vector<FaceEdge> edges;
	edges.reserve(4 * boundary.faces.size());
	grid::CellFaces faces;
	for (std::size_t f = 0; f < boundary.faces.size(); ++f)
	{
		const grid::BoundaryIndex::Face& boundary_face = boundary.faces[f];
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
				edges.push_back(
				    {std::uint64_t(low) << 32 | high, Vec3f(normal / area), !is_inside.empty() && is_inside[f]});
		}
	}
	return edges;
}

template <class G>
void addEdges(const G& grid, const grid::BoundaryIndex& boundary, const std::vector<bool>& is_inside,
              std::vector<Segment>& segments, std::vector<OpenEdge>* open)
{
	std::vector<FaceEdge> edges = boundaryEdges(grid, boundary, is_inside);
	std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) { return a.points < b.points; });
	std::vector<Vec3f> normals;
	for (std::size_t first = 0, next; first < edges.size(); first = next)
	{
		normals.clear();
		bool is_open = false;
		for (next = first; next < edges.size() && edges[next].points == edges[first].points; ++next)
		{
			is_open |= edges[next].is_inside;
			if (!edges[next].is_inside)
				normals.push_back(edges[next].normal);
		}
		const Segment segment{grid.point(static_cast<PointId>(edges[first].points >> 32)),
		                      grid.point(static_cast<PointId>(edges[first].points))};
		if (segment.a == segment.b)
			continue;
		if (is_open)
			open->push_back({segment, normals});
		else if (isFeature(normals))
			segments.push_back(segment);
	}
}

std::array<double, 3> orderOf(const Vec3& p)
{
	return {p.x, p.y, p.z};
}

} // namespace

bool isFeature(std::span<const Vec3f> normals)
{
	static const float cosine = std::cos(static_cast<float>(kFeatureAngle * std::numbers::pi / 180.0));
	return !normals.empty() && !(normals.size() == 2 && glm::dot(normals[0], normals[1]) >= cosine);
}

void addFeatureEdges(const grid::Block& block, std::vector<Segment>& segments)
{
	std::visit([&](const auto& grid) { addEdges(grid, block.boundary, {}, segments, nullptr); }, block.grid);
}

void addFeatureEdges(const grid::Block& piece, const std::vector<bool>& is_inside, std::vector<Segment>& segments,
                     std::vector<OpenEdge>& open)
{
	std::visit([&](const auto& grid) { addEdges(grid, piece.boundary, is_inside, segments, &open); }, piece.grid);
}

void putInOrder(std::vector<Segment>& segments)
{
	for (Segment& segment : segments)
		if (orderOf(segment.b) < orderOf(segment.a))
			std::swap(segment.a, segment.b);
	std::ranges::sort(segments, {},
	                  [](const Segment& segment) { return std::pair(orderOf(segment.a), orderOf(segment.b)); });
}

} // namespace vp::render
