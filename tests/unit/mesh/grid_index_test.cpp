#include "seamed_sets.h"
#include "sliced_sheet.h"

#include "grid/demo/demo.h"
#include "mesh/listed_mesh.h"
#include "mesh/mesh_values.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace vp::test
{

namespace
{

using surface::GridIndex;

mesh::SheetMesh surfaceOf(const grid::BlockSet& set, const GridIndex& at)
{
	return mesh::gridIndexMesh(set, at, find::gridIndexCells(set, at));
}

double areaOf(const grid::BlockSet& set, const GridIndex& at)
{
	return measure::measure(set, surfaceOf(set, at), {}).area;
}

std::vector<const grid::Block*> structuredGrids()
{
	std::vector<const grid::Block*> found;
	for (const grid::Block& block : allGrids())
		if (grid::latticeCellsOf(block))
			found.push_back(&block);
	return found;
}

// The numbers of the source, as the subscripts go by them.
CellId sourceCell(const grid::Block& block, CellId cell)
{
	return static_cast<CellId>(visitGrid(block, [&](const auto& grid) { return grid.sourceCell(cell); }));
}
PointId sourcePoint(const grid::Block& block, PointId point)
{
	return static_cast<PointId>(visitGrid(block, [&](const auto& grid) { return grid.sourcePoint(point); }));
}

// Places along an axis: at points, between them, at both ends.
std::vector<double> someIndices(std::uint32_t cells)
{
	return {0.0, 0.3, 1.0, cells / 2 + 0.75, cells - 1.0, cells - 0.125, double(cells)};
}

template <class Visit>
void forSurfaces(const grid::Block& block, Visit&& visit)
{
	const grid::Lattice lattice = grid::latticeCellsOf(block)->lattice();
	for (int axis = 0; axis < 3; ++axis)
		for (const double index : someIndices(lattice.cells()[axis]))
		{
			SCOPED_TRACE(testing::Message() << block.name << " " << surface::nameOf({axis, index}));
			visit(lattice, GridIndex{axis, index});
		}
}

// A lattice as a reader hands it over when some of its cells are hidden.
grid::Block withHidden(const grid::Block& whole, const std::set<CellId>& hidden)
{
	grid::Block block;
	visitGrid(whole,
	          [&](const auto& grid)
	          {
		          if constexpr (std::is_base_of_v<grid::Lattice, std::decay_t<decltype(grid)>>)
		          {
			          CellListMaker maker;
			          for (PointId p = 0; p < grid.pointCount(); ++p)
				          maker.point(grid.point(p));
			          for (CellId c = 0; c < grid.cellCount(); ++c)
			          {
				          const grid::CellPoints points = grid.cellPoints(c);
				          if (hidden.contains(c))
					          maker.cell(0, {});
				          else
					          maker.cell(12, {points.begin(), points.end()});
			          }
			          block = maker.block("hidden");
			          block.hidden_lattice = grid;
		          }
	          });
	return block;
}

} // namespace

TEST(GridSurface, SpheresOfTheShellHaveTheArea)
{
	const double unit_patch = 2.0 * std::numbers::pi * std::sin(0.45 * std::numbers::pi); // half the longitudes
	for (const double along : {0.0, 0.3, 0.5, 0.93, 1.0})
	{
		const double radius = 1.0 + 2.0 * along;
		const double exact = radius * radius * unit_patch;
		double previous = 0.0;
		for (const int n : {8, 16, 32, 64})
		{
			const grid::BlockSet set = std::move(grid::makeDemo("shell", n).value());
			const double error = std::abs(areaOf(set, {0, along * n}) - exact) / exact;
			if (previous > 0.0)
			{
				EXPECT_LT(error, previous / 3.8) << "n " << n << " radius " << radius;
			}
			previous = error;
		}
		EXPECT_LT(previous, 1e-3);
	}
}

// Half planes of constant longitude, cones of constant latitude.
TEST(GridSurface, TheOtherSurfacesOfTheShellHaveTheArea)
{
	constexpr double latitude = 0.45 * std::numbers::pi;
	const grid::BlockSet set = std::move(grid::makeDemo("shell", 64).value());
	EXPECT_NEAR(areaOf(set, {1, 17.0}) / (latitude * 8.0), 1.0, 1e-3);
	const double cone = std::cos(latitude * (2.0 * 20.5 / 64.0 - 1.0));
	EXPECT_NEAR(areaOf(set, {2, 20.5}) / (4.0 * std::numbers::pi * cone), 1.0, 1e-3);
}

TEST(GridSurface, ShowsEachCellOfItsLayerOnce)
{
	for (const grid::Block* block : structuredGrids())
	{
		const grid::BlockSet set = setOf(*block);
		forSurfaces(*block,
		            [&](const grid::Lattice& lattice, const GridIndex& at)
		            {
			            const auto cuts = find::gridIndexCells(set, at);
			            const auto cells = lattice.cells();
			            const std::size_t all = lattice.cellCount() / cells[at.axis];
			            EXPECT_EQ(std::set(cuts[0].cells().cells.begin(), cuts[0].cells().cells.end()).size(), all);
			            EXPECT_EQ(cuts[0].cells().cells.size(), all); // and no other was looked at
			            EXPECT_EQ(cuts[0].cells().cut_cells, all);
			            const double low_side = at.index == 0.0 ? 0.0 : std::ceil(at.index) - 1.0;
			            for (const CellId cell : cuts[0].cells().cells)
				            EXPECT_EQ(lattice.cellIndex(sourceCell(*block, cell))[at.axis], low_side);
		            });
	}
}

TEST(GridSurface, LiesBetweenThePointsOnEitherSideAndTheirValues)
{
	for (const grid::Block* block : structuredGrids())
	{
		const grid::BlockSet set = setOf(*block);
		const grid::FieldChoice linear{"linear", grid::Association::point, 0};
		forSurfaces(*block,
		            [&](const grid::Lattice& lattice, const GridIndex& at)
		            {
			            const mesh::SheetMesh mesh = surfaceOf(set, at);
			            const auto fields = linear.inEach(set);
			            ASSERT_EQ(mesh.edges.size(), mesh.positions.size());
			            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
			            {
				            const Vec3 lower =
				                visitGrid(*block, [&](const auto& grid) { return grid.point(mesh.edges[v].lower); });
				            const Vec3 higher =
				                visitGrid(*block, [&](const auto& grid) { return grid.point(mesh.edges[v].higher); });
				            const auto from = lattice.pointIndex(sourcePoint(*block, mesh.edges[v].lower));
				            const auto to = lattice.pointIndex(sourcePoint(*block, mesh.edges[v].higher));
				            for (int axis = 0; axis < 3; ++axis)
					            EXPECT_EQ(to[axis] - from[axis], axis == at.axis ? 1u : 0u);
				            EXPECT_NEAR(from[at.axis] + mesh.edges[v].t, at.index, 1e-12);
				            EXPECT_LT(glm::length(mesh.positions[v] - (lower + mesh.edges[v].t * (higher - lower))),
				                      1e-14 * (1.0 + glm::length(lower)));
				            EXPECT_NEAR(mesh::vertexValue(set, mesh, v, fields, 0), linearAt(mesh.positions[v]), 1e-12);
			            }
		            });
	}
}

TEST(GridSurface, SharesItsVerticesAndFacesWhereTheIndexGrows)
{
	for (const char* name : {"shell", "graded", "left_handed", "warped_curvilinear"})
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		forSurfaces(set.blocks[0],
		            [&](const grid::Lattice& lattice, const GridIndex& at)
		            {
			            const mesh::SheetMesh mesh = surfaceOf(set, at);
			            EXPECT_EQ(mesh.positions.size(), lattice.pointCount() / lattice.points()[at.axis]);
			            EXPECT_EQ(mesh.polygons(), lattice.cellCount() / lattice.cells()[at.axis]);
			            EXPECT_EQ(measure::measure(set, mesh, {}).components, 1u);
			            for (std::size_t p = 0; p < mesh.polygons(); ++p)
			            {
				            // Towards the face of the cell where the subscript is higher.
				            const CellId cell = mesh.polygon_cells[p].cell;
				            const int axis = grid::latticeCellsOf(set.blocks[0])->axisInCells(at.axis);
				            visitGrid(set.blocks[0],
				                      [&](const auto& grid)
				                      {
					                      grid::CellFaces faces;
					                      grid.cellFaces(cell, faces);
					                      Vec3 along(0.0);
					                      for (const PointId q : faces[2 * axis + 1])
						                      along += grid.point(q);
					                      for (const PointId q : faces[2 * axis])
						                      along -= grid.point(q);
					                      EXPECT_GT(glm::dot(mesh::doubleArea(mesh, mesh.polygon(p)), along), 0.0);
				                      });
			            }
		            });
	}
}

TEST(GridSurface, LeavesOutWhatHasNoArea)
{
	const grid::BlockSet set = setOf(gridNamed("collapsed_axis"));
	bool left_out = false;
	forSurfaces(set.blocks[0],
	            [&](const grid::Lattice&, const GridIndex& at)
	            {
		            const auto cuts = find::gridIndexCells(set, at);
		            const mesh::SheetMesh mesh = mesh::gridIndexMesh(set, at, cuts);
		            left_out = left_out || mesh.polygons() < cuts[0].cells().cut_cells;
		            for (std::size_t p = 0; p < mesh.polygons(); ++p)
			            EXPECT_GT(glm::length(mesh::doubleArea(mesh, mesh.polygon(p))), 0.0);
	            });
	EXPECT_TRUE(left_out);
}

TEST(GridSurface, HiddenCellsStayHidden)
{
	const grid::Block& whole = gridNamed("warped_curvilinear");
	const grid::Lattice lattice = grid::latticeCellsOf(whole)->lattice();
	std::mt19937 random(7);
	std::set<CellId> hidden;
	for (CellId c = 0; c < lattice.cellCount(); ++c)
		if (random() % 3 == 0)
			hidden.insert(c);
	const grid::BlockSet set = setOf(withHidden(whole, hidden));
	const grid::BlockSet bare = setOf(whole);
	forSurfaces(whole,
	            [&](const grid::Lattice&, const GridIndex& at)
	            {
		            // Per cell of the whole surface: what shows it, itself or the cell on the other side.
		            std::size_t expected = 0;
		            std::set<std::size_t> shown;
		            const surface::GridLayers layers = surface::layersOf(at.index, lattice.cells()[at.axis]);
		            const auto all = find::gridIndexCells(bare, at);
		            for (const CellId cell : all[0].cells().cells)
		            {
			            const CellId other = lattice.neighbor(cell, 2 * at.axis + 1);
			            if (!hidden.contains(cell))
				            shown.insert(cell);
			            else if (layers.has_other_side && !hidden.contains(other))
				            shown.insert(other);
			            else
				            continue;
			            ++expected;
		            }
		            const mesh::SheetMesh mesh = surfaceOf(set, at);
		            EXPECT_EQ(mesh.polygons(), expected);
		            std::set<std::size_t> found;
		            const auto& grid = std::get<grid::UnstructuredGrid>(set.blocks[0].grid);
		            for (const mesh::BlockCell& from : mesh.polygon_cells)
			            found.insert(grid.sourceCell(from.cell));
		            EXPECT_EQ(found, shown);
		            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
		            {
			            const mesh::EdgePoint& edge = mesh.edges[v];
			            const std::uint32_t a =
			                lattice.pointIndex(static_cast<PointId>(grid.sourcePoint(edge.lower)))[at.axis];
			            const std::uint32_t b =
			                lattice.pointIndex(static_cast<PointId>(grid.sourcePoint(edge.higher)))[at.axis];
			            EXPECT_NEAR((1.0 - edge.t) * a + edge.t * b, at.index, 1e-12);
		            }
	            });
}

TEST(GridSurface, CellsMayBeTurnedDown)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	const std::vector<grid::CellFilter> filter{[](CellId cell) { return cell % 2 == 0; }};
	const auto cuts = find::gridIndexCells(set, {2, 3.5}, filter);
	EXPECT_GT(cuts[0].cells().cells.size(), 0u);
	EXPECT_TRUE(std::ranges::all_of(cuts[0].cells().cells, filter[0]));
}

// u = 1, where two blocks meet: the first one's last surface, the second one's first.
TEST(GridSurface, OnASeamIsShownOnce)
{
	const grid::BlockSet apart = setOfBlocks({latticeBlock(warped, 0.0, false)});
	const double side = areaOf(apart, {0, kSteps});
	const auto mirrored = [](double u, double v, double w) { return warped(2.0 - u, v, w); };
	// The second block's i runs against the first one's, so that i = kSteps is one surface of both.
	const grid::BlockSet set = setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(+mirrored, 0.0, false)});
	EXPECT_EQ(set.interfaces.seam_faces, 2u * kSteps * kSteps);
	EXPECT_NEAR(areaOf(set, {0, kSteps}), side, 1e-12);
	EXPECT_EQ(surfaceOf(set, {0, kSteps}).polygons(), std::size_t(kSteps * kSteps));
	// Elsewhere each block has a surface of its own.
	const mesh::SheetMesh both = surfaceOf(set, {0, kSteps - 0.5});
	EXPECT_EQ(both.polygons(), 2u * kSteps * kSteps);
	EXPECT_EQ(measure::measure(set, both, {}).components, 2u);
}

// Side by side, along an edge that both cut at places of their own.
TEST(GridSurface, AcrossASeamVerticesAreOneWhereTheyAreOnePlace)
{
	const auto beside = [](double u, double v, double w) { return warped(u, v + 1.0, w); };
	const auto beside_backwards = [](double u, double v, double w) { return warped(1.0 - u, v + 1.0, w); };
	const grid::BlockSet along = setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(+beside, 0.0, false)});
	const grid::BlockSet against =
	    setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(+beside_backwards, 0.0, false)});
	const std::size_t apart = 2 * (kSteps + 1) * (kSteps + 1);
	for (const double index : {1.3, 2.0, 2.3})
	{
		EXPECT_EQ(surfaceOf(along, {0, index}).positions.size(), apart - (kSteps + 1)) << index;
		EXPECT_EQ(measure::measure(along, surfaceOf(along, {0, index}), {}).components, 1u) << index;
		// 2 is the middle, where the surfaces meet.
		EXPECT_EQ(surfaceOf(against, {0, index}).positions.size(), index == 2.0 ? apart - (kSteps + 1) : apart);
	}
}

TEST(GridSurface, IsCheckedAgainstTheBlocks)
{
	const grid::BlockSet shell = setOf(gridNamed("shell"));
	EXPECT_TRUE(find::checkGridIndex(shell, {0, 0.0, 9.0}));
	for (const double outside : {-0.1, 9.1, 1e300})
		for (const surface::GridIndexRange& range :
		     {surface::GridIndexRange{1, outside, 2.0}, surface::GridIndexRange{1, 2.0, outside}})
		{
			const Status fits = find::checkGridIndex(shell, range);
			ASSERT_FALSE(fits);
			EXPECT_EQ(fits.error().kind, ErrorKind::usage);
			EXPECT_NE(fits.error().message.find("j runs from 0 to 9"), std::string::npos) << fits.error().message;
		}
	const Status none = find::checkGridIndex(setOf(gridNamed("tets")), {0, 1.0, 1.0});
	ASSERT_FALSE(none);
	EXPECT_EQ(none.error().kind, ErrorKind::input);
	// A block that ends before the index has no part in the surface.
	grid::BlockSet two = shell;
	two.blocks.push_back(gridNamed("graded"));
	EXPECT_TRUE(find::checkGridIndex(two, {0, 8.5, 8.5}));
	const mesh::SheetMesh mesh = surfaceOf(two, {0, 8.5});
	for (const mesh::BlockCell& from : mesh.polygon_cells)
		EXPECT_EQ(from.block, 0u);
}

} // namespace vp::test
