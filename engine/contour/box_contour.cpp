#include "contour/box_contour.h"

#include "base/parallel_for.h"
#include "base/timeline.h"
#include "contour/box_traversal.h"
#include "contour/sheet_pieces.h"
#include "grid/shown_value.h"
#include "mesh/build_mesh.h"
#include "mesh/mesh_values.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vp::contour
{

namespace
{

// The whole mesh, not clipped.
mesh::SheetMesh meshOf(const grid::BlockSet& blocks, const std::vector<surface::BlockSurface>& surfaces,
                       const std::vector<find::CellCut>& cuts)
{
	std::vector<mesh::ShownBlock> shown;
	for (std::size_t b = 0; b < cuts.size(); ++b)
		shown.push_back({static_cast<std::uint32_t>(b), &cuts[b]});
	return mesh::buildMesh(blocks, surfaces, shown);
}

} // namespace

std::size_t cellsOf(const mesh::SheetMesh& mesh)
{
	std::size_t cells = 0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		cells += p == 0 || mesh.polygon_cells[p].cell != mesh.polygon_cells[p - 1].cell ||
		         mesh.polygon_cells[p].block != mesh.polygon_cells[p - 1].block;
	return cells;
}

Box rectOf(const cut::SheetCut& sheet, const mesh::SheetMesh& mesh)
{
	Box rect;
	if (const std::optional<probe::Window>& window = sheet.sheet.window)
	{
		rect.include({window->x0, window->y0, 0.0});
		rect.include({window->x1, window->y1, 0.0});
		return rect;
	}
	const Vec3 x_axis = sheet.sheet.xAxis();
	for (const Vec3& p : mesh.positions)
		rect.include({glm::dot(p - sheet.sheet.origin, x_axis), glm::dot(p - sheet.sheet.origin, sheet.sheet.up), 0.0});
	return rect;
}

ClipBox boxOf(const cut::SheetCut& sheet, const Box& rect, std::optional<double> depth)
{
	Box box = rect;
	if (box.empty())
		box.include(Vec3(0.0));
	const double smaller = std::min(box.size().x, box.size().y);
	const double half = 0.5 * depth.value_or(sheet.sheet.window ? smaller : 0.5 * smaller);
	box.lo.z = -half;
	box.hi.z = half;
	return {sheet.sheet, box.lo, box.hi};
}

BoxContourer::BoxContourer(const cut::Cutter& slicer, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                           std::optional<double> depth)
    : BoxContourer(slicer, sheet, mesh, boxOf(sheet, rectOf(sheet, mesh), depth))
{
}

BoxContourer::BoxContourer(const cut::Cutter& slicer, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                           const ClipBox& box)
    : slicer_(slicer), sheet_(sheet), mesh_(mesh), box_(box)
{
	assert(sheet.isPlane() && sheet.field && sheet.field->association == grid::Association::point);
	findValues();
}

// The iso surface depends on the shown numbers of the points, and is linear between them. For the length of a vector
// this is not the number of mesh::vertexValue().
void BoxContourer::findValues()
{
	const grid::BlockSet& blocks = slicer_.blocks();
	const auto fields = sheet_.field->inEach(blocks);
	const auto atPoint = [&](std::uint32_t block, PointId p)
	{
		const grid::Field* field = fields[block];
		if (!field || sheet_.field->component >= field->components)
			return std::numeric_limits<double>::quiet_NaN();
		const auto source =
		    std::visit([&](const auto& grid) { return std::size_t(grid.sourcePoint(p)); }, blocks.blocks[block].grid);
		return grid::shownValue(*field, source, sheet_.field->component);
	};
	const auto ofVertex = [&](std::size_t v)
	{
		if (v < mesh_.edges.size())
		{
			// Weights that are the same to the last bit whichever end has the lower number. An end without a part in
			// the vertex does not bring its NaN to it.
			const mesh::EdgePoint& edge = mesh_.edges[v];
			const double of_lower = 1.0 - edge.t;
			const double low = edge.t == 1.0 ? 0.0 : of_lower * atPoint(edge.block, edge.lower);
			return edge.t == 0.0 ? low : low + (1.0 - of_lower) * atPoint(edge.block, edge.higher);
		}
		double sum = 0.0;
		for (const mesh::PointShare& share : mesh_.rimShares(v))
			sum += share.weight * atPoint(share.block, share.point);
		return sum;
	};
	values_.resize(mesh_.positions.size());
	tracedFor(std::size_t(0), values_.size(), [&](std::size_t v) { values_[v] = ofVertex(v); });
	for (const double value : values_)
		if (std::isfinite(value))
			range_ = range_ ? std::pair(std::min(range_->first, value), std::max(range_->second, value))
			                : std::pair(value, value);
}

// Returns the cells whose polygon has the value. Polygons on the rim of the window are all taken, since a bent iso
// surface may meet a polygon a little beside the place where the polygon's sides have the value. Cells that the iso
// surface does not cut inside the box do no harm.
std::vector<std::vector<CellId>> BoxContourer::seedsOf(double value) const
{
	std::vector<std::vector<CellId>> seeds(slicer_.blocks().blocks.size());
	for (std::size_t p = 0; p < mesh_.polygons(); ++p)
	{
		double least = std::numeric_limits<double>::infinity();
		double most = -least;
		bool on_rim = false;
		for (const std::uint32_t v : mesh_.polygon(p))
		{
			least = std::min(least, values_[v]);
			most = std::max(most, values_[v]);
			on_rim = on_rim || v >= mesh_.edges.size();
		}
		if (on_rim || (least <= value && value <= most))
			seeds[mesh_.polygon_cells[p].block].push_back(mesh_.polygon_cells[p].cell);
	}
	return seeds;
}

mesh::SheetMesh BoxContourer::clippedMesh(const std::vector<surface::BlockSurface>& surfaces,
                                          const std::vector<find::CellCut>& cuts) const
{
	mesh::SheetMesh mesh = meshOf(slicer_.blocks(), surfaces, cuts);
	mesh::clipToSides(box_.frame().origin, box_.sides(), mesh::Corners::keep, mesh);
	return mesh;
}

bool BoxContourer::mayHave(double value) const
{
	return range_ && value >= range_->first && value <= range_->second;
}

Result<Contour> BoxContourer::grow(double value, Timeline* timeline, std::stop_token stop) const
{
	const TimedSection section(timeline, "contour");
	Contour contour;
	contour.value = value;
	if (!mayHave(value))
		return contour;
	const grid::BlockSet& blocks = slicer_.blocks();
	const auto surfaces = find::isoSurfaces(blocks, value, sheet_.field);
	const auto cuts = BoxTraversal(slicer_, surfaces, box_).searchFrom(seedsOf(value), std::move(stop));
	if (!cuts)
		return cuts.error();
	for (const find::CellCut& cut : *cuts)
	{
		contour.cells_touched += cut.cells.size();
		contour.generations = std::max(contour.generations, cut.steps);
		contour.seeds += cut.generations() > 0 ? cut.generation_starts[1] : 0;
	}
	contour.mesh = clippedMesh(surfaces, *cuts);
	contour.components = keepOnSheet(blocks, surfaces, box_, contour.mesh);
	contour.cells = cellsOf(contour.mesh);
	return contour;
}

} // namespace vp::contour
