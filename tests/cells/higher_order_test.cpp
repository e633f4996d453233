// Lagrange, Bezier and quadratic cells of every shape and degree: sections have the analytic area, values are those of
// the cell's polynomials, and the numbering of the file does not matter.
#include "numbered_cells.h"

#include "grid/measure.h"
#include "read/read.h"
#include "sample_files.h"
#include "sliced_sheet.h"

#include <fmt/format.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vp::test
{

namespace
{

enum class Format
{
	xml,
	legacy
};

struct Case
{
	NumberedCell cell;
	std::string version = "2.2";
	Format format = Format::xml;
	int pieces = 1;

	std::string name() const
	{
		std::string text = cell.name + (format == Format::xml ? "_xml" : "_legacy") + version;
		if (pieces > 1)
			text += "_pieces";
		std::ranges::replace(text, '.', '_');
		return text;
	}
};

std::ostream& operator<<(std::ostream& out, const Case& of)
{
	return out << of.name();
}

// All shapes, degrees, families, formats and habits.
std::vector<Case> allCases()
{
	std::vector<Case> cases;
	const auto add = [&](NumberedCell cell, const std::string& suffix = "")
	{
		cell.name += suffix;
		cases.push_back({cell});
	};
	for (const NumberedCell& cell : quadraticCells())
		add(cell);
	for (const Family family : {Family::lagrange, Family::bezier})
		for (int degree = 1; degree <= 8; ++degree)
		{
			add(tetrahedronOf(family, degree));
			add(hexahedronOf(family, {degree, degree, degree}));
			add(wedgeOf(family, degree, degree));
		}
	for (const Family family : {Family::lagrange, Family::bezier})
	{
		for (const std::array<int, 3>& degrees :
		     std::initializer_list<std::array<int, 3>>{{1, 2, 3}, {5, 2, 4}, {8, 1, 3}})
			add(hexahedronOf(family, degrees));
		for (const auto& [across, along] : std::initializer_list<std::array<int, 2>>{{1, 3}, {3, 2}, {6, 1}, {4, 8}})
			add(wedgeOf(family, across, along));
	}
	// Other numberings of wedges, which a file does not tell.
	for (const int degree : {3, 4, 5, 6, 8})
	{
		add(wedgeOf(Family::lagrange, degree, degree, {.upward = true}), "_upward");
		add(wedgeOf(Family::lagrange, degree, degree, {.rings = true}), "_rings");
		add(wedgeOf(Family::lagrange, degree, degree, {.upward = true, .rings = true}), "_upward_rings");
		add(wedgeOf(Family::bezier, degree, 3, {.upward = true, .rings = true}), "_upward_rings");
	}
	// Files of before VTK 9.1, and files whose version is wrong.
	for (const int degree : {2, 3, 6})
	{
		const NumberedCell old = hexahedronOf(Family::lagrange, {degree, degree, degree}, {.swaps_edges = true});
		const NumberedCell present = hexahedronOf(Family::lagrange, {degree, degree, degree});
		const NumberedCell uneven = hexahedronOf(Family::bezier, {degree, 2, 3}, {.swaps_edges = true});
		for (const char* version : {"0.1", "1.0", "2.0", "2.1"})
			cases.push_back({old, version});
		cases.push_back({old, "1.0", Format::xml, 2});
		cases.push_back({old, "1.0", Format::xml, 3});
		cases.push_back({uneven, "1.0"});
		cases.push_back({present, "2.1"});
		for (const char* version : {"4.2", "5.0"})
		{
			cases.push_back({old, version, Format::legacy});
			cases.push_back({uneven, version, Format::legacy});
		}
		cases.push_back({present, "5.1", Format::legacy});
		cases.push_back({wedgeOf(Family::lagrange, degree, degree, {.upward = true}), "1.0"});
		cases.push_back({wedgeOf(Family::lagrange, degree, degree, {.upward = true}), "4.2", Format::legacy});
		cases.push_back({wedgeOf(Family::lagrange, degree, degree), "5.1", Format::legacy});
	}
	return cases;
}

Result<grid::BlockSet> readMesh(const Case& of, const CubeMesh& mesh, int refine = 0,
                                const read::ArrayWish& arrays = {})
{
	const TemporaryFolder folder;
	const std::string path = folder / (of.format == Format::xml ? "cells.vtu" : "cells.vtk");
	if (of.format == Format::xml)
		writeXml(mesh, path, of.version, of.pieces);
	else
		writeLegacy(mesh, path, of.version);
	read::ReadOptions options;
	options.refine = refine;
	options.arrays = arrays;
	return read::readInputs({path}, options, nullptr);
}

const grid::UnstructuredGrid& gridOf(const grid::BlockSet& set)
{
	return std::get<grid::UnstructuredGrid>(set.blocks[0].grid);
}

// The area of the polygons of a mesh, each by itself, and of the figures.
struct Areas
{
	double polygons = 0.0;
	double figures = 0.0;
};

Areas areasOf(const grid::BlockSet& set, const TestPlane& plane)
{
	cut::Cutter cutter(set);
	const SlicedSheet sheet = cut(cutter, plane);
	Areas areas;
	for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
		areas.polygons += 0.5 * glm::length(mesh::doubleArea(sheet.mesh, sheet.mesh.polygon(p)));
	areas.figures = measure::measure(set, sheet.mesh, {}).area;
	return areas;
}

void expectArea(const grid::BlockSet& set, const TestPlane& plane, double expected, double tolerance)
{
	const Areas areas = areasOf(set, plane);
	EXPECT_NEAR(areas.figures, expected, tolerance);
	EXPECT_NEAR(areas.polygons, expected, tolerance);
}

class HigherOrder : public testing::TestWithParam<Case>
{
};
class CurvedCells : public HigherOrder
{
};
class RationalCells : public HigherOrder
{
};

std::vector<Case> casesWith(bool (*has)(const NumberedCell&))
{
	std::vector<Case> cases = allCases();
	std::erase_if(cases, [&](const Case& of) { return !has(of.cell); });
	return cases;
}

std::string nameOf(const testing::TestParamInfo<Case>& info)
{
	return fmt::format("{}_{}", info.index, info.param.name());
}

// The least degree that the cell has along its axes.
int leastDegree(const NumberedCell& cell)
{
	return cell.degrees[0] > 0 ? std::min({cell.degrees[0], cell.degrees[1], cell.degrees[2]}) : 2;
}

// Returns a polynomial of the cell's degree in all directions. One cell is linear along z.
double polynomial(const NumberedCell& cell, Vec3 p)
{
	const double t = 0.3 * p.x - 0.45 * p.y + (cell.name == "QuadraticLinearWedge" ? 0.0 : 0.6 * p.z) + 0.2;
	return 1.0 + 2.0 * std::pow(t, leastDegree(cell)) - p.x + p.z;
}

} // namespace

TEST_P(HigherOrder, StraightCellsAreExact)
{
	const NumberedCell& cell = GetParam().cell;
	CubeMesh mesh = cubeOf(cell, 1);
	setValues(mesh, [&](Vec3 p) { return polynomial(cell, p); });
	const auto set = readMesh(GetParam(), mesh, 1);
	ASSERT_TRUE(set) << set.error().message;

	expectArea(*set, {{0.5, 0.5, 0.43}, {0, 0, 1}}, 1.0, 1e-9);
	expectArea(*set, {{0.37, 0.5, 0.5}, {1, 0, 0}}, 1.0, 1e-9);
	expectArea(*set, {{0.5, 0.61, 0.5}, {0, 1, 0}}, 1.0, 1e-9);
	// From side to side in z.
	expectArea(*set, {{0.5, 0.5, 0.47}, {0.3, -0.25, 1}}, std::sqrt(1.0 + 0.3 * 0.3 + 0.25 * 0.25), 1e-9);
	// A corner: a triangle.
	expectArea(*set, {{0.7, 0, 0}, {1, 1, 1}}, 0.5 * std::sqrt(3.0) * 0.7 * 0.7, 1e-9);

	const grid::UnstructuredGrid& grid = gridOf(*set);
	grid::CellFaces faces;
	double volume = 0.0;
	for (std::size_t c = 0; c < grid.cellCount(); ++c)
		volume += grid::signedVolume(grid, static_cast<CellId>(c), faces);
	// VTK's linear and quadratic wedges begin with a triangle that faces outward. These do not.
	EXPECT_NEAR(cell.shape == ParentShape::wedge && cell.degrees[0] == 0 ? -volume : volume, 1.0, 1e-12);

	if (cell.is_bezier && cell.degree() > 1)
		return; // its values are handles
	const grid::Field& f = set->blocks[0].fields[0];
	ASSERT_EQ(f.name, "f");
	EXPECT_GT(grid.pointCount(), mesh.points.size());
	for (std::size_t p = 0; p < grid.pointCount(); ++p)
	{
		const auto point = static_cast<PointId>(p);
		ASSERT_NEAR(f.value(grid.sourcePoint(point), 0), polynomial(cell, grid.point(point)), 2e-12)
		    << cell.name << " at " << grid.point(point).x << " " << grid.point(point).y << " " << grid.point(point).z;
	}
}

// A map that moves the side x = 1 out by a parabola in y, and keeps planes of the same z.
TEST_P(CurvedCells, SectionsConverge)
{
	CubeMesh mesh = cubeOf(GetParam().cell, 1);
	movePoints(mesh, [](Vec3 p) { return Vec3(p.x * (1.0 + 0.6 * p.y * (1.0 - p.y)), p.y, p.z); });
	std::vector<double> errors;
	for (const int level : {0, 1})
	{
		const auto set = readMesh(GetParam(), mesh, level);
		ASSERT_TRUE(set) << set.error().message;
		const Areas areas = areasOf(*set, {{0.5, 0.5, 0.43}, {0, 0, 1}});
		EXPECT_NEAR(areas.polygons, areas.figures, 1e-12);
		errors.push_back(1.1 - areas.figures);
	}
	const double step = 1.0 / leastDegree(GetParam().cell);
	EXPECT_LT(errors[0], 0.11 * step * step); // chords of the parabola: a h^2 / 6
	EXPECT_NEAR(errors[0] / errors[1], 4.0, 1e-3);
}

// A projective map of the cube onto a frustum, by rational weights. Planes stay planes, and lines stay lines.
TEST_P(RationalCells, WeightsAreTaken)
{
	CubeMesh mesh = cubeOf(GetParam().cell, 1);
	for (Vec3& point : mesh.points)
	{
		const double weight = 1.0 + 0.5 * point.x;
		mesh.weights.push_back(weight);
		point /= weight;
	}
	setValues(mesh, [](Vec3 p) { return p.x + 2.0 * p.y + 3.0 * p.z; });
	// Nobody asks for the arrays of the weights and the degrees.
	const auto set = readMesh(GetParam(), mesh, 0, {false, {"f"}, false});
	ASSERT_TRUE(set) << set.error().message;
	// At x the sides are 1 - x / 2 long, and x ends at 2/3.
	expectArea(*set, {{0.3, 0.2, 0.2}, {1, 0, 0}}, 0.85 * 0.85, 1e-9);
	expectArea(*set, {{0.2, 0.2, 0.31}, {0, 0, 1}}, 2.0 / 3.0 * (1.0 + 2.0 / 3.0) / 2.0, 1e-9);
	const grid::UnstructuredGrid& grid = gridOf(*set);
	const grid::Field& f = set->blocks[0].fields[0];
	for (std::size_t p = 0; p < grid.pointCount(); ++p)
	{
		const Vec3 at = grid.point(static_cast<PointId>(p));
		ASSERT_NEAR(f.value(grid.sourcePoint(static_cast<PointId>(p)), 0), at.x + 2.0 * at.y + 3.0 * at.z, 1e-12);
	}
}

INSTANTIATE_TEST_SUITE_P(Cells, HigherOrder, testing::ValuesIn(allCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Cells, CurvedCells,
                         testing::ValuesIn(casesWith([](const NumberedCell& cell) // that hold the map
                                                     { return !cell.is_bezier && leastDegree(cell) >= 3; })),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Cells, RationalCells,
                         testing::ValuesIn(casesWith([](const NumberedCell& cell) { return cell.is_bezier; })), nameOf);

// A quarter of a ring, which takes weights to be round: a section along a radius is straight, one across it converges.
TEST(HigherOrderRing, WeightsMakeArcs)
{
	const Case ring{hexahedronOf(Family::bezier, {2, 2, 2})};
	CubeMesh mesh = cubeOf(ring.cell, 1);
	for (Vec3& point : mesh.points)
	{
		const double radius = 1.0 + point.x;
		const bool middle = point.y == 0.5;
		mesh.weights.push_back(middle ? std::sqrt(0.5) : 1.0);
		point = Vec3(radius * (point.y < 0.75 ? 1.0 : 0.0), radius * (point.y > 0.25 ? 1.0 : 0.0), point.z);
	}
	std::vector<double> errors;
	for (const int level : {0, 1, 2, 3})
	{
		const auto set = readMesh(ring, mesh, level);
		ASSERT_TRUE(set) << set.error().message;
		expectArea(*set, {{0, 0, 0.5}, {1, -1, 0}}, 1.0, 1e-9);
		errors.push_back(0.75 * M_PI - areasOf(*set, {{0, 0, 0.43}, {0, 0, 1}}).figures);
	}
	for (std::size_t i = 1; i < errors.size(); ++i)
		EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2.0, 0.1);
	EXPECT_LT(errors.back(), 4e-3); // chords of 16 parts: 3/4 pi (pi / 32)^2 / 6
}

} // namespace vp::test
