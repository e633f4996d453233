#include "exhaustive.h"
#include "test_grids.h"

#include "seed/boundary_cut.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace vp::test
{

namespace
{

using Face = std::pair<CellId, std::uint32_t>;

struct Found
{
	std::vector<Face> cut;
	std::vector<Face> flat;
	std::size_t tests;

	bool operator==(const Found&) const = default;
};

Found search(const grid::Block& block, const grid::BoundaryIndex& boundary, const surface::Plane& plane)
{
	Found found;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          const auto to = [](std::vector<Face>& faces)
		          { return [&](const grid::BoundaryIndex::Face& face) { faces.emplace_back(face.cell, face.face); }; };
		          found.tests = seed::visitBoundaryCut(grid, boundary, block.bounds, plane, nullptr, to(found.cut),
		                                               to(found.flat));
	          });
	return found;
}

} // namespace

// Planes at random, and through points, where float cannot tell.
TEST(BoundaryCut, IsTheSameByFoursAndFaceByFace)
{
	std::mt19937 random(7);
	std::normal_distribution<double> normal;
	int by_fours = 0;
	std::size_t cut = 0;
	std::size_t flat = 0;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		grid::BoundaryIndex plain = block.boundary;
		plain.corners = {};
		by_fours += !block.boundary.corners.empty();
		for (int n = 0; n < 40; ++n)
		{
			const Vec3 along = n % 4 ? Vec3(normal(random), normal(random), normal(random)) : Vec3(0.0, 0.0, 1.0);
			const std::size_t at = random() % block.boundary.faces.size();
			Vec3 through = block.bounds.center();
			if (n % 2 == 0)
				visitGrid(block,
				          [&](const auto& grid)
				          {
					          grid::CellFaces faces;
					          grid.cellFaces(block.boundary.faces[at].cell, faces);
					          through = grid.point(faces[0][0]);
				          });
			const surface::Plane plane(through, glm::normalize(along));
			const Found found = search(block, block.boundary, plane);
			EXPECT_EQ(found, search(block, plain, plane));
			cut += found.cut.size();
			flat += found.flat.size();
		}
	}
	EXPECT_GE(by_fours, 4);
	EXPECT_GT(cut, 1000u);
	EXPECT_GT(flat, 0u);
}

} // namespace vp::test
