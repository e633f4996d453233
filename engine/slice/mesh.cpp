#include "slice/mesh.h"

#include "grid/shown_value.h"
#include "slice/cell_mesh.h"
#include "slice/join_vertices.h"
#include "slice/key_numbers.h"
#include "slice/span_mesh.h"
#include "slice/tidy_polygons.h"

#include <cmath>
#include <limits>

namespace vp::slice
{

namespace
{

// The boundary faces in the plane of one block: a corner of theirs is an edge of its own.
template <grid::Grid G>
void addFacesInPlane(const G& grid, const BlockCut& block, SheetMesh& mesh)
{
	KeyNumbers at_point(block.faces_in_plane.size());
	grid::CellFaces faces;
	for (const grid::BoundaryIndex::Face& face : block.faces_in_plane)
	{
		grid.cellFaces(face.cell, faces);
		for (const PointId p : faces[face.face])
		{
			const auto [number, is_new] = at_point.find(p, static_cast<std::uint32_t>(mesh.positions.size()));
			if (is_new)
			{
				mesh.edges.push_back({block.block, p, p, 0.0});
				mesh.positions.push_back(grid.point(p));
			}
			mesh.polygon_vertices.push_back(number);
		}
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({block.block, face.cell});
		++mesh.boundary_polygons;
	}
}

} // namespace

Vec3 doubleArea(const SheetMesh& mesh, std::span<const std::uint32_t> polygon)
{
	Vec3 sum(0.0);
	const Vec3& first = mesh.positions[polygon[0]];
	for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
		sum += glm::cross(mesh.positions[polygon[i]] - first, mesh.positions[polygon[i + 1]] - first);
	return sum;
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

namespace
{

// What is left to do once the polygons of all cut cells are there. normal: of a flat mesh.
void finishMesh(const grid::BlockSet& blocks, std::span<const BlockCut> cuts, MeshDoubts doubts, const Vec3& normal,
                SheetMesh& mesh)
{
	for (const BlockCut& cut : cuts)
		std::visit([&](const auto& grid) { addFacesInPlane(grid, cut, mesh); }, blocks.blocks[cut.block].grid);

	const bool joins = doubts.at_points || mesh.boundary_polygons > 0 || blocks.blocks.size() > 1 ||
	                   blocks.interfaces.of(0) != nullptr;
	if (joins)
		joinVertices(blocks, mesh);
	if (joins || doubts.slivers)
	{
		tidyPolygons(mesh, normal);
		dropUnusedVertices(mesh);
	}
}

} // namespace

SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const BlockCut> cuts)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	const surface::Plane plane = sheet.plane();
	MeshDoubts doubts;
	for (const BlockCut& cut : cuts)
		if (cut.spans)
			doubts = doubts | addSpans(blocks.blocks[cut.block], cut.block, plane, sheet.normal, *cut.spans, mesh);

	for (const BlockCut& cut : cuts)
		if (cut.cut)
			doubts = doubts | addCells(blocks.blocks[cut.block], cut.block, plane, sheet.normal, *cut.cut, mesh);
	finishMesh(blocks, cuts, doubts, sheet.normal, mesh);
	return mesh;
}

SheetMesh buildMesh(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                    std::span<const BlockCut> cuts)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	mesh.flat = false;
	MeshDoubts doubts;
	for (const BlockCut& cut : cuts)
		doubts = doubts | addCells(blocks.blocks[cut.block], cut.block, surfaces[cut.block], Vec3(0.0), *cut.cut, mesh);
	finishMesh(blocks, cuts, doubts, Vec3(0.0), mesh);
	return mesh;
}

double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at)
{
	const auto sources = std::visit(
	    [&](const auto& grid) {
		    return std::pair{grid.sourcePoint(at.lower), grid.sourcePoint(at.higher)};
	    },
	    block.grid);
	return grid::shownValue(field.components, component,
	                        [&](int c)
	                        {
		                        const double a = field.value(sources.first, c);
		                        // An end that has no part in the vertex does not bring its NaN to it.
		                        if (at.t == 0.0)
			                        return a;
		                        const double b = field.value(sources.second, c);
		                        if (field.categorical)
			                        return at.t < 0.5 ? a : at.t > 0.5 ? b : std::min(a, b);
		                        // Between two equal infinities there is no difference to take a part of.
		                        return at.t == 1.0 || a == b ? b : a + at.t * (b - a);
	                        });
}

double vertexValue(const grid::BlockSet& blocks, const SheetMesh& mesh, std::size_t vertex,
                   std::span<const grid::Field* const> fields, int component)
{
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	if (vertex < mesh.edges.size())
	{
		const EdgePoint& edge = mesh.edges[vertex];
		const grid::Field* field = fields[edge.block];
		const bool known = field && component < field->components;
		return known ? interpolate(blocks.blocks[edge.block], *field, component, edge) : kNan;
	}
	int components = 1;
	const auto componentAt = [&](int c)
	{
		double sum = 0.0;
		double most = 0.0;
		for (const PointShare& share : mesh.rimShares(vertex))
		{
			const grid::Field* field = fields[share.block];
			if (!field || c >= field->components)
				return kNan;
			components = field->components;
			const auto source = std::visit([&](const auto& grid) { return std::size_t(grid.sourcePoint(share.point)); },
			                               blocks.blocks[share.block].grid);
			const double value = field->value(source, c);
			if (!field->categorical)
				sum += share.weight * value;
			else if (share.weight > most)
			{
				most = share.weight;
				sum = value;
			}
		}
		return sum;
	};
	const double first = componentAt(std::max(component, 0));
	return component != grid::kMagnitude || std::isnan(first) ? first
	                                                          : grid::shownValue(components, component, componentAt);
}

double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell)
{
	const std::size_t source =
	    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }, block.grid);
	return grid::shownValue(field, source, component);
}

} // namespace vp::slice
