#include "pair_checks.h"
#include "prism_sets.h"
#include "tries.h"

#include "base/cross2.h"
#include "grid/check/quality.h"
#include "locate/place.h"
#include "mesh/bridges.h"
#include "mesh/host_records.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

constexpr double kExact = 1e-12;

SlicedSheet sheetBy(const grid::BlockSet& blocks, const TestPlane& plane, find::Strategy strategy)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.strategy = strategy;
	cut::Cutter cutter(blocks);
	cut::Cut slice = std::move(cutter.cut(std::move(request)).value());
	SlicedSheet sheet{&blocks, {}, slice.mesh(blocks, 0)};
	sheet.slice = std::move(slice.sheets[0]);
	return sheet;
}

// Vector areas of the polygons of each cell, by its number in the file.
std::array<double, 2> areasOf(const grid::BlockSet& blocks, const SlicedSheet& sheet)
{
	std::array<double, 2> areas{};
	for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
	{
		const CellId cell = sheet.mesh.polygon_cells[p].cell;
		areas[visitGrid(blocks.blocks[0], [&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); })] +=
		    0.5 * glm::dot(mesh::doubleArea(sheet.mesh, sheet.mesh.polygon(p)), sheet.slice.sheet.normal);
	}
	return areas;
}

double areaOf(const shared::PolygonRecord& record)
{
	double twice = 0.0;
	const auto at = [&](std::uint32_t v)
	{ return glm::dvec2(record.uv[2 * v] - record.uv[0], record.uv[2 * v + 1] - record.uv[1]); };
	for (std::uint32_t i = 1; i + 1 < (record.vertices & shared::kRecordVertices); ++i)
	{
		const double part = cross(at(i), at(i + 1));
		EXPECT_GT(part, -1e-6); // what is drawn lies within the polygon
		twice += part;
	}
	return 0.5 * twice;
}

bool holds(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p)
{
	bool inside = false;
	for (std::size_t i = 0; i < polygon.size(); ++i)
	{
		const glm::dvec2& a = polygon[i];
		const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
		if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
			inside = !inside;
	}
	return inside;
}

} // namespace

// The prism's section, and that of the rest of the box with its hole, are told by convex parts.
TEST(Prisms, AreasAndMeansAreThoseOfTheSections)
{
	const grid::FieldChoice linear{"linear", grid::Association::point, 0};
	std::size_t with_holes = 0;
	std::size_t parted = 0;
	for (int i = 0; i < tries(150); ++i)
	{
		const PrismSet set = prismSet(static_cast<unsigned>(i));
		const grid::BlockSet blocks = build(set.raw);
		for (unsigned p = 0; p < 8; ++p)
		{
			SCOPED_TRACE("set " + std::to_string(i) + ", plane " + std::to_string(p));
			const TestPlane plane = prismPlane(set, 8 * static_cast<unsigned>(i) + p);
			const PrismSection of_prism = sectionOfPrism(set, plane);
			const PrismSection of_box = sectionOfBox(set, plane);
			for (const find::Strategy strategy :
			     {find::Strategy::generations, find::Strategy::cells, find::Strategy::scan})
			{
				const SlicedSheet sheet = sheetBy(blocks, plane, strategy);
				const std::array<double, 2> areas = areasOf(blocks, sheet);
				EXPECT_NEAR(areas[0], of_prism.area, kExact);
				EXPECT_NEAR(areas[1], of_box.area - of_prism.area, kExact);
				const measure::SheetMeasure figures = measure::measure(blocks, sheet.mesh, linear);
				EXPECT_NEAR(figures.area, of_box.area, kExact);
				EXPECT_NEAR(figures.mean.value_or(0.0) * of_box.area, of_box.moment, 1e-11);
				// Through corners, pieces may meet in one alone.
				EXPECT_TRUE(figures.components <= 1 || p % 4 == 2);
				double drawn = 0.0;
				for (const shared::PolygonRecord& record :
				     mesh::recordsFromMesh(blocks, sheet.slice.sheet, sheet.mesh, linear))
					drawn += areaOf(record);
				EXPECT_NEAR(drawn, of_box.area, 1e-5);
				for (std::size_t polygon = 0; polygon < sheet.mesh.polygons(); ++polygon)
					with_holes += !mesh::bridgesOf(sheet.mesh.polygon(polygon)).empty();
				parted += sheet.mesh.polygons() > 2;
			}
			if (testing::Test::HasFailure())
				return;
		}
	}
	EXPECT_GT(with_holes, 20u);
	EXPECT_GT(parted, 20u);
}

TEST(Prisms, SectionsAreClosedAndDoNotDependOnTheSide)
{
	for (int i = 0; i < tries(60); ++i)
	{
		const PrismSet set = prismSet(static_cast<unsigned>(i));
		const grid::BlockSet blocks = build(set.raw);
		cut::Cutter cutter(blocks);
		for (unsigned p = 0; p < 4; ++p)
		{
			SCOPED_TRACE("set " + std::to_string(i) + ", plane " + std::to_string(p));
			const TestPlane asked = prismPlane(set, 4 * static_cast<unsigned>(i) + p);
			const TestPlane plane{asked.origin, probe::makeSheet(asked.origin, asked.normal).normal};
			const Pair pair{set.raw, blocks, asked, plane, cut(cutter, asked), isGeneric(blocks, plane)};
			checkCells(pair);
			checkVertices(pair);
			checkWatertight(pair);
			checkInvariance(pair, static_cast<unsigned>(i));
			if (testing::Test::HasFailure())
				return;
		}
	}
}

TEST(Prisms, CellsHoldWhatLiesInThemAndDoNotOverlap)
{
	for (int i = 0; i < tries(60); ++i)
	{
		SCOPED_TRACE(i);
		const PrismSet set = prismSet(static_cast<unsigned>(i));
		const grid::BlockSet blocks = build(set.raw);
		EXPECT_TRUE(grid::checkQuality(blocks).overlaps.empty());
		locate::PlaceFinder finder(blocks);
		Draw draw(static_cast<unsigned>(i));
		for (int n = 0; n < 50; ++n)
		{
			const Vec3 p(draw.real(0.001, 0.999), draw.real(0.001, 0.999), draw.real(0.001, 0.999) * set.height);
			const locate::Place& place = finder.find(set.placed(p));
			ASSERT_TRUE(place.found());
			const auto cell =
			    visitGrid(blocks.blocks[0], [&](const auto& grid) { return std::size_t(grid.sourceCell(place.cell)); });
			EXPECT_EQ(cell, holds(set.polygon, p) ? 0u : 1u);
		}
		if (testing::Test::HasFailure())
			return;
	}
}

} // namespace vp::test
