#include "pair_checks.h"
#include "precision_sets.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

using Real = long double;
using Vec = glm::vec<3, Real>;

// The shortest edge of a cell that has length.
double shortestEdge(const grid::Block& block, CellId cell)
{
	double shortest = 1e300;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          grid.cellFaces(cell, faces);
		          for (int f = 0; f < faces.size(); ++f)
			          for (std::size_t i = 0; i < faces[f].size(); ++i)
				          shortest = std::min(shortest, glm::length(grid.point(faces[f][i]) -
				                                                    grid.point(faces[f][(i + 1) % faces[f].size()])));
	          });
	return shortest;
}

// Against the crossing in long double of the same edge and plane. Where an edge runs almost along the plane, the place
// on it is a matter of the coordinates' own rounding.
struct Shifts
{
	std::size_t measured = 0;
	std::size_t along = 0; // the plane
	double most = 0.0;     // in shortest edges

	void add(const Pair& pair)
	{
		const mesh::SheetMesh& mesh = pair.sheet.mesh;
		const Vec normal(Side(pair.plane).normal());
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
		{
			const grid::Block& block = pair.set.blocks[mesh.polygon_cells[p].block];
			const double shortest = shortestEdge(block, mesh.polygon_cells[p].cell);
			for (const std::uint32_t v : mesh.polygon(p))
			{
				const auto [a, b] = visitGrid(
				    block, [&](const auto& grid)
				    { return std::pair(Vec(grid.point(mesh.edges[v].lower)), Vec(grid.point(mesh.edges[v].higher))); });
				const Real da = glm::dot(normal, a - Vec(pair.plane.origin));
				const Real db = glm::dot(normal, b - Vec(pair.plane.origin));
				constexpr Real kShallow = 1e-4;
				if (std::abs(da - db) < kShallow * glm::length(b - a))
				{
					++along;
					continue;
				}
				++measured;
				const Vec exact = a + da / (da - db) * (b - a);
				most = std::max(most, double(glm::length(Vec(mesh.positions[v]) - exact)) / shortest);
			}
		}
	}
};

// Planes along the wall within its layers, across them, and anywhere.
std::vector<TestPlane> planesOf(const Box& box, double layers)
{
	std::vector<TestPlane> planes = randomPlanes(box, 40, 24);
	for (std::size_t i = 0; i < planes.size(); ++i)
	{
		if (i % 2)
			planes[i].normal = {0.001 * double(i), -0.002, 1.0};
		if (i % 4 < 2)
			planes[i].origin.z = box.lo.z + layers * double(i);
	}
	return planes;
}

Shifts checkAll(const RawSet& raw, double layers)
{
	const grid::BlockSet set = build(raw);
	EXPECT_TRUE(set.blocks[0].inverted.empty());
	cut::Cutter cutter(set);
	Shifts shifts;
	for (const TestPlane& asked : planesOf(set.bounds(), layers))
	{
		const TestPlane plane{asked.origin, probe::makeSheet(asked.origin, asked.normal).normal};
		const Pair pair{raw, set, asked, plane, cut(cutter, asked), isGeneric(set, plane)};
		checkCells(pair);
		checkVertices(pair);
		checkAreas(pair);
		checkWatertight(pair);
		shifts.add(pair);
	}
	EXPECT_GT(shifts.measured, 5000u);
	EXPECT_LT(shifts.along, shifts.measured / 4);
	return shifts;
}

} // namespace

TEST(Precision, WallCellsOfAMillionthInADomainOfThirty)
{
	for (const bool as_hexahedra : {false, true})
		EXPECT_LT(checkAll(nearWall(Vec3(0.0), as_hexahedra), 1e-7).most, 1e-3);
}

TEST(Precision, CellsOfAHundredthAtTenMillion)
{
	for (const bool as_hexahedra : {false, true})
		EXPECT_LT(checkAll(farAway(as_hexahedra), 1e-3).most, 1e-3);
}

} // namespace vp::test
