#include "mesh/sheet_mesh.h"

#include <algorithm>
#include <numeric>

namespace vp::mesh
{

Vec3 doubleArea(const SheetMesh& mesh, std::span<const std::uint32_t> polygon)
{
	Vec3 sum(0.0);
	const Vec3& first = mesh.positions[polygon[0]];
	for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
		sum += glm::cross(mesh.positions[polygon[i]] - first, mesh.positions[polygon[i + 1]] - first);
	return sum;
}

void addShares(const SheetMesh& mesh, std::uint32_t vertex, double weight, std::vector<PointShare>& shares)
{
	if (vertex < mesh.edges.size())
	{
		const EdgePoint& edge = mesh.edges[vertex];
		// An end without a part does not bring its NaN.
		if (edge.t != 1.0)
			shares.push_back({edge.block, edge.lower, weight * (1.0 - edge.t)});
		if (edge.t != 0.0)
			shares.push_back({edge.block, edge.higher, weight * edge.t});
		return;
	}
	const std::size_t rim = vertex - mesh.edges.size();
	for (std::uint32_t s = mesh.rim_starts[rim]; s < mesh.rim_starts[rim + 1]; ++s)
	{
		PointShare share = mesh.rim_shares[s];
		share.weight *= weight;
		shares.push_back(share);
	}
}

void dropUnusedVertices(SheetMesh& mesh)
{
	constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
	const std::size_t vertices = mesh.positions.size();
	std::vector<char> is_used(vertices, 0);
	for (const std::uint32_t v : mesh.polygon_vertices)
		is_used[v] = 1;
	std::vector<std::uint32_t> number(vertices, kUnused);
	std::uint32_t used = 0;
	std::size_t used_edges = 0;
	std::vector<std::uint32_t> rim_starts{0};
	std::vector<PointShare> rim_shares;
	// Most are used, so runs of them move at once.
	for (auto begin = is_used.begin(); (begin = std::find(begin, is_used.end(), 1)) != is_used.end();)
	{
		const auto end = std::find(begin, is_used.end(), 0);
		const auto from = static_cast<std::size_t>(begin - is_used.begin());
		const auto to = static_cast<std::size_t>(end - is_used.begin());
		std::iota(number.begin() + (begin - is_used.begin()), number.begin() + (end - is_used.begin()), used);
		std::copy_n(mesh.positions.data() + from, to - from, mesh.positions.data() + used);
		used += static_cast<std::uint32_t>(to - from);
		const std::size_t first_edge = std::min(from, mesh.edges.size());
		const std::size_t edges = std::min(to, mesh.edges.size()) - first_edge;
		std::copy_n(mesh.edges.data() + first_edge, edges, mesh.edges.data() + used_edges);
		used_edges += edges;
		for (std::size_t v = from + edges; v < to; ++v)
		{
			const auto shares = mesh.rimShares(v);
			rim_shares.insert(rim_shares.end(), shares.begin(), shares.end());
			rim_starts.push_back(static_cast<std::uint32_t>(rim_shares.size()));
		}
		begin = end;
	}
	mesh.positions.resize(used);
	mesh.edges.resize(used_edges);
	mesh.rim_starts = std::move(rim_starts);
	mesh.rim_shares = std::move(rim_shares);
	for (std::uint32_t& v : mesh.polygon_vertices)
		v = number[v];
	std::erase_if(mesh.seam_pairs,
	              [&](const auto& pair) { return number[pair.first] == kUnused || number[pair.second] == kUnused; });
	for (auto& [v, w] : mesh.seam_pairs)
	{
		v = number[v];
		w = number[w];
	}
}

SheetMesh withoutBlocks(const SheetMesh& mesh, const std::vector<bool>& blocks)
{
	SheetMesh rest = mesh;
	rest.polygon_starts.resize(1);
	rest.polygon_vertices.clear();
	rest.polygon_cells.clear();
	rest.is_added.clear();
	rest.boundary_polygons = 0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		if (blocks[mesh.polygon_cells[p].block])
			continue;
		for (std::uint32_t corner = mesh.polygon_starts[p]; corner < mesh.polygon_starts[p + 1]; ++corner)
		{
			rest.polygon_vertices.push_back(mesh.polygon_vertices[corner]);
			if (!mesh.is_added.empty())
				rest.is_added.push_back(mesh.is_added[corner]);
		}
		rest.polygon_starts.push_back(static_cast<std::uint32_t>(rest.polygon_vertices.size()));
		rest.polygon_cells.push_back(mesh.polygon_cells[p]);
		rest.boundary_polygons += p >= mesh.polygons() - mesh.boundary_polygons;
	}
	return rest;
}

} // namespace vp::mesh
