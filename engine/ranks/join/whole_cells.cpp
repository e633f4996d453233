#include "ranks/join/whole_cells.h"
#include "ranks/data/share.h"

#include "ranks/join/border_faces.h"
#include "ranks/join/rim_vertices.h"
#include "ranks/join/unmatched_faces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vp::ranks
{

namespace
{

/// The number of the face of its cell that a polygon is. Vertices that were joined may lie a rounding off its points.
int faceOf(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, std::uint32_t polygon)
{
	const mesh::BlockCell& cell = mesh.polygon_cells[polygon];
	return std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces faces;
		    grid.cellFaces(cell.cell, faces);
		    int found = 0;
		    double nearest = std::numeric_limits<double>::infinity();
		    for (int f = 0; f < faces.size(); ++f)
		    {
			    double farthest = 0.0;
			    for (const std::uint32_t v : mesh.polygon(polygon))
			    {
				    double distance = std::numeric_limits<double>::infinity();
				    for (const PointId p : faces[f])
					    distance = std::min(distance, glm::length(grid.point(p) - mesh.positions[v]));
				    farthest = std::max(farthest, distance);
			    }
			    if (farthest < nearest)
				    found = f;
			    nearest = std::min(nearest, farthest);
		    }
		    return found;
	    },
	    blocks.blocks[cell.block].grid);
}

struct LonePolygons
{
	std::vector<UnmatchedFace> faces;
	std::vector<std::uint32_t> polygons; // per face
};

LonePolygons lonePolygons(const grid::BlockSet& blocks, std::span<const Box> others, const mesh::SheetMesh& mesh)
{
	LonePolygons found;
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		Box box;
		for (const std::uint32_t v : mesh.polygon(p))
			box.include(mesh.positions[v]);
		if (!touchesAny(box, others))
			continue;
		std::optional<UnmatchedFace> face = unmatchedFace(blocks, mesh.polygon_cells[p], faceOf(blocks, mesh, p));
		if (!face)
			continue;
		found.faces.push_back(std::move(*face));
		found.polygons.push_back(p);
	}
	return found;
}

std::uint64_t nameOf(const mesh::EdgePoint& point)
{
	return std::uint64_t(point.block) << 32 | point.lower;
}

/// The corners of faces that lie on each other, by name, and how far rounding may have parted them. As in
/// mesh/join_vertices.h, other faces of the same cell that are shown must have them.
std::unordered_map<std::uint64_t, double> cornersAcross(const LonePolygons& lone,
                                                        std::span<const std::vector<FaceAcross>> across,
                                                        std::span<const std::uint32_t> dropped,
                                                        const mesh::SheetMesh& mesh)
{
	std::map<std::pair<std::uint32_t, CellId>, std::vector<std::uint32_t>> of_cells; // vertices that stay
	for (const UnmatchedFace& face : lone.faces)
		of_cells[{face.cell.block, face.cell.cell}];
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto of_cell = of_cells.find({mesh.polygon_cells[p].block, mesh.polygon_cells[p].cell});
		if (of_cell != of_cells.end() && !std::ranges::binary_search(dropped, p))
			of_cell->second.insert(of_cell->second.end(), mesh.polygon(p).begin(), mesh.polygon(p).end());
	}
	std::unordered_map<std::uint64_t, double> near;
	for (std::size_t f = 0; f < lone.faces.size(); ++f)
	{
		if (across[f].empty())
			continue;
		const std::vector<std::uint32_t>& stays = of_cells[{lone.faces[f].cell.block, lone.faces[f].cell.cell}];
		for (const std::uint32_t v : mesh.polygon(lone.polygons[f]))
			if (std::ranges::find(stays, v) != stays.end())
			{
				double& of_vertex = near[nameOf(mesh.edges[v])];
				of_vertex = std::max(of_vertex, lone.faces[f].apart());
			}
	}
	return near;
}

} // namespace

Borders joinWholeCells(const Ranks& ranks, const grid::BlockSet& blocks, mesh::SheetMesh& crinkle)
{
	Borders borders;
	if (!ranks.team())
		return borders;
	Team& team = *ranks.team();
	const std::vector<Box> boxes = boxesOf(team, blocks);
	const std::vector<Box> others = boxesOfOthers(team, boxes);
	const LonePolygons lone = lonePolygons(blocks, others, crinkle);
	const auto [across, hang] = matchFaces(team, boxes, lone.faces);
	borders.hangs = hang;

	std::vector<std::uint32_t> dropped;
	for (std::size_t f = 0; f < lone.faces.size(); ++f)
		if (!across[f].empty())
			dropped.push_back(lone.polygons[f]);
	const std::unordered_map<std::uint64_t, double> near = cornersAcross(lone, across, dropped, crinkle);
	if (!dropped.empty())
		dropPolygons(dropped, crinkle);
	borders.faces_elsewhere = dropped.size();

	std::vector<RimVertex> own;
	for (std::uint32_t v = 0; v < crinkle.positions.size(); ++v)
	{
		if (!touchesAny({crinkle.positions[v], crinkle.positions[v]}, others))
			continue;
		RimVertex& vertex = own.emplace_back(gridVertex(blocks, ranks.share().whole, crinkle, v));
		if (const auto found = near.find(nameOf(crinkle.edges[v])); found != near.end())
			vertex.near = found->second;
	}
	shareVertices(team, boxes, own, borders);
	return borders;
}

} // namespace vp::ranks
