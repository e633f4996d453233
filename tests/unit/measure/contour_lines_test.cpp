#include "measure/contour_lines.h"

#include "exhaustive.h"
#include "grid/demo/demo.h"
#include "measure/cell_steps.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vp::test
{

namespace
{

using measure::Contours;
using measure::PlaneLine;
using Uv = glm::dvec2;

double areaOf(const std::vector<PlaneLine>& outlines)
{
	double twice = 0.0;
	for (const PlaneLine& line : outlines)
		for (std::size_t i = 0; i < line.points.size(); ++i)
		{
			const Uv& a = line.points[i];
			const Uv& b = line.points[(i + 1) % line.points.size()];
			twice += a.x * b.y - a.y * b.x;
		}
	return 0.5 * twice;
}

double areaOf(const mesh::SheetMesh& mesh, const Vec3& normal)
{
	double twice = 0.0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		twice += glm::dot(mesh::doubleArea(mesh, mesh.polygon(p)), normal);
	return 0.5 * twice;
}

std::vector<double> valuesOf(const mesh::SheetMesh& mesh, const std::function<double(const Vec3&)>& value)
{
	std::vector<double> values;
	for (const Vec3& p : mesh.positions)
		values.push_back(value(p));
	return values;
}

Vec3 worldOf(const probe::Sheet& sheet, const Uv& uv)
{
	return sheet.origin + uv.x * sheet.xAxis() + uv.y * sheet.up;
}

// Levels on and between values, beyond them on either side.
std::vector<double> levelsFor(const std::vector<double>& values)
{
	const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
	std::vector<double> levels{*lo - 1.0};
	for (const double part : {0.05, 0.3, 0.31, 0.5, 0.77, 0.95})
		levels.push_back(*lo + part * (*hi - *lo));
	levels.push_back(*hi + 1.0);
	return levels;
}

void forAllGrids(const std::function<void(const SlicedSheet&, const Box&)>& check)
{
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet blocks = setOf(block);
		cut::Cutter cutter(blocks);
		for (const TestPlane& plane : randomPlanes(blocks.bounds(), 3, 11))
			check(cut(cutter, plane), blocks.bounds());
		for (const TestPlane& plane : degeneratePlanes(block, 12))
			check(cut(cutter, plane), blocks.bounds());
	}
}

std::vector<PlaneLine> allLines(const Contours& contours, std::size_t levels)
{
	std::vector<PlaneLine> all;
	for (std::size_t i = 0; i < levels; ++i)
		for (PlaneLine& line : contours.lines(i))
			all.push_back(std::move(line));
	return all;
}

// The shell's middle, where s is sin(3x) cos(2y).
SlicedSheet shellSheet(cut::Cutter& cutter)
{
	return cut(cutter, {{0.0, 1.5, 0.0}, {0.0, 0.0, 1.0}});
}

} // namespace

TEST(ContourLines, OfALinearFieldLieWhereItHasTheLevel)
{
	std::size_t lines = 0;
	forAllGrids(
	    [&](const SlicedSheet& sheet, const Box& box)
	    {
		    if (sheet.mesh.polygons() == 0)
			    return;
		    const std::vector<double> values = valuesOf(sheet.mesh, linearAt);
		    const auto triangles = measure::planeTriangles(sheet.mesh, sheet.slice.sheet, values);
		    const std::vector<double> levels = levelsFor(values);
		    const Contours contours(triangles, levels);
		    const double tolerance = 1e-11 * (10.0 + glm::length(box.lo) + glm::length(box.hi));
		    for (std::size_t i = 0; i < levels.size(); ++i)
			    for (const PlaneLine& line : contours.lines(i))
			    {
				    ++lines;
				    for (const Uv& uv : line.points)
					    ASSERT_NEAR(linearAt(worldOf(sheet.slice.sheet, uv)), levels[i], tolerance);
			    }
		    EXPECT_TRUE(contours.lines(0).empty());
		    EXPECT_TRUE(contours.lines(levels.size() - 1).empty());
	    });
	EXPECT_GT(lines, 500u);
}

// Their areas add up to the slice's: nothing is left out between two and nothing is there twice.
TEST(ContourLines, AreasBetweenLevelsCoverTheSlice)
{
	const auto wavy = [](const Vec3& p) { return std::sin(5.0 * p.x) * std::cos(4.0 * p.y) + 0.3 * p.z; };
	forAllGrids(
	    [&](const SlicedSheet& sheet, const Box&)
	    {
		    if (sheet.mesh.polygons() == 0)
			    return;
		    const std::vector<double> values = valuesOf(sheet.mesh, wavy);
		    const auto triangles = measure::planeTriangles(sheet.mesh, sheet.slice.sheet, values);
		    const std::vector<double> levels = levelsFor(values);
		    const Contours contours(triangles, levels);
		    const double whole = areaOf(sheet.mesh, sheet.slice.sheet.normal);
		    double sum = 0.0;
		    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
			    sum += areaOf(contours.area(i, i + 1));
		    EXPECT_NEAR(sum, whole, 1e-9 * (1.0 + std::abs(whole)));
		    EXPECT_NEAR(areaOf(contours.area(Contours::kNoLevel, Contours::kNoLevel)), whole,
		                1e-9 * (1.0 + std::abs(whole)));
		    EXPECT_TRUE(contours.area(Contours::kNoLevel, 0).empty());
	    });
}

TEST(ContourLines, OfALinearFieldBoundAreasOfTheRightSize)
{
	const grid::BlockSet blocks = grid::makeDemo("blob", 8).value();
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
	const auto triangles =
	    measure::planeTriangles(sheet.mesh, sheet.slice.sheet, valuesOf(sheet.mesh, [](const Vec3& p) { return p.x; }));
	const Contours contours(triangles, {-1.0, 0.5});
	EXPECT_NEAR(areaOf(contours.area(0, 1)), 1.5 * 6.0, 1e-12);
	EXPECT_NEAR(areaOf(contours.area(Contours::kNoLevel, 0)), 2.0 * 6.0, 1e-12);
	EXPECT_NEAR(areaOf(contours.area(1, Contours::kNoLevel)), 2.5 * 6.0, 1e-12);
	const std::vector<PlaneLine> lines = contours.lines(1);
	ASSERT_EQ(lines.size(), 1u);
	EXPECT_FALSE(lines[0].closed);
	EXPECT_NEAR(glm::length(lines[0].points.front() - lines[0].points.back()), 6.0, 1e-12);
}

TEST(ContourLines, AreWholeAndCloseAroundAPeak)
{
	const grid::BlockSet blocks = grid::makeDemo("shell", 40).value();
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = shellSheet(cutter);
	const Vec3 peak{0.0, 1.9, 0.0};
	const auto triangles = measure::planeTriangles(
	    sheet.mesh, sheet.slice.sheet, valuesOf(sheet.mesh, [&](const Vec3& p) { return glm::length(p - peak); }));
	const std::vector<PlaneLine> lines = Contours(triangles, {0.5}).lines(0);
	ASSERT_EQ(lines.size(), 1u);
	EXPECT_TRUE(lines[0].closed);
	EXPECT_GT(lines[0].points.size(), 20u);
	for (const Uv& uv : lines[0].points)
		EXPECT_NEAR(glm::length(worldOf(sheet.slice.sheet, uv) - peak), 0.5, 0.02);
	// Higher values lie on the left: the peak of the distance is outside.
	EXPECT_NEAR(areaOf(lines), -std::acos(-1.0) * 0.25, 0.02);
}

TEST(ContourLines, LevelsThroughVerticesGiveEachLineOnce)
{
	const grid::BlockSet blocks = grid::makeDemo("blob", 6).value(); // points at whole numbers
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {{0.0, 0.0, 0.25}, {0.0, 0.0, 1.0}});
	const auto triangles = measure::planeTriangles(
	    sheet.mesh, sheet.slice.sheet, valuesOf(sheet.mesh, [](const Vec3& p) { return std::max(p.x, -p.x); }));
	const Contours contours(triangles, {1.0, 2.0});
	for (std::size_t level = 0; level < 2; ++level)
	{
		const std::vector<PlaneLine> lines = contours.lines(level);
		ASSERT_EQ(lines.size(), 2u);
		for (const PlaneLine& line : lines)
			EXPECT_NEAR(glm::length(line.points.front() - line.points.back()), 6.0, 1e-12);
	}
	EXPECT_EQ(allLines(contours, 2).size(), 4u);
}

TEST(ContourLines, NanIsAHoleInTheSlice)
{
	const grid::BlockSet blocks = grid::makeDemo("blob", 6).value();
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {{0.0, 0.0, 0.25}, {0.0, 0.0, 1.0}});
	const auto triangles =
	    measure::planeTriangles(sheet.mesh, sheet.slice.sheet,
	                            valuesOf(sheet.mesh, [](const Vec3& p) { return p.x > 1.5 ? std::nan("") : p.y; }));
	const Contours contours(triangles, {0.25});
	EXPECT_NEAR(areaOf(contours.area(Contours::kNoLevel, Contours::kNoLevel)), 4.0 * 6.0, 1e-12);
	EXPECT_NEAR(areaOf(measure::outlinesOf(triangles.points, triangles.nan_triangles)), 2.0 * 6.0, 1e-12);
	const std::vector<PlaneLine> lines = contours.lines(0);
	ASSERT_EQ(lines.size(), 1u);
	EXPECT_NEAR(glm::length(lines[0].points.front() - lines[0].points.back()), 4.0, 1e-12);
}

TEST(ContourLines, OfPolygonsRunAlongTheirSides)
{
	const grid::BlockSet blocks = grid::makeDemo("blob", 6).value();
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {{0.0, 0.0, 0.25}, {0.0, 0.0, 1.0}});
	const std::vector<Uv> points = measure::planePoints(sheet.mesh, sheet.slice.sheet);
	std::vector<double> values;
	std::vector<std::uint32_t> groups;
	for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
	{
		Uv center(0.0);
		for (const std::uint32_t v : sheet.mesh.polygon(p))
			center += points[v] / 4.0;
		const bool within = std::abs(center.x) < 2.0 && std::abs(center.y) < 1.0;
		values.push_back(within ? 7.0 : 3.0);
		groups.push_back(within ? 1 : 0);
	}
	const std::vector<PlaneLine> lines = measure::stepLines(sheet.mesh, points, values, 5.0);
	ASSERT_EQ(lines.size(), 1u); // and none along the rim
	EXPECT_TRUE(lines[0].closed);
	EXPECT_NEAR(areaOf(lines), 8.0, 1e-12);
	EXPECT_TRUE(measure::stepLines(sheet.mesh, points, values, 2.0).empty());
	const auto outlines = measure::groupOutlines(sheet.mesh, points, groups, 3);
	EXPECT_NEAR(areaOf(outlines[0]), 28.0, 1e-12);
	EXPECT_NEAR(areaOf(outlines[1]), 8.0, 1e-12);
	EXPECT_TRUE(outlines[2].empty());
	EXPECT_NEAR(areaOf(measure::meshOutlines(sheet.mesh, points)), 36.0, 1e-12);
}

TEST(ContourLines, StepsChainIntoLines)
{
	using Names = std::vector<std::uint64_t>;
	EXPECT_EQ(measure::chained({{2, 3}, {1, 2}, {3, 4}}), (std::vector<Names>{{1, 2, 3, 4}}));
	EXPECT_EQ(measure::chained({{5, 6}, {6, 7}, {7, 5}}), (std::vector<Names>{{5, 6, 7, 5}}));
	// Two rings that touch in a place: each step once.
	std::size_t steps = 0;
	for (const Names& line : measure::chained({{1, 2}, {2, 3}, {3, 1}, {3, 4}, {4, 5}, {5, 3}}))
	{
		EXPECT_EQ(line.front(), line.back());
		steps += line.size() - 1;
	}
	EXPECT_EQ(steps, 6u);
	EXPECT_TRUE(measure::chained({}).empty());
}

// A hundred thousand lines through one place take no longer than as many elsewhere.
TEST(ContourLines, StepsMayMeetInOnePlace)
{
	constexpr std::uint64_t kLines = 200'000;
	std::vector<measure::PlaneStep> steps;
	for (std::uint64_t i = 1; i <= kLines; ++i)
	{
		steps.push_back({i, 0});
		steps.push_back({0, kLines + i});
	}
	const auto lines = measure::chained(std::move(steps));
	EXPECT_EQ(lines.size(), kLines);
	for (const auto& line : lines)
		ASSERT_EQ(line.size(), 3u);
}

} // namespace vp::test
