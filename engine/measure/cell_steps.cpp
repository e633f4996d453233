#include "measure/cell_steps.h"

#include "mesh/seam_names.h"

#include <algorithm>
#include <cmath>

namespace vp::measure
{

namespace
{

std::vector<NetEdge> netSides(const mesh::SheetMesh& mesh, const mesh::SeamNames& names,
                              std::span<const std::uint32_t> polygons)
{
	std::vector<NetEdge> sides;
	for (const std::uint32_t p : polygons)
	{
		const auto corners = mesh.polygon(p);
		for (std::size_t i = 0; i < corners.size(); ++i)
			if (const NetEdge side{names[corners[i]], names[corners[(i + 1) % corners.size()]]}; side.from != side.to)
				sides.push_back(side);
	}
	return netEdges(std::move(sides));
}

} // namespace

std::vector<PlaneLine> meshOutlines(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points)
{
	return groupOutlines(mesh, points, std::vector<std::uint32_t>(mesh.polygons(), 0), 1)[0];
}

std::vector<std::vector<PlaneLine>> groupOutlines(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points,
                                                  std::span<const std::uint32_t> groups, std::size_t count)
{
	std::vector<std::vector<std::uint32_t>> members(count);
	for (std::size_t p = 0; p < groups.size(); ++p)
		members[groups[p]].push_back(static_cast<std::uint32_t>(p));
	const mesh::SeamNames names(mesh);
	std::vector<std::vector<PlaneLine>> outlines;
	for (const std::vector<std::uint32_t>& group : members)
		outlines.push_back(linesOf(netSides(mesh, names, group), points));
	return outlines;
}

std::vector<PlaneLine> stepLines(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points,
                                 std::span<const double> polygon_values, double level)
{
	std::vector<std::uint32_t> above;
	std::vector<std::uint32_t> below;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		if (!std::isnan(polygon_values[p]))
			(polygon_values[p] >= level ? above : below).push_back(static_cast<std::uint32_t>(p));
	// A side of the part above that is, turned round, a side of the part below too: the rim is neither's.
	const auto name = [](const NetEdge& e) { return std::uint64_t(e.from) << 32 | e.to; };
	const auto turned = [](const NetEdge& e) { return std::uint64_t(e.to) << 32 | e.from; };
	const mesh::SeamNames names(mesh);
	std::vector<NetEdge> high = netSides(mesh, names, above);
	std::vector<NetEdge> low = netSides(mesh, names, below);
	std::vector<std::uint64_t> met;
	for (const NetEdge& edge : low)
		met.push_back(turned(edge));
	std::ranges::sort(met);
	std::erase_if(high, [&](const NetEdge& edge) { return !std::ranges::binary_search(met, name(edge)); });
	return linesOf(high, points);
}

} // namespace vp::measure
