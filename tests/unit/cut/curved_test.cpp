#include "sliced_sheet.h"
#include "test_grids.h"
#include "tries.h"
#include "watertight_mesh.h"

#include "grid/demo/demo.h"
#include "grid/shown_value.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace vp::test
{

namespace
{

// A form, and its height in a frame's coordinates by a formula of its own: the same sign.
struct TestForm
{
	const char* text;
	double (*height)(const Vec3& p);
};

const TestForm kForms[] = {
    {"sphere:0.7", [](const Vec3& p) { return glm::length(p) - 0.7; }},
    {"cylinder:0.4", [](const Vec3& p) { return std::hypot(p.x, p.y) - 0.4; }},
    {"cone:35",
     [](const Vec3& p) { return std::hypot(p.x, p.y) - std::abs(p.z) * std::tan(35.0 / 180.0 * std::numbers::pi); }},
    {"ellipsoid:0.9,0.5,0.3", [](const Vec3& p) { return glm::length(p / Vec3(0.9, 0.5, 0.3)) - 1.0; }},
    {"quadric:1,0,-1,0.5,0,0,0,0.3,0,-0.1",
     [](const Vec3& p) { return p.x * p.x - p.z * p.z + 0.5 * p.x * p.y + 0.3 * p.y - 0.1; }},
    {"x*x + y*y - 0.25*z", [](const Vec3& p) { return p.x * p.x + p.y * p.y - 0.25 * p.z; }},
    {"sin(3*x) + cos(2*y) = exp(z)",
     [](const Vec3& p) { return std::sin(3 * p.x) + std::cos(2 * p.y) - std::exp(p.z); }},
    {"sqrt(x) - 0.3", [](const Vec3& p) { return p.x < 0.0 ? -1.0 : std::sqrt(p.x) - 0.3; }},
};

cut::CutRequest requestOf(const std::string& text, const probe::Frame& frame)
{
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets.push_back(probe::makeSheet(frame.origin, frame.normal, frame.up));
	request.probe.sheets[0].form = surface::ImplicitSurface::parse(text).value();
	return request;
}

SlicedSheet cutBy(cut::Cutter& cutter, const cut::CutRequest& request)
{
	cut::Cut slice = std::move(cutter.cut(request).value());
	SlicedSheet sheet{&cutter.blocks(), {}, slice.mesh(cutter.blocks(), 0)};
	sheet.slice = std::move(slice.sheets[0]);
	return sheet;
}

// In the world, with lengths in shares of the block's smallest side.
struct Placed
{
	probe::Frame frame;
	double unit;

	Vec3 local(const Vec3& p) const
	{
		const Vec3 q = p - frame.origin;
		return Vec3(glm::dot(q, frame.xAxis()), glm::dot(q, frame.up), glm::dot(q, frame.normal)) / unit;
	}
};

std::vector<Placed> placesIn(const grid::Block& block)
{
	std::vector<Placed> places;
	for (const TestPlane& plane : randomPlanes(block.bounds, 4, 91))
		places.push_back({probe::makeFrame(plane.origin, plane.normal), 1.0});
	return places;
}

// Cells with points on both sides, by a height of points.
std::vector<CellId> scan(const grid::Block& block, const std::function<double(PointId)>& height)
{
	std::vector<CellId> cells;
	for (CellId c = 0; c < cellCount(block); ++c)
	{
		bool positive = false;
		bool negative = false;
		visitGrid(block,
		          [&](const auto& grid)
		          {
			          grid::CellFaces faces;
			          grid.cellFaces(c, faces);
			          for (const PointId p : faces.points)
				          (height(p) >= 0.0 ? positive : negative) = true;
		          });
		if (positive && negative)
			cells.push_back(c);
	}
	return cells;
}

double areaOf(const grid::BlockSet& set, const SlicedSheet& sheet)
{
	return measure::measure(set, sheet.mesh, {}).area;
}

} // namespace

TEST(Curved, CutsTheCellsThatAScanFindsWithVerticesOnTheSurface)
{
	Taken taken;
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const Placed& place : placesIn(block))
			for (const TestForm& form : kForms)
			{
				if (!taken.next())
					continue;
				const SlicedSheet sheet = cutBy(cutter, requestOf(form.text, place.frame));
				const auto height = [&](const Vec3& p) { return form.height(place.local(p)); };
				EXPECT_EQ(sheet.cutCells(),
				          scan(block, [&](PointId p)
				               { return height(visitGrid(block, [&](const auto& grid) { return grid.point(p); })); }))
				    << block.name << ' ' << form.text;
				const double scale = 1.0 + glm::length(set.bounds().size()) + glm::length(set.bounds().center());
				for (const Vec3& vertex : sheet.mesh.positions)
					EXPECT_LT(std::abs(height(vertex)), 1e-7 * scale) << block.name << ' ' << form.text;
				if (conforms(block))
					expectWatertight(block, sheet.mesh, 2);
				if (testing::Test::HasFailure())
					return;
			}
	}
}

TEST(Curved, AnIsoValueCutsTheCellsThatHoldIt)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		const auto field = std::ranges::find(block.fields, "linear", &grid::Field::name);
		const auto [lo, hi] = grid::fieldRange(*field, 0);
		for (const double share : {0.2, 0.51, 0.8})
		{
			const double value = lo + share * (hi - lo);
			cut::CutRequest request = requestOf("iso:" + std::to_string(value), {});
			const double told = request.probe.sheets[0].form->isoValue()->value;
			request.field = grid::FieldChoice{"linear"};
			const SlicedSheet sheet = cutBy(cutter, request);
			const auto valueAt = [&](PointId p) {
				return visitGrid(block, [&](const auto& grid)
				                 { return grid::shownValue(*field, grid.sourcePoint(p), 0) - told; });
			};
			EXPECT_EQ(sheet.cutCells(), scan(block, valueAt)) << block.name;
			for (const Vec3& vertex : sheet.mesh.positions)
				EXPECT_NEAR(linearAt(vertex), told, 1e-11 * (1.0 + std::max(std::abs(lo), std::abs(hi)))) << block.name;
			if (conforms(block))
				expectWatertight(block, sheet.mesh, 2);
			if (testing::Test::HasFailure())
				return;
		}
	}
}

TEST(Curved, CellsWithoutANumberTakeNoPartInAnIsoSurface)
{
	grid::BlockSet set = std::move(grid::makeDemo("blob", 8).value());
	grid::Block& block = set.blocks[0];
	std::vector<float> values;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          for (PointId p = 0; p < grid.pointCount(); ++p)
			          values.push_back(static_cast<float>(grid.point(p).x));
	          });
	values[9 * 9 * 4 + 9 * 4 + 4] = std::numeric_limits<float>::quiet_NaN(); // in the middle, x = 0
	block.fields.push_back(grid::makeField("hole", grid::Association::point, 1, values));
	cut::Cutter cutter(set);
	cut::CutRequest request = requestOf("iso:0.2", {});
	request.field = grid::FieldChoice{"hole"};
	const SlicedSheet sheet = cutBy(cutter, request);
	EXPECT_EQ(sheet.cutCells().size(), 8u * 8u - 4u);
	for (const Vec3& vertex : sheet.mesh.positions)
		EXPECT_NEAR(vertex.x, 0.2, 1e-6);
}

TEST(Curved, AreasOfASphereAndACylinderConvergeToTheFormulas)
{
	const double pi = std::numbers::pi;
	struct Solid
	{
		const char* demo;
		const char* form;
		Vec3 origin;
		double area;
	};
	Taken taken;
	// The cylinder leaves the box at both ends.
	for (const Solid& solid : {Solid{"blob", "sphere:2", Vec3(0.1, -0.2, 0.3), 16.0 * pi},
	                           Solid{"graded", "cylinder:1.5", Vec3(0.2, 0.1, 0.0), 3.0 * pi * 6.0},
	                           Solid{"mixed", "sphere:2", Vec3(0.1, -0.2, 0.3), 16.0 * pi},
	                           Solid{"shell", "sphere:0.4", Vec3(0.1, 2.0, 0.1), 0.64 * pi},
	                           Solid{"tets", "sphere:0.4", Vec3(0.1, 2.0, 0.1), 0.64 * pi}})
	{
		if (!taken.next())
			continue;
		std::vector<double> errors;
		for (const int n : {16, 32, 64})
		{
			const grid::BlockSet set = std::move(grid::makeDemo(solid.demo, n).value());
			cut::Cutter cutter(set);
			const SlicedSheet sheet = cutBy(cutter, requestOf(solid.form, {solid.origin}));
			errors.push_back(std::abs(areaOf(set, sheet) / solid.area - 1.0));
		}
		EXPECT_LT(errors[2], 0.01) << solid.demo;
		// N^(-2/3) of the cells is the square of the spacing.
		EXPECT_LT(errors[2], errors[0] / 12.0) << solid.demo << ' ' << errors[0] << ' ' << errors[1];
	}
}

TEST(Curved, AClosedPieceThatTouchesNoBoundaryIsFound)
{
	const grid::BlockSet set = std::move(grid::makeDemo("blob", 32).value());
	cut::Cutter cutter(set);
	cut::CutRequest request = requestOf("sphere:0.5", {Vec3(1.0, 0.5, -0.7)});
	const SlicedSheet whole = cutBy(cutter, request);
	EXPECT_GT(whole.cutCellCount(), 0u);
	EXPECT_GT(whole.slice.seeds.tree_tests, 0u);
	request.seeds.mode = seed::SeedMode::boundary;
	EXPECT_EQ(cutBy(cutter, request).cutCellCount(), 0u);
	request.seeds.mode = seed::SeedMode::hotspot;
	const SlicedSheet one = cutBy(cutter, request);
	EXPECT_EQ(one.cutCells(), whole.cutCells());
	EXPECT_EQ(one.slice.seeds.count, 1u);
}

TEST(Curved, AWindowHoldsThePartWithinIt)
{
	for (const char* name : {"shell", "tets", "mixed", "blob"})
	{
		const grid::Block& block = gridNamed(name);
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const Placed& place : placesIn(block))
			for (const char* form : {"sphere:0.7", "cylinder:0.4"})
			{
				cut::CutRequest request = requestOf(form, place.frame);
				SlicedSheet whole = cutBy(cutter, request);
				request.probe.sheets[0].window = probe::centeredWindow(0.8, 0.5);
				const SlicedSheet windowed = cutBy(cutter, request);
				mesh::clipToWindow(windowed.slice.sheet, mesh::Corners::keep, whole.mesh);
				EXPECT_NEAR(areaOf(set, windowed), areaOf(set, whole), 1e-9 * (1.0 + areaOf(set, whole))) << name;
			}
	}
}

} // namespace vp::test
