#include "mesh/sheet_mesh.h"

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
	std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);
	for (const std::uint32_t v : mesh.polygon_vertices)
		number[v] = 0;
	std::uint32_t used = 0;
	std::uint32_t used_edges = 0;
	std::vector<std::uint32_t> rim_starts{0};
	std::vector<PointShare> rim_shares;
	for (std::size_t v = 0; v < number.size(); ++v)
	{
		if (number[v] == kUnused)
			continue;
		mesh.positions[used] = mesh.positions[v];
		if (v < mesh.edges.size())
			mesh.edges[used_edges++] = mesh.edges[v];
		else
		{
			const auto shares = mesh.rimShares(v);
			rim_shares.insert(rim_shares.end(), shares.begin(), shares.end());
			rim_starts.push_back(static_cast<std::uint32_t>(rim_shares.size()));
		}
		number[v] = used++;
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

} // namespace vp::mesh
