#include "mesh/boundary_surface.h"
#include "seamed_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace vp::test
{

namespace
{

// How many edges of the surface are in an odd number of polygons.
std::size_t openEdges(const mesh::SheetMesh& mesh)
{
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
			++uses[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
	}
	return static_cast<std::size_t>(std::ranges::count_if(uses, [](const auto& u) { return u.second % 2 != 0; }));
}

double areaOf(const mesh::SheetMesh& mesh)
{
	double area = 0.0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		area += 0.5 * glm::length(mesh::doubleArea(mesh, mesh.polygon(p)));
	return area;
}

} // namespace

TEST(BoundarySurface, HasTheFacesOfEveryGridAtTheirPoints)
{
	std::size_t closed = 0;
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOfBlocks({block});
		const mesh::SheetMesh mesh = mesh::boundarySurface(set);
		// As many as the block has that are not degenerate, counted by their sets of points.
		std::size_t expected = 0;
		std::visit(
		    [&](const auto& grid)
		    {
			    grid::CellFaces faces;
			    for (const auto& face : block.boundary.faces)
			    {
				    grid.cellFaces(face.cell, faces);
				    const auto points = faces[static_cast<int>(face.face)];
				    const bool on_seam =
				        set.interfaces.of(0) && !set.interfaces.of(0)->of(face.cell, face.face).empty();
				    expected += !on_seam && std::set<PointId>(points.begin(), points.end()).size() > 2;
			    }
			    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
			    {
				    EXPECT_EQ(mesh.edges[v].t, 0.0);
				    EXPECT_EQ(grid.point(mesh.edges[v].lower), mesh.positions[v]);
			    }
		    },
		    block.grid);
		EXPECT_EQ(mesh.polygons(), expected) << block.name;
		EXPECT_EQ(mesh.edges.size(), mesh.positions.size());
		closed += openEdges(mesh) == 0;
	}
	EXPECT_GE(2 * closed, allGrids().size());
}

TEST(BoundarySurface, SeamsAreNoBoundary)
{
	for (const Place place : {straight, warped})
	{
		const grid::BlockSet whole = setOfBlocks({hexahedraBlock(place, 0.0, 2.0, true)});
		const mesh::SheetMesh expected = mesh::boundarySurface(whole);
		EXPECT_EQ(expected.polygons(), 4u * 2 * kSteps * kSteps + 2u * kSteps * kSteps);
		EXPECT_EQ(openEdges(expected), 0u);
		const grid::BlockSet sets[] = {
		    setOfBlocks({hexahedraBlock(place, 0.0, 2.0, false)}),
		    setOfBlocks({latticeBlock(place, 0.0, false), latticeBlock(place, 1.0, true)}),
		    setOfBlocks({latticeBlock(place, 0.0, false), hexahedraBlock(place, 1.0, 2.0, true)})};
		for (const grid::BlockSet& set : sets)
		{
			const mesh::SheetMesh mesh = mesh::boundarySurface(set);
			EXPECT_EQ(mesh.polygons(), expected.polygons());
			EXPECT_NEAR(areaOf(mesh), areaOf(expected), 1e-12 * areaOf(expected));
		}
	}
}

TEST(BoundarySurface, OfAnOGridIsTwoTubesAndTwoRings)
{
	const mesh::SheetMesh mesh = mesh::boundarySurface(setOfBlocks({oGrid()}));
	EXPECT_EQ(mesh.polygons(), 4u * 2 * kSteps * kSteps);
	EXPECT_EQ(openEdges(mesh), 0u);
	std::set<std::uint32_t> used(mesh.polygon_vertices.begin(), mesh.polygon_vertices.end());
	EXPECT_EQ(used.size(), mesh.positions.size());
	EXPECT_EQ(used.size(), 4u * kSteps * 2 * kSteps); // round and round: a torus has as many vertices as quadrangles
}

} // namespace vp::test
