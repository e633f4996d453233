#include "mesh/bridges.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace vp::mesh
{

std::vector<std::uint8_t> bridgesOf(std::span<const std::uint32_t> polygon)
{
	constexpr std::size_t kMinCorners = 8; // three outside, three around a hole, and two for the way back
	if (polygon.size() < kMinCorners)
		return {};
	std::vector<std::uint32_t> corners(polygon.begin(), polygon.end());
	std::ranges::sort(corners);
	if (std::ranges::adjacent_find(corners) == corners.end())
		return {};
	struct Edge
	{
		std::uint32_t low;
		std::uint32_t high;
		bool rises;
		std::size_t corner;
	};
	std::vector<Edge> edges;
	for (std::size_t i = 0; i < polygon.size(); ++i)
	{
		const std::uint32_t from = polygon[i];
		const std::uint32_t to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
		edges.push_back({std::min(from, to), std::max(from, to), from < to, i});
	}
	std::ranges::sort(edges, {}, [](const Edge& edge) { return std::tie(edge.low, edge.high, edge.corner); });
	std::vector<std::uint8_t> is_bridge(polygon.size());
	for (std::size_t i = 0; i + 1 < edges.size(); ++i)
		if (edges[i].low == edges[i + 1].low && edges[i].high == edges[i + 1].high &&
		    edges[i].rises != edges[i + 1].rises)
			is_bridge[edges[i].corner] = is_bridge[edges[i + 1].corner] = 1;
	return is_bridge;
}

std::vector<std::uint8_t> hiddenSidesOf(const SheetMesh& mesh, std::size_t polygon)
{
	std::vector<std::uint8_t> hidden = bridgesOf(mesh.polygon(polygon));
	if (mesh.is_inner.empty())
		return hidden;
	hidden.resize(mesh.polygon(polygon).size());
	for (std::size_t i = 0; i < hidden.size(); ++i)
		hidden[i] |= mesh.is_inner[mesh.polygon_starts[polygon] + i];
	return hidden;
}

} // namespace vp::mesh
