#include "grid/demo/demo.h"
#include "grid/measure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vp::grid
{
namespace
{

Block demo(const char* name, int n)
{
	Result<BlockSet> set = makeDemo(name, n);
	EXPECT_TRUE(set);
	return std::move(set->blocks.at(0));
}

double volume(const Block& block)
{
	return std::visit(
	    [](const auto& grid)
	    {
		    CellFaces faces;
		    double sum = 0.0;
		    for (std::size_t c = 0; c < grid.cellCount(); ++c)
		    {
			    const double v = signedVolume(grid, static_cast<CellId>(c), faces);
			    EXPECT_GT(v, 0.0);
			    sum += v;
		    }
		    return sum;
	    },
	    block.grid);
}

std::size_t cellCount(const Block& block)
{
	return std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid);
}

TEST(Demo, VolumesAndCounts)
{
	constexpr int n = 24;
	// Between the spheres, over half the longitudes and sin(lat) within +-sin(0.45 pi).
	const double shell = (27.0 - 1.0) / 3.0 * std::numbers::pi * 2.0 * std::sin(0.45 * std::numbers::pi);
	for (const char* name : {"shell", "hexes", "tets"})
		// Chords for arcs: the error falls with the square of n.
		EXPECT_NEAR(volume(demo(name, n)) / shell, 1.0, 4.0 / (n * n)) << name;
	for (const char* name : {"blob", "graded", "mixed"})
		EXPECT_NEAR(volume(demo(name, n)), 216.0, 1e-4) << name;
	for (const char* name : {"shell", "hexes", "blob", "graded"})
		EXPECT_EQ(cellCount(demo(name, n)), std::size_t(n * n * n)) << name;
	EXPECT_EQ(cellCount(demo("tets", n)), std::size_t(5 * n * n * n));
}

TEST(Demo, ConformsWhereItIsSplit)
{
	constexpr int n = 10;
	EXPECT_EQ(demo("tets", n).boundary.faces.size(), std::size_t(6 * 2 * n * n));
	EXPECT_EQ(demo("hexes", n).boundary.faces.size(), std::size_t(6 * n * n));
	for (const int m : {1, 2, 3, 10})
	{
		const Block block = demo("mixed", m);
		validate(block);
		double area = 0.0;
		const auto& grid = std::get<UnstructuredGrid>(block.grid);
		CellFaces faces;
		for (const BoundaryIndex::Face& face : block.boundary.faces)
		{
			grid.cellFaces(face.cell, faces);
			const auto ids = faces[face.face];
			area += glm::length(polygonArea(ids.size(), [&](std::size_t i) { return grid.point(ids[i]); }));
		}
		EXPECT_NEAR(area, 216.0, 1e-4) << m;
	}
}

TEST(Demo, LayerIsThinAtTheWallAndCloses)
{
	constexpr int n = 12;
	const Block block = demo("layer", n);
	validate(block);
	EXPECT_GT(volume(block), 0.0); // each cell's is
	EXPECT_EQ(cellCount(block), std::size_t(n / 2 * n * n + n / 2 * n * n * 2));
	// A prism has two triangles on the wall and the outside, and on one of the two ends of the span nothing more.
	EXPECT_EQ(block.boundary.faces.size(), std::size_t(2 * n * n + 2 * (n / 2 * n + n / 2 * n * 2) + 2 * n * n));
	const auto& grid = std::get<UnstructuredGrid>(block.grid);
	double least = INFINITY;
	double most = 0.0;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		if (grid.shape(c) != CellShape::hexahedron)
			continue;
		const CellPoints points = grid.cellPoints(c);
		const auto length = [&](int a, int b)
		{ return glm::length(grid.point(points.id[b]) - grid.point(points.id[a])); };
		const double aspect = length(0, 4) / length(0, 3);
		least = std::min(least, aspect);
		most = std::max(most, aspect);
	}
	EXPECT_NEAR(least, 1.0, 0.1);
	EXPECT_NEAR(most, 10000.0, 1000.0);
}

TEST(Demo, MixedHasEveryShape)
{
	const Block block = demo("mixed", 9);
	const auto& grid = std::get<UnstructuredGrid>(block.grid);
	std::array<std::size_t, 5> count{};
	for (CellId c = 0; c < grid.cellCount(); ++c)
		++count[static_cast<int>(grid.shape(c))];
	// Three layers of 81 lattice cells each; those split have 12 tetrahedra, with a pyramid for two of them at the
	// wedges.
	EXPECT_EQ(count, (std::array<std::size_t, 5>{243 * 12 - 2 * 81, 81, 2 * 243, 243, 0}));
}

TEST(Demo, PointsOfTheShell)
{
	constexpr int n = 8;
	const Block block = demo("shell", n);
	const auto& grid = std::get<CurvilinearGrid>(block.grid);
	const double r = 1.0 + 2.0 * 3 / n;
	const double lon = std::numbers::pi * 5 / n;
	const double lat = std::numbers::pi * (-0.45 + 0.9 * 6 / n);
	const Vec3 p = grid.point(grid.pointId(3, 5, 6));
	EXPECT_NEAR(p.x, r * std::cos(lat) * std::cos(lon), 1e-6);
	EXPECT_NEAR(p.y, r * std::cos(lat) * std::sin(lon), 1e-6);
	EXPECT_NEAR(p.z, r * std::sin(lat), 1e-6);
	EXPECT_FALSE(grid.coordinates().isDouble());
}

TEST(Demo, FieldsFollowTheFormula)
{
	for (const Demo& each : demos())
	{
		const Block block = demo(each.name, 5);
		validate(block);
		ASSERT_EQ(block.fields.size(), 2u);
		EXPECT_EQ(block.fields[0].name, "s");
		EXPECT_EQ(block.fields[1].name, "v");
		std::visit(
		    [&](const auto& grid)
		    {
			    for (PointId p = 0; p < grid.pointCount(); ++p)
			    {
				    const Vec3 x = grid.point(p);
				    const std::size_t source = grid.sourcePoint(p);
				    EXPECT_NEAR(block.fields[0].value(source, 0), std::sin(3 * x.x) * std::cos(2 * x.y) + x.z / 2,
				                1e-6);
				    EXPECT_NEAR(block.fields[1].value(source, 0), -x.y, 1e-6);
				    EXPECT_NEAR(block.fields[1].value(source, 1), x.x, 1e-6);
				    EXPECT_NEAR(block.fields[1].value(source, 2), 0.3, 1e-6);
			    }
		    },
		    block.grid);
	}
}

TEST(Demo, GradedAxis)
{
	const Block block = demo("graded", 4);
	const auto& grid = std::get<RectilinearGrid>(block.grid);
	EXPECT_EQ(grid.coordinate(0, 0), -3.0);
	EXPECT_NEAR(grid.coordinate(1, 2), -3.0 + 6.0 * (0.35 + 0.075), 1e-12);
	EXPECT_NEAR(grid.coordinate(2, 4), 3.0, 1e-12);
}

TEST(Demo, ParsesNames)
{
	Result<BlockSet> plain = parseDemo("blob");
	ASSERT_TRUE(plain);
	EXPECT_EQ(plain->cellCount(), std::size_t(64 * 64 * 64));
	EXPECT_STREQ(plain->kind(), "image");
	Result<BlockSet> sized = parseDemo("shell:7");
	ASSERT_TRUE(sized);
	EXPECT_EQ(sized->cellCount(), std::size_t(343));
	EXPECT_STREQ(sized->kind(), "curvilinear");
	for (const char* wrong : {"", "shel", "shell:", "shell:0", "shell:-4", "shell:1025", "shell:8x", "shell:8:8",
	                          "shell: 8", "hexes:1000", "shell:99999999999"})
	{
		const Result<BlockSet> result = parseDemo(wrong);
		ASSERT_FALSE(result) << wrong;
		EXPECT_EQ(result.error().kind, ErrorKind::input) << wrong;
		EXPECT_NE(result.error().message.find("graded"), std::string::npos) << wrong;
		EXPECT_EQ(result.error().message.find('\n'), std::string::npos) << wrong;
	}
}

} // namespace
} // namespace vp::grid
