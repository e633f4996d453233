#include "mesh/mesh_values.h"
#include "random_window.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace vp::test
{

namespace
{

using Uv = glm::dvec2;

cut::Cut cutWindow(cut::Cutter& cutter, const probe::Sheet& sheet, mesh::Corners corners = mesh::Corners::keep)
{
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = {sheet};
	request.corners = corners;
	request.field = grid::FieldChoice{"linear"};
	return std::move(cutter.cut(std::move(request)).value());
}

// The witness: the whole plane's polygons, each clipped for itself in the plane.
std::vector<Uv> clippedAt(std::vector<Uv> polygon, int axis, double sign, double limit)
{
	std::vector<Uv> kept;
	const auto beyond = [&](const Uv& p) { return sign * (p[axis] - limit); };
	for (std::size_t i = 0; i < polygon.size(); ++i)
	{
		const Uv a = polygon[i];
		const Uv b = polygon[(i + 1) % polygon.size()];
		if (beyond(a) >= 0.0)
			kept.push_back(a);
		if ((beyond(a) < 0.0) != (beyond(b) < 0.0))
			kept.push_back(a + beyond(a) / (beyond(a) - beyond(b)) * (b - a));
	}
	return kept;
}

double areaOf(const std::vector<Uv>& polygon)
{
	double doubled = 0.0;
	for (std::size_t i = 0; i < polygon.size(); ++i)
	{
		const Uv a = polygon[i];
		const Uv b = polygon[(i + 1) % polygon.size()];
		doubled += a.x * b.y - a.y * b.x;
	}
	return 0.5 * std::abs(doubled);
}

double clippedArea(const mesh::SheetMesh& whole, std::size_t p, const probe::Sheet& sheet)
{
	const probe::Window& w = *sheet.window;
	std::vector<Uv> polygon;
	for (const std::uint32_t v : whole.polygon(p))
	{
		const Vec3 arm = whole.positions[v] - sheet.origin;
		polygon.push_back({glm::dot(arm, sheet.xAxis()), glm::dot(arm, sheet.up)});
	}
	polygon = clippedAt(clippedAt(polygon, 0, 1.0, w.x0), 0, -1.0, w.x1);
	return areaOf(clippedAt(clippedAt(polygon, 1, 1.0, w.y0), 1, -1.0, w.y1));
}

std::vector<grid::BlockSet> sets()
{
	std::vector<grid::BlockSet> found;
	for (const char* name : {"shell", "tets", "blob", "graded", "mixed"})
		found.push_back(setOf(gridNamed(name)));
	found.push_back(setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)}));
	found.push_back(setOfBlocks({oGrid()}));
	return found;
}

} // namespace

TEST(Window, ShowsWhatTheWholeSliceShowsThere)
{
	std::mt19937 random(70);
	std::size_t shown = 0;
	for (const grid::BlockSet& set : sets())
	{
		cut::Cutter cutter(set);
		for (const TestPlane& plane : randomPlanes(set.bounds(), 60, 71))
		{
			probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
			const SlicedSheet whole = cut(cutter, plane);
			sheet.window = randomWindow(set.bounds(), random);
			const cut::Cut slice = cutWindow(cutter, sheet);
			const mesh::SheetMesh mesh = slice.mesh(set, 0);

			double area = 0.0;
			std::set<std::pair<std::uint32_t, CellId>> cells;
			for (std::size_t p = 0; p < whole.mesh.polygons(); ++p)
			{
				const double part = clippedArea(whole.mesh, p, sheet);
				area += part;
				if (part > 1e-12 * sheet.window->width() * sheet.window->height())
					cells.insert({whole.mesh.polygon_cells[p].block, whole.mesh.polygon_cells[p].cell});
			}
			std::set<std::pair<std::uint32_t, CellId>> cut_cells;
			for (std::uint32_t b = 0; b < slice.sheets[0].cuts.size(); ++b)
			{
				const find::CellCut& lane = slice.sheets[0].cuts[b].cells();
				for (std::size_t i = 0; i < lane.cells.size(); ++i)
					if (lane.codes[i] & shared::kCodeCut)
						cut_cells.insert({b, lane.cells[i]});
			}
			EXPECT_TRUE(std::ranges::includes(cut_cells, cells));
			const measure::SheetMeasure measure = measure::measure(set, mesh, slice.sheets[0].field);
			EXPECT_NEAR(measure.area, area, 1e-9 * (area + 1e-6));
			EXPECT_LE(measure.area, sheet.window->width() * sheet.window->height() * (1.0 + 1e-9));
			shown += !cells.empty();
		}
	}
	EXPECT_GT(shown, 100u);
}

TEST(Window, VerticesLieInItAndLinearDataAreExact)
{
	std::mt19937 random(72);
	for (const char* name : {"shell", "tets", "mixed"})
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		cut::Cutter cutter(set);
		const std::vector<const grid::Field*> fields = grid::FieldChoice{"linear"}.inEach(set);
		for (const TestPlane& plane : randomPlanes(set.bounds(), 30, 73))
		{
			probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
			sheet.window = randomWindow(set.bounds(), random);
			const mesh::SheetMesh mesh = cutWindow(cutter, sheet).mesh(set, 0);
			for (std::size_t v = 0; v < mesh.positions.size(); ++v)
			{
				const Uv uv = probe::worldToWindow(sheet, mesh.positions[v]);
				EXPECT_GE(std::min(uv.x, uv.y), -1e-9);
				EXPECT_LE(std::max(uv.x, uv.y), 1.0 + 1e-9);
				EXPECT_NEAR(mesh::vertexValue(set, mesh, v, fields, 0), linearAt(mesh.positions[v]), 1e-11);
			}
			// Cut edges are shared within the window: no edge has more than two polygons, and those with one lie on the
			// rim or on the boundary, which a closed domain's window does not meet.
			std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
			for (std::size_t p = 0; p < mesh.polygons(); ++p)
				for (std::size_t i = 0; i < mesh.polygon(p).size(); ++i)
					++uses[std::minmax(mesh.polygon(p)[i], mesh.polygon(p)[(i + 1) % mesh.polygon(p).size()])];
			for (const auto& [edge, count] : uses)
				EXPECT_LE(count, 2);
		}
	}
}

TEST(Window, InsideOneCellIsOneRectangle)
{
	const grid::BlockSet set = setOf(gridNamed("blob"));
	cut::Cutter cutter(set);
	probe::Sheet sheet = probe::makeSheet({0.11, 0.13, 0.17}, {0.0, 0.0, 1.0});
	sheet.window = probe::centeredWindow(1e-4, 2e-4);
	const cut::Cut slice = cutWindow(cutter, sheet);
	const mesh::SheetMesh mesh = slice.mesh(set, 0);
	EXPECT_EQ(slice.sheets[0].cuts[0].cells().cut_cells, 1u);
	EXPECT_EQ(slice.sheets[0].cuts[0].cells().cells.size(), 1u);
	EXPECT_EQ(mesh.polygons(), 1u);
	EXPECT_EQ(mesh.positions.size(), 4u);
	EXPECT_NEAR(measure::measure(set, mesh, {}).area, 2e-8, 1e-18);
	EXPECT_EQ(cutWindow(cutter, sheet, mesh::Corners::skip).mesh(set, 0).polygons(), 0u);
}

// Cells touched follow the window.
TEST(Window, EndsTheTraversal)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	cut::Cutter cutter(set);
	std::mt19937 random(74);
	for (const TestPlane& plane : randomPlanes(set.bounds(), 60, 75))
	{
		probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
		sheet.window = randomWindow(set.bounds(), random);
		const cut::Cut slice = cutWindow(cutter, sheet);
		// Beside those that show something: cells that the rim touches, and the seed.
		EXPECT_LE(slice.sheets[0].cuts[0].cells().cells.size(), slice.sheets[0].cuts[0].cells().cut_cells + 1);
	}
}

// Behind a large face lie several small cells, of which the window may hold some only.
TEST(Window, AtAnInterfaceCountsWhatReachesIntoIt)
{
	std::mt19937 random(76);
	std::size_t parted = 0; // windows beside which the interface has cells
	const auto compare = [&](const grid::BlockSet& set, const TestPlane& plane)
	{
		cut::Cutter cutter(set);
		probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
		sheet.window = randomWindow(set.bounds(), random);
		const cut::Cut slice = cutWindow(cutter, sheet);
		const seed::SheetWindow window(sheet);
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
		{
			const std::vector<CellId> all = scanCutCells(set.blocks[b], plane);
			std::vector<CellId> expected;
			grid::CellFaces faces;
			visitGrid(set.blocks[b],
			          [&](const auto& grid)
			          {
				          for (const CellId cell : all)
				          {
					          grid.cellFaces(cell, faces);
					          if (window.meetsCell(grid, sheet.plane(), faces))
						          expected.push_back(cell);
				          }
			          });
			const find::CellCut& lane = slice.sheets[0].cuts[b].cells();
			std::vector<CellId> found;
			for (std::size_t i = 0; i < lane.cells.size(); ++i)
				if (lane.codes[i] & shared::kCodeCut)
					found.push_back(lane.cells[i]);
			EXPECT_EQ(sorted(std::move(found)), expected);
			EXPECT_EQ(lane.cut_cells, expected.size());
			parted += !expected.empty() && expected.size() < all.size();
		}
	};
	const grid::BlockSet linked = setOf(gridNamed("two_to_one"));
	const grid::BlockSet seamed = setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)});
	for (const grid::BlockSet* set : {&linked, &seamed})
		for (const TestPlane& plane : randomPlanes(set->bounds(), 200, 77))
			compare(*set, plane);
	EXPECT_GT(parted, 100u);
}

// fx magnifies the content of the smaller window.
TEST(Window, FxShowsTheContentOfASmallerOne)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	cut::Cutter cutter(set);
	probe::Sheet lens = probe::makeSheet({0.0, 1.8, 0.2}, {0.3, 0.5, 0.81});
	lens.window = probe::centeredWindow(1.0, 0.6);
	lens.fx = {4.0, {0.1, -0.05, 0.2}};
	probe::Sheet plain = lens;
	plain.fx = {};
	plain.origin = lens.origin + 0.1 * lens.xAxis() - 0.05 * lens.up + 0.2 * lens.normal;
	plain.window = probe::centeredWindow(0.25, 0.15);
	const cut::Cut through = cutWindow(cutter, lens);
	const cut::Cut at = cutWindow(cutter, plain);
	EXPECT_EQ(through.sheets[0].shown, lens);
	EXPECT_GT(at.sheets[0].cuts[0].cells().cut_cells, 0u);
	EXPECT_EQ(sorted(through.sheets[0].cuts[0].cells().cells), sorted(at.sheets[0].cuts[0].cells().cells));
	const measure::SheetMeasure magnified = measure::measure(set, through.mesh(set, 0), {});
	EXPECT_NEAR(magnified.area, 0.25 * 0.15, 1e-12); // true sizes
}

TEST(Window, CornersMayBeLeftOut)
{
	const grid::BlockSet set = setOf(gridNamed("blob"));
	cut::Cutter cutter(set);
	probe::Sheet sheet = probe::makeSheet({0.1, 0.2, 0.3}, {0.3, 0.5, 0.81});
	sheet.window = probe::centeredWindow(1.5, 1.1);
	const mesh::SheetMesh kept = cutWindow(cutter, sheet).mesh(set, 0);
	const mesh::SheetMesh skipped = cutWindow(cutter, sheet, mesh::Corners::skip).mesh(set, 0);
	EXPECT_EQ(skipped.polygons() + 4, kept.polygons());
	EXPECT_NEAR(measure::measure(set, kept, {}).area, 1.65, 1e-12);
	EXPECT_LT(measure::measure(set, skipped, {}).area, 1.65);
}

} // namespace vp::test
