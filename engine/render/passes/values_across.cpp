#include "render/passes/values_across.h"

#include "mesh/seam_names.h"

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

struct Edge
{
	std::uint64_t points; // lower vertex in the high half
	std::uint32_t polygon;
	std::uint32_t place; // in polygon_vertices
};

std::vector<Edge> edgesOf(const mesh::SheetMesh& mesh)
{
	const mesh::SeamNames names(mesh);
	std::vector<Edge> edges;
	edges.reserve(mesh.polygon_vertices.size());
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::uint32_t i = 0; i < polygon.size(); ++i)
		{
			const auto [low, high] = std::minmax({names[polygon[i]], names[polygon[(i + 1) % polygon.size()]]});
			edges.push_back({std::uint64_t(low) << 32 | high, p, mesh.polygon_starts[p] + i});
		}
	}
	std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.points < b.points; });
	return edges;
}

} // namespace

std::vector<double> valuesAcross(const mesh::SheetMesh& mesh, std::span<const double> polygon_values)
{
	std::vector<double> across(mesh.polygon_vertices.size());
	const auto put = [&](const Edge& edge, const Edge& other)
	{
		const double there = polygon_values[other.polygon];
		across[edge.place] = std::isnan(there) ? polygon_values[edge.polygon] : there;
	};
	const std::vector<Edge> edges = edgesOf(mesh);
	for (std::size_t first = 0, next; first < edges.size(); first = next)
	{
		next = first + 1;
		while (next < edges.size() && edges[next].points == edges[first].points)
			++next;
		const bool pair = next - first == 2;
		for (std::size_t i = first; i < next; ++i)
			put(edges[i], pair ? edges[first + next - 1 - i] : edges[i]);
	}
	return across;
}

} // namespace vp::render
