#include "slice/mesh.h"

#include "slice/cell_polygons.h"
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

// Adds the vertices and polygons of one block.
template <grid::Grid G>
class BlockMesh
{
public:
	BlockMesh(const G& grid, const surface::Plane& plane, const BlockCut& block, std::size_t expected_edges,
	          SheetMesh& mesh)
	    : grid_(grid), plane_(plane), block_(block), mesh_(mesh), vertices_(expected_edges)
	{
	}

	void addCells()
	{
		const traverse::LaneCut& cut = *block_.cut;
		CellPolygons<G> polygons(grid_, plane_);
		for (std::size_t i = 0; i < cut.cells.size(); ++i)
			if (cut.words[i] & shared::kWordCut)
				mesh_.cells_twisted += polygons.visit(cut.cells[i], cut.words[i],
				                                      [&](const auto& edges) { addPolygon(cut.cells[i], edges); });
	}

	// A corner of a face in the plane is an edge of its own.
	void addFacesInPlane()
	{
		grid::CellFaces faces;
		std::vector<std::pair<PointId, PointId>> corners;
		for (const grid::BoundaryIndex::Face& face : block_.faces_in_plane)
		{
			grid_.cellFaces(face.cell, faces);
			corners.clear();
			for (const PointId p : faces[face.face])
				corners.emplace_back(p, p);
			addPolygon(face.cell, corners);
			++mesh_.boundary_polygons;
		}
	}

private:
	std::uint32_t vertexOf(std::pair<PointId, PointId> edge)
	{
		const PointId lower = std::min(edge.first, edge.second);
		const PointId higher = std::max(edge.first, edge.second);
		const auto [number, is_new] =
		    vertices_.find(std::uint64_t(lower) << 32 | higher, static_cast<std::uint32_t>(mesh_.positions.size()));
		if (is_new)
		{
			const Vec3 a = grid_.point(lower);
			const Vec3 b = grid_.point(higher);
			const double da = plane_.signedDistance(a);
			const double db = plane_.signedDistance(b);
			// The signs differ but at the corners of faces in the plane, so this is no division by zero.
			const double t = lower == higher ? 0.0 : da / (da - db);
			mesh_.edges.push_back({block_.block, lower, higher, t});
			mesh_.positions.push_back(t == 1.0 ? b : a + t * (b - a));
		}
		return number;
	}
	void addPolygon(CellId cell, std::span<const std::pair<PointId, PointId>> edges)
	{
		for (const auto& edge : edges)
			mesh_.polygon_vertices.push_back(vertexOf(edge));
		mesh_.polygon_starts.push_back(static_cast<std::uint32_t>(mesh_.polygon_vertices.size()));
		mesh_.polygon_cells.push_back({block_.block, cell});
	}

	const G& grid_;
	const surface::Plane& plane_;
	const BlockCut& block_;
	SheetMesh& mesh_;
	KeyNumbers vertices_;
};

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

SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const BlockCut> cuts)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	const surface::Plane plane = sheet.plane();
	MeshDoubts doubts;
	for (const BlockCut& cut : cuts)
		if (cut.spans)
			doubts = doubts | addSpans(blocks.blocks[cut.block], cut.block, plane, sheet.normal, *cut.spans, mesh);

	std::size_t cells = 0;
	for (const BlockCut& cut : cuts)
		if (cut.cut)
			cells += cut.cut->cut_cells;
	mesh.positions.reserve(mesh.positions.size() + cells + cells / 8);
	mesh.edges.reserve(mesh.edges.size() + cells + cells / 8);
	mesh.polygon_vertices.reserve(mesh.polygon_vertices.size() + 5 * cells);
	mesh.polygon_starts.reserve(mesh.polygons() + cells + 1);
	mesh.polygon_cells.reserve(mesh.polygons() + cells);
	const std::size_t of_spans = mesh.polygons();
	const auto visitBlocks = [&](auto&& visit)
	{
		for (const BlockCut& cut : cuts)
			std::visit([&](const auto& grid) { visit(grid, cut); }, blocks.blocks[cut.block].grid);
	};
	visitBlocks(
	    [&](const auto& grid, const BlockCut& cut)
	    {
		    if (cut.cut)
			    BlockMesh(grid, plane, cut, cut.cut->cut_cells, mesh).addCells();
	    });
	visitBlocks([&](const auto& grid, const BlockCut& cut)
	            { BlockMesh(grid, plane, cut, cut.faces_in_plane.size(), mesh).addFacesInPlane(); });

	// A span's mesh is whole and tidy but for what it tells.
	const bool of_spans_alone = mesh.polygons() == of_spans;
	if (!of_spans_alone || doubts.at_points || blocks.blocks.size() > 1 || blocks.interfaces.of(0))
		joinVertices(blocks, mesh);
	if (!of_spans_alone || doubts.at_points || doubts.slivers || blocks.blocks.size() > 1)
	{
		tidyPolygons(mesh, sheet.normal);
		dropUnusedVertices(mesh);
	}
	return mesh;
}

namespace
{

// The shown number of a tuple whose components `at(c)` gives.
template <class At>
double shownValue(int components, int component, At&& at)
{
	if (component != grid::kMagnitude)
		return at(component);
	if (components == 1)
		return std::abs(at(0));
	double sum = 0.0;
	for (int c = 0; c < components; ++c)
		sum += at(c) * at(c);
	return std::sqrt(sum);
}

} // namespace

double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at)
{
	const auto sources = std::visit(
	    [&](const auto& grid) {
		    return std::pair{grid.sourcePoint(at.lower), grid.sourcePoint(at.higher)};
	    },
	    block.grid);
	return shownValue(field.components, component,
	                  [&](int c)
	                  {
		                  const double a = field.value(sources.first, c);
		                  // An end that has no part in the vertex does not bring its NaN to it.
		                  if (at.t == 0.0)
			                  return a;
		                  const double b = field.value(sources.second, c);
		                  if (field.categorical)
			                  return at.t < 0.5 ? a : at.t > 0.5 ? b : std::min(a, b);
		                  return at.t == 1.0 ? b : a + at.t * (b - a);
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
	return component != grid::kMagnitude || std::isnan(first) ? first : shownValue(components, component, componentAt);
}

double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell)
{
	const std::size_t source =
	    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); }, block.grid);
	return shownValue(field.components, component, [&](int c) { return field.value(source, c); });
}

} // namespace vp::slice
