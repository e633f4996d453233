#include "listed_block.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"
#include "tries.h"

#include "mesh/build_mesh.h"
#include "mesh/crinkle.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vp::test
{

namespace
{

struct Crinkled
{
	SlicedSheet sheet;
	mesh::SheetMesh mesh;
	std::vector<std::set<CellId>> cells; // per block: those shown
};

Crinkled crinkled(cut::Cutter& cutter, const TestPlane& plane)
{
	Crinkled made{cut(cutter, plane), {}, {}};
	std::vector<mesh::ShownBlock> cuts;
	for (std::uint32_t b = 0; b < made.sheet.slice.cuts.size(); ++b)
	{
		cuts.push_back(mesh::shownBlock(b, made.sheet.slice.cuts[b], made.sheet.slice.seeds.faces_in_plane[b]));
		const std::vector<CellId> cut_cells = made.sheet.cutCells(b);
		made.cells.emplace_back(cut_cells.begin(), cut_cells.end());
		for (const grid::BoundaryIndex::Face& face : cuts.back().faces_in_plane)
			made.cells.back().insert(face.cell);
	}
	made.mesh = mesh::crinkleMesh(cutter.blocks(), cuts);
	return made;
}

// The faces of some cells by their points, with how many of the cells have them.
std::map<std::set<PointId>, int> facesOf(const grid::Block& block, const std::set<CellId>& cells)
{
	std::map<std::set<PointId>, int> count;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          for (const CellId cell : cells)
		          {
			          grid.cellFaces(cell, faces);
			          for (int f = 0; f < faces.size(); ++f)
				          ++count[std::set<PointId>(faces[f].begin(), faces[f].end())];
		          }
	          });
	return count;
}

double volumeOfCells(const grid::Block& block, const std::set<CellId>& cells)
{
	double sum = 0.0;
	for (const CellId cell : cells)
		for (const Tetrahedron& part : cellTetrahedra(block, cell))
			sum += std::abs(volumeOf(part));
	return sum;
}

// Six times the volume that the faces enclose, taken as the fans about their means.
double volumeWithin(const mesh::SheetMesh& mesh)
{
	double sum = 0.0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		Vec3 middle(0.0);
		for (const std::uint32_t v : polygon)
			middle += mesh.positions[v] / static_cast<double>(polygon.size());
		for (std::size_t i = 0; i < polygon.size(); ++i)
			sum += glm::dot(middle,
			                glm::cross(mesh.positions[polygon[i]], mesh.positions[polygon[(i + 1) % polygon.size()]])) /
			       6.0;
	}
	return sum;
}

cut::CutRequest requestOf(const TestPlane& plane)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	return request;
}

std::vector<TestPlane> planesThrough(const grid::Block& block, unsigned seed)
{
	std::vector<TestPlane> planes = randomPlanes(block.bounds, 12, seed);
	const std::vector<TestPlane> hard = degeneratePlanes(block, seed);
	planes.insert(planes.end(), hard.begin(), hard.end());
	return planes;
}

// Faces that no points share, or more than two cells do, are counted otherwise.
bool isConforming(const grid::Block& block)
{
	return block.name != "two_to_one" && block.name != "three_on_a_face";
}

} // namespace

TEST(Crinkle, HoldsTheFacesThatOneShownCellHas)
{
	for (const grid::Block& block : allGrids())
	{
		if (!isConforming(block))
			continue;
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		std::size_t faces = 0;
		for (const TestPlane& plane : planesThrough(block, 31))
		{
			const Crinkled made = crinkled(cutter, plane);
			const auto count = facesOf(block, made.cells[0]);
			std::multiset<std::set<PointId>> found;
			for (std::size_t p = 0; p < made.mesh.polygons(); ++p)
			{
				std::set<PointId> points;
				for (const std::uint32_t v : made.mesh.polygon(p))
				{
					EXPECT_EQ(made.mesh.edges[v].lower, made.mesh.edges[v].higher);
					points.insert(made.mesh.edges[v].lower);
				}
				found.insert(points);
				EXPECT_TRUE(made.cells[0].contains(made.mesh.polygon_cells[p].cell)) << block.name;
			}
			for (const std::set<PointId>& points : found)
			{
				const auto face = count.find(points);
				ASSERT_NE(face, count.end()) << block.name;
				EXPECT_EQ(face->second, 1) << block.name;
				EXPECT_EQ(found.count(points), 1u) << block.name;
			}
			// Faces without area are left out.
			std::size_t expected = 0;
			for (const auto& [points, cells] : count)
				expected += cells == 1;
			if (block.name.find("collapsed") == std::string::npos)
			{
				EXPECT_EQ(found.size(), expected) << block.name;
			}
			else
				EXPECT_LE(found.size(), expected) << block.name;
			faces += found.size();
		}
		EXPECT_GT(faces, 0u) << block.name;
	}
}

TEST(Crinkle, EnclosesTheCells)
{
	Taken taken;
	for (const grid::Block& block : allGrids())
	{
		if (block.name == "three_on_a_face" || block.name == "two_to_one" || !block.inverted.empty())
			continue;
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : planesThrough(block, 32))
		{
			if (!taken.next())
				continue;
			const Crinkled made = crinkled(cutter, plane);
			const double volume = volumeOfCells(block, made.cells[0]);
			EXPECT_NEAR(volumeWithin(made.mesh), volume, 1e-9 * (1.0 + volume)) << block.name;
			Vec3 closed(0.0);
			for (std::size_t p = 0; p < made.mesh.polygons(); ++p)
				closed += mesh::doubleArea(made.mesh, made.mesh.polygon(p));
			EXPECT_LT(glm::length(closed), 1e-9) << block.name;
		}
	}
}

// If only some of the small cells before a large face are shown, the face stays, so that there is no hole.
TEST(Crinkle, HasNoHoleAtFacesWithSeveralNeighbors)
{
	const grid::Block& block = gridNamed("two_to_one");
	const grid::BlockSet set = setOf(block);
	cut::Cutter cutter(set);
	for (const TestPlane& plane : planesThrough(block, 33))
	{
		const Crinkled made = crinkled(cutter, plane);
		std::size_t expected = 0;
		visitGrid(block,
		          [&](const auto& grid)
		          {
			          for (const CellId cell : made.cells[0])
				          for (int f = 0; f < grid.faceCount(cell); ++f)
				          {
					          bool open = true;
					          bool any = false;
					          grid.forEachNeighbor(cell, f,
					                               [&](CellId n)
					                               {
						                               open = any ? open : false;
						                               any = true;
						                               open = open || !made.cells[0].contains(n);
					                               });
					          expected += open;
				          }
		          });
		EXPECT_EQ(made.mesh.polygons(), expected);
	}
}

// Faces are then compared with each other.
TEST(Crinkle, IsTheSameWithoutNeighbors)
{
	std::vector<grid::Block> lists = {listedBlock(hexahedraBlock(warped, 0.0, 2.0, false))}; // it meets itself
	for (const grid::Block& block : allGrids())
		if (std::holds_alternative<grid::UnstructuredGrid>(block.grid) && block.name != "three_on_a_face")
			lists.push_back(listedBlock(block));
	std::size_t faces = 0;
	for (const grid::Block& list : lists)
	{
		const grid::BlockSet listed = setOf(list);
		grid::BlockSet linked = listed;
		grid::buildNeighbors(linked);
		cut::Cutter scans(listed), searches(linked);
		for (const TestPlane& plane : planesThrough(linked.blocks[0], 36))
		{
			const cut::Cut scanned = scans.cut(requestOf(plane)).value();
			const cut::Cut searched = searches.cut(requestOf(plane)).value();
			const mesh::SheetMesh here = scanned.crinkle(listed, 0), there = searched.crinkle(linked, 0);
			EXPECT_EQ(here.polygons(), there.polygons()) << list.name;
			EXPECT_EQ(here.positions.size(), there.positions.size()) << list.name;
			EXPECT_NEAR(measure::measure(listed, here, {}).area, measure::measure(linked, there, {}).area, 1e-9)
			    << list.name;
			faces += here.polygons();
		}
	}
	EXPECT_GT(faces, 1000u);
}

TEST(Crinkle, ClosesAcrossSeams)
{
	for (const Place place : {Place(warped), Place(straight)})
	{
		const grid::BlockSet two = setOfBlocks({latticeBlock(place, 0.0, false), latticeBlock(place, 1.0, true)});
		const grid::BlockSet of_itself = setOfBlocks({hexahedraBlock(place, 0.0, 2.0, false)});
		const grid::BlockSet whole = setOfBlocks({hexahedraBlock(place, 0.0, 2.0, true)});
		cut::Cutter of_whole(whole);
		for (const grid::BlockSet* set : {&two, &of_itself})
		{
			cut::Cutter cutter(*set);
			for (const TestPlane& plane : randomPlanes(set->bounds(), 40, 34))
			{
				const Crinkled here = crinkled(cutter, plane);
				const Crinkled there = crinkled(of_whole, plane);
				EXPECT_EQ(here.mesh.polygons(), there.mesh.polygons());
				EXPECT_EQ(here.mesh.positions.size(), there.mesh.positions.size());
				EXPECT_NEAR(measure::measure(*set, here.mesh, {}).area, measure::measure(whole, there.mesh, {}).area,
				            1e-9);
				EXPECT_NEAR(volumeWithin(here.mesh), volumeWithin(there.mesh), 1e-9);
			}
		}
	}
}

// A cube beside four cubes of half its size, which are another block. Counted by hand.
TEST(Crinkle, HidesALargeFaceWhereSmallOnesCoverIt)
{
	std::vector<grid::Block> blocks(2);
	blocks[0].grid = grid::UniformGrid({2, 2, 2}, Vec3(0.0), Vec3(1.0));
	blocks[1].grid = grid::UniformGrid({2, 3, 3}, Vec3(1.0, 0.0, 0.0), Vec3(0.5));
	for (grid::Block& block : blocks)
		grid::finishBlock(block);
	const grid::BlockSet set = setOfBlocks(std::move(blocks));
	cut::Cutter cutter(set);
	// Two small cells: they hide a face each, and half of the large one.
	EXPECT_EQ(crinkled(cutter, {{0.5, 0.2, 0.5}, {0.0, 1.0, 0.0}}).mesh.polygons(), 6u + 2 * 4);
	// All four: each has two neighbors of its size.
	EXPECT_EQ(crinkled(cutter, {{1.12, 0.0, 0.0}, {1.0, 0.1, 0.1}}).mesh.polygons(), 5u + 4 * 3);
}

TEST(Crinkle, IsOfWholeCellsInAWindow)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.in_generations = true;
	probe::Sheet sheet = probe::makeSheet({0.1, 1.6, 0.2}, {0.3, 0.5, 0.8});
	sheet.window = probe::centeredWindow(0.5, 0.4);
	request.probe.sheets = {sheet};
	const cut::Cut slice = std::move(cutter.cut(std::move(request)).value());
	const mesh::SheetMesh mesh = slice.crinkle(set, 0);
	std::set<CellId> cells;
	for (const mesh::BlockCell& from : slice.mesh(set, 0).polygon_cells)
		cells.insert(from.cell);
	ASSERT_FALSE(cells.empty());
	EXPECT_NEAR(volumeWithin(mesh), volumeOfCells(set.blocks[0], cells), 1e-9);
}

TEST(Crinkle, IsTheSameOfSpans)
{
	Taken taken;
	for (const char* name : {"shell", "blob", "graded", "left_handed"})
	{
		const grid::Block& block = gridNamed(name);
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : planesThrough(block, 35))
		{
			if (!taken.next())
				continue;
			cut::CutRequest request;
			request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
			const mesh::SheetMesh mesh = cutter.cut(request)->crinkle(set, 0);
			const mesh::SheetMesh expected = crinkled(cutter, plane).mesh;
			EXPECT_EQ(mesh.polygons(), expected.polygons()) << name;
			EXPECT_EQ(mesh.positions.size(), expected.positions.size()) << name;
			EXPECT_NEAR(volumeWithin(mesh), volumeWithin(expected), 1e-9) << name;
		}
	}
}

TEST(Crinkle, OfAGridSurfaceIsItsLayer)
{
	const grid::Block& shell = gridNamed("shell");
	const grid::BlockSet set = setOf(shell);
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.in_generations = true;
	request.surface = surface::GridIndex{1, 4.5};
	const cut::Cut slice = std::move(cutter.cut(std::move(request)).value());
	const std::size_t n = grid::latticeCellsOf(shell)->lattice().cells()[0];
	EXPECT_EQ(slice.mesh(set, 0).polygons(), n * n);
	EXPECT_EQ(slice.crinkle(set, 0).polygons(), 2 * n * n + 4 * n);
	const std::vector<CellId>& cells = slice.sheets[0].cuts[0].cells().cells;
	EXPECT_NEAR(volumeWithin(slice.crinkle(set, 0)), volumeOfCells(shell, {cells.begin(), cells.end()}), 1e-9);
}

} // namespace vp::test
