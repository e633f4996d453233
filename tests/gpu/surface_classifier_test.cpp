#include "gpu_fixture.h"
#include "random_expression.h"
#include "sliced_sheet.h"
#include "surface_words.h"
#include "test_grids.h"
#include "uploaded.h"

#include "grid/demo/demo.h"

#include <fmt/format.h>

namespace vp::test
{

namespace
{

using surface::Axes;
using surface::Expression;
using surface::PlacedExpression;
using surface::Quadric;

SurfaceWords classify(classify::GpuBlocks& blocks, const Quadric& quadric)
{
	return classifyAllCells(blocks, 0, quadric);
}

SurfaceWords classify(classify::GpuBlocks& blocks, const std::string& text)
{
	SCOPED_TRACE(text);
	const Result<Expression> expression = Expression::parse(text);
	EXPECT_TRUE(expression) << expression.error().message;
	return classifyAllCells(blocks, 0, PlacedExpression(*expression, {}));
}

Axes tilted(const Vec3& origin)
{
	const Vec3 z = glm::normalize(Vec3(0.3, 0.5, 0.81));
	const Vec3 x = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), z));
	return {origin, x, glm::cross(z, x), z};
}

// Three that cross any grid with these bounds: a bowl, waves, and one with roots and slopes.
std::vector<std::string> expressionsThrough(const Box& bounds)
{
	const Vec3 c = bounds.center();
	const Vec3 s = 1.0 / glm::max(bounds.size(), Vec3(1e-6));
	const std::string x = fmt::format("{}*(x - ({}))", s.x, c.x);
	const std::string y = fmt::format("{}*(y - ({}))", s.y, c.y);
	const std::string z = fmt::format("{}*(z - ({}))", s.z, c.z);
	return {fmt::format("({})^2 + ({})^2 = 0.1 + 0.4*{}", x, y, z),
	        fmt::format("0.2*sin(7*{})*cos(5*{}) = {}", x, y, z),
	        fmt::format("hypot({}, {}) - 0.3 - 0.2*tanh(3*{})", x, y, z)};
}

} // namespace

using GpuSurfaceClassifier = GpuTest;

TEST_F(GpuSurfaceClassifier, AgreesWithTheCpuOnEveryGrid)
{
	SurfaceWords all;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet set = setOf(block);
		const auto blocks = upload(device(), set);
		const Axes axes = tilted(block.bounds.center());
		std::vector<SurfaceWords> codes{classify(*blocks, Quadric::sphere(0.3 * block.bounds.diagonal()).placed(axes)),
		                                classify(*blocks, Quadric::sphere(2.0).placed({})),
		                                classify(*blocks, Quadric::cone(35.0).placed(axes))};
		for (const std::string& text : expressionsThrough(block.bounds))
			codes.push_back(classify(*blocks, text));
		for (const SurfaceWords& of : codes)
		{
			all.cells += of.cells;
			all.cut += of.cut;
			all.walked += of.walked;
		}
	}
	// Points on a surface, as lattices have them, are left open; few others.
	EXPECT_GT(all.cut, all.cells / 20);
	EXPECT_LT(20 * all.walked, all.cut);
}

TEST_F(GpuSurfaceClassifier, LeavesFewCellsOfAShellOpen)
{
	const grid::BlockSet set = *grid::makeDemo("shell", 64);
	const auto blocks = upload(device(), set);
	for (const SurfaceWords& codes :
	     {classify(*blocks, Quadric::sphere(0.8).placed(tilted({0.0, 2.0, 0.1}))),
	      classify(*blocks, "x^2 + (y - 2)^2 + (z - 0.1)^2 = 0.64"), classify(*blocks, "sin(3*x)*cos(2*y) + z/2 = 0.1"),
	      classify(*blocks, "atan2(y, x) - 1.5 - 0.1*exp(-z*z)*sqrt(abs(x))")})
	{
		EXPECT_GT(codes.cut, 2000u);
		RecordProperty(fmt::format("walked_of_{}", codes.cut), static_cast<int>(codes.walked));
		EXPECT_LT(50 * codes.walked, codes.cut) << codes.walked << " of " << codes.cut;
	}
}

TEST_F(GpuSurfaceClassifier, ExpressionsMayBePlaced)
{
	for (const char* name : {"shell", "blob", "mixed"})
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		const auto blocks = upload(device(), set);
		const Axes axes = tilted(set.bounds().center());
		const Expression expression = *Expression::parse("x^2 + y*y/2 - z*z*z + 0.1*x*y - 0.4");
		const SurfaceWords codes = classifyAllCells(*blocks, 0, PlacedExpression(expression, axes));
		EXPECT_GT(codes.cut, 10u);
		EXPECT_LT(20 * codes.walked, codes.cut);
	}
}

// Each with a constant that its values pass, over a grid of -3..3.
TEST_F(GpuSurfaceClassifier, EveryFunctionHasItsBound)
{
	const grid::BlockSet set = *grid::makeDemo("graded", 24);
	const auto blocks = upload(device(), set);
	for (const char* text : {"abs(x + y) - 1.1",
	                         "acos(x/4 + y/9) - 1.3",
	                         "asin(x/4 + y/9) - 0.2",
	                         "atan(x*y) - 0.4",
	                         "atan2(x - 0.1, y + z) - 0.7",
	                         "cbrt(x + y*z) - 0.9",
	                         "cos(x + 4*y) - 0.3*z",
	                         "cosh(x - y) - 4",
	                         "exp(x - y) - 3",
	                         "hypot(x, y) - 1.7",
	                         "ln(x*x + 0.1) - y",
	                         "log10(4 + x) - 0.5 + y/9",
	                         "log2(4 + x) - y",
	                         "max(x, y, z) - 0.9",
	                         "min(x, y - z) + 0.7",
	                         "pow(4 + x, y/2) - 2",
	                         "sin(30*x + y) - 0.4*z",
	                         "sinh(x + y) - 2",
	                         "sqrt(4 + x) - y",
	                         "tan(x/2 + y/9) - z",
	                         "tanh(x - y) - 0.6",
	                         "x^7 - 100*y",
	                         "(x + 4)^-3 - 0.02 + y/100",
	                         "x/(y + 4) - z/3",
	                         "100*x*1e-2 - 3.3e-1*y - z",
	                         "sqrt(x) - y",
	                         "ln(x) + z",
	                         "1/x - y",
	                         "asin(x) - z"})
	{
		const SurfaceWords codes = classify(*blocks, text);
		EXPECT_GT(codes.cut, 50u) << text;
		RecordProperty(text, fmt::format("{} of {}", codes.walked, codes.cut));
	}
	// If the function is defined everywhere, few cells stay undecided.
	for (const char* text : {"abs(x + y) - 1.1", "cos(x + 4*y) - 0.3*z", "exp(x - y) - 3", "tanh(x - y) - 0.6"})
	{
		const SurfaceWords codes = classify(*blocks, text);
		EXPECT_LT(20 * codes.walked, codes.cut) << text;
	}
}

TEST_F(GpuSurfaceClassifier, AgreesOnRandomExpressions)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	const auto blocks = upload(device(), set);
	std::mt19937 random(23);
	std::size_t certain = 0;
	for (int round = 0; round < 40; ++round)
	{
		const std::string text = "x - 0.2 + " + randomExpression(random, 1 + round % 5);
		if (!Expression::parse(text))
			continue;
		const SurfaceWords codes = classify(*blocks, text);
		certain += 2 * codes.walked < codes.cells;
	}
	EXPECT_GT(certain, 15u);
}

TEST_F(GpuSurfaceClassifier, FarFromTheOriginQuadricsLoseNothing)
{
	grid::Block block = gridNamed("warped_curvilinear");
	const Vec3 far(1e7, -1e7, 2e7);
	const auto& points = std::get<grid::CurvilinearGrid>(block.grid);
	std::vector<double> xyz;
	for (PointId p = 0; p < points.pointCount(); ++p)
		for (int axis = 0; axis < 3; ++axis)
			xyz.push_back(points.point(p)[axis] + far[axis]);
	block.grid = grid::CurvilinearGrid(points.points(), grid::Points(Array<double>(std::move(xyz))));
	block.fields.clear();
	grid::finishBlock(block);
	const grid::BlockSet set = setOf(block);
	const auto blocks = upload(device(), set);
	const SurfaceWords codes =
	    classify(*blocks, Quadric::sphere(0.3 * block.bounds.diagonal()).placed(tilted(block.bounds.center())));
	EXPECT_GT(codes.cut, 20u);
	EXPECT_LT(10 * codes.walked, codes.cut);
}

} // namespace vp::test
