// Bodies in contact whose cells do not match, with arrays that jump there.
#include "mesh/mesh_values.h"
#include "mesh/seam_names.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace vp::test
{

namespace
{

// A cube from x = 0 to 1, and four cubes of half its side beside it, which share no points with it.
grid::BlockSet cubeBesideFour()
{
	CellListMaker maker;
	const auto addCube = [&](const Vec3& at, double side)
	{
		std::vector<std::int64_t> ids;
		for (int corner = 0; corner < 8; ++corner)
			ids.push_back(maker.point(at + side * Vec3(((corner + 1) / 2) % 2, (corner / 2) % 2, corner / 4)));
		maker.cell(12, ids);
	};
	addCube(Vec3(0.0), 1.0);
	for (const double y : {0.0, 0.5})
		for (const double z : {0.0, 0.5})
			addCube({1.0, y, z}, 0.5);
	grid::BlockSet set;
	set.blocks.push_back(maker.block("contact"));
	grid::matchInterfaces(set);
	return set;
}

// valueOf(place, is_large, component): at the points, of which the first 8 are those of the large cube.
void addArray(grid::BlockSet& set, const std::string& name, int components,
              const std::function<double(Vec3, bool, int)>& valueOf)
{
	grid::Block& block = set.blocks[0];
	std::vector<double> values(40 * static_cast<std::size_t>(components));
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          for (PointId p = 0; p < grid.pointCount(); ++p)
			          for (int c = 0; c < components; ++c)
				          values[grid.sourcePoint(p) * static_cast<std::size_t>(components) + std::size_t(c)] =
				              valueOf(grid.point(p), grid.sourcePoint(p) < 8, c);
	          });
	block.fields.push_back(grid::makeField(name, grid::Association::point, components, std::move(values)));
}

const TestPlane kLevel{{0.0, 0.0, 0.3}, {0.0, 0.0, 1.0}};

struct Shown
{
	mesh::SheetMesh mesh;
	measure::SheetMeasure figures;
};

Shown show(const grid::BlockSet& set, const grid::FieldChoice& array, cut::CutRequest request = inGenerations(),
           const std::optional<probe::Window>& window = std::nullopt)
{
	cut::Cutter cutter(set);
	request.probe.sheets = {probe::makeSheet(kLevel.origin, kLevel.normal)};
	request.probe.sheets[0].window = window;
	Shown shown;
	shown.mesh = cutter.cut(std::move(request)).value().mesh(set, 0);
	shown.figures = measure::measure(set, shown.mesh, array);
	return shown;
}

} // namespace

// The section of the large cube has the values 0.3 + x^2 + y^2 at its corners, so the mean is 1.3 over an area of 1.
// Those of the two small cubes have 0.15 + x^2 + y^2: the means are 1.9 and 2.4 over an area of 0.25 each. All
// together: (1.3 + 1.9 / 4 + 2.4 / 4) / 1.5 = 19 / 12.
TEST(Contact, EachCellKeepsTheValuesOfItsPoints)
{
	grid::BlockSet set = cubeBesideFour();
	addArray(set, "u", 1, [](Vec3 p, bool, int) { return glm::dot(p, p); });
	const Shown shown = show(set, {"u"});
	EXPECT_NEAR(shown.figures.area, 1.5, 1e-14);
	EXPECT_NEAR(shown.figures.mean.value(), 19.0 / 12.0, 1e-14);
	EXPECT_NEAR(shown.figures.min.value(), 0.3, 1e-14);
	EXPECT_NEAR(shown.figures.max.value(), 0.15 + 2.25 + 1.0, 1e-14);
	EXPECT_EQ(shown.figures.components, 1u);
	// The large section has 4 corners and one where the small ones meet, which have 6 together.
	EXPECT_EQ(shown.mesh.positions.size(), 4u + 1u + 6u);
}

// An array that is the same on both sides makes the sides one, and has the mean of the polygons' own corners. x y z is
// not linear over them.
TEST(Contact, CornersThatAreAddedChangeNoMean)
{
	grid::BlockSet set = cubeBesideFour();
	addArray(set, "u", 1, [](Vec3 p, bool, int) { return p.x * p.y * p.z; });
	const Shown shown = show(set, {"u"});
	EXPECT_TRUE(shown.mesh.seam_pairs.empty());
	// Bilinear over a square: the fan about the mean of the corners gives the mean of the corners.
	const double expected = 0.3 * (0.25 + 0.25 * (1.25 * 0.25 + 1.25 * 0.75)) / 1.5;
	EXPECT_NEAR(shown.figures.mean.value(), expected, 1e-14);
	EXPECT_NEAR(shown.figures.area, 1.5, 1e-14);
}

// A vertex that is added on the side of the large polygon has a vector between those of its ends, which is 0 here.
TEST(Contact, CornersThatAreAddedHaveNoPartInTheRange)
{
	grid::BlockSet set = cubeBesideFour();
	addArray(set, "u", 3,
	         [](Vec3 p, bool is_large, int c) { return c == 0 ? (is_large && p.y == 0.0 ? -2.0 : 2.0) : 0.0; });
	const Shown shown = show(set, {"u", grid::Association::point, grid::kMagnitude});
	EXPECT_FALSE(shown.mesh.is_added.empty());
	EXPECT_EQ(shown.figures.min.value(), 2.0);
	EXPECT_EQ(shown.figures.max.value(), 2.0);
}

TEST(Contact, EachArrayIsJudgedByItself)
{
	grid::BlockSet set = cubeBesideFour();
	addArray(set, "jumps", 1, [](Vec3, bool is_large, int) { return is_large ? 1.0 : 0.0; });
	addArray(set, "goes_on", 1, [](Vec3 p, bool, int) { return 1.0 + p.x + 2.0 * p.y; });
	const Shown shown = show(set, {"jumps"});
	EXPECT_NEAR(shown.figures.mean.value(), 2.0 / 3.0, 1e-14);
	EXPECT_EQ(shown.figures.components, 1u);
	EXPECT_NEAR(measure::measure(set, shown.mesh, grid::FieldChoice{"goes_on"}).mean.value(),
	            (2.5 + 0.5 * (1.0 + 1.25 + 1.0)) / 1.5, 1e-14);
	const RawVector<double> jumps = mesh::vertexValues(set, shown.mesh, grid::FieldChoice{"jumps"}.inEach(set), 0);
	const RawVector<double> goes_on = mesh::vertexValues(set, shown.mesh, grid::FieldChoice{"goes_on"}.inEach(set), 0);
	ASSERT_FALSE(shown.mesh.seam_pairs.empty());
	std::size_t apart = 0;
	for (const auto& [v, w] : shown.mesh.seam_pairs)
	{
		EXPECT_EQ(goes_on[v], goes_on[w]);
		apart += jumps[v] != jumps[w];
	}
	EXPECT_GE(apart, 3u);
}

TEST(Contact, InterpolatedVerticesAreOne)
{
	grid::BlockSet set = cubeBesideFour();
	addArray(set, "u", 1, [](Vec3, bool is_large, int) { return is_large ? 1.0 : 0.0; });
	cut::CutRequest request;
	request.in_generations = true;
	request.hanging = mesh::Hanging::interpolate;
	const Shown shown = show(set, {"u"}, request);
	EXPECT_NEAR(shown.figures.area, 1.5, 1e-14);
	// The small cells have 1 where they meet the large one.
	EXPECT_NEAR(shown.figures.mean.value(), 1.25 / 1.5, 1e-14);
	EXPECT_EQ(shown.figures.components, 1u);
}

// Also where the window leaves nothing of the vertices at which the sides meet.
TEST(Contact, WindowsHoldTheirPartInOnePiece)
{
	grid::BlockSet set = cubeBesideFour();
	addArray(set, "u", 1, [](Vec3, bool is_large, int) { return is_large ? 1.0 : 0.0; });
	const probe::Sheet sheet = probe::makeSheet(kLevel.origin, kLevel.normal);
	const auto along = [&](const Vec3& p)
	{ return glm::dvec2(glm::dot(p - sheet.origin, sheet.xAxis()), glm::dot(p - sheet.origin, sheet.up)); };
	const glm::dvec2 a = along({0.75, 0.1, 0.3});
	const glm::dvec2 b = along({1.25, 0.4, 0.3});
	const Shown shown = show(
	    set, {"u"}, {}, probe::Window{std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)});
	EXPECT_NEAR(shown.figures.area, 0.15, 1e-14);
	EXPECT_NEAR(shown.figures.mean.value(), 0.5, 1e-14);
	EXPECT_EQ(shown.figures.components, 1u);
}

} // namespace vp::test
