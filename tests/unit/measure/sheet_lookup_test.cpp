#include "measure/sheet_lookup.h"

#include "exhaustive.h"
#include "grid/demo/demo.h"
#include "measure/plane_triangles.h"
#include "measure/sheet_line.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace vp::test
{

namespace
{

using measure::LinePiece;
using measure::SheetLookup;
using measure::SheetPlace;
using mesh::SheetMesh;
using Uv = glm::dvec2;

void expectWeights(const SheetPlace& place)
{
	for (const double w : place.weight)
	{
		EXPECT_GE(w, 0.0);
		EXPECT_LE(w, 1.0);
	}
	EXPECT_NEAR(std::accumulate(place.weight.begin(), place.weight.end(), 0.0), 1.0, 1e-14);
}

std::vector<double> linearValues(const SheetMesh& mesh)
{
	std::vector<double> values;
	for (const Vec3& position : mesh.positions)
		values.push_back(linearAt(position));
	return values;
}

// A mesh in the plane z = 0 of polygons given as corners; each has vertices of its own.
SheetMesh meshOf(const std::vector<std::vector<Uv>>& polygons)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	for (const std::vector<Uv>& polygon : polygons)
	{
		for (const Uv& corner : polygon)
		{
			mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
			mesh.positions.push_back({corner.x, corner.y, 0.0});
		}
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({0, static_cast<CellId>(mesh.polygon_cells.size())});
	}
	return mesh;
}

// Asked polygon by polygon, even-odd; the last of several.
std::uint32_t lastAt(const SheetMesh& mesh, const std::vector<Uv>& points, const Uv& p)
{
	std::uint32_t last = 0;
	for (std::size_t i = 0; i < mesh.polygons(); ++i)
	{
		bool inside = false;
		const auto polygon = mesh.polygon(i);
		for (std::size_t k = 0; k < polygon.size(); ++k)
		{
			const Uv& a = points[polygon[k]];
			const Uv& b = points[polygon[(k + 1) % polygon.size()]];
			if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
				inside = !inside;
		}
		if (inside)
			last = static_cast<std::uint32_t>(i);
	}
	return last;
}

// The line's pieces are the witness: in the middle of each the lookup finds something, and nothing in gaps.
std::size_t compareAlongLine(const SlicedSheet& sheet, const SheetLookup& lookup, const Uv& a, const Uv& b,
                             double tolerance)
{
	const std::vector<double> values = linearValues(sheet.mesh);
	const std::vector<Uv> points = measure::planePoints(sheet.mesh, sheet.slice.sheet);
	std::size_t places = 0;
	double end = 0.0;
	for (const LinePiece& piece : measure::alongLine(sheet.mesh, points, a, b))
	{
		if (piece.from - end > 1e-6)
		{
			EXPECT_FALSE(lookup.at(a + 0.5 * (end + piece.from) * (b - a)));
		}
		end = piece.to;
		if (piece.to - piece.from < 1e-9)
			continue;
		const Uv uv = a + 0.5 * (piece.from + piece.to) * (b - a);
		const std::optional<SheetPlace> place = lookup.at(uv);
		if (!place)
		{
			ADD_FAILURE() << "nothing at " << uv.x << " " << uv.y;
			continue;
		}
		expectWeights(*place);
		EXPECT_EQ(place->polygon, lastAt(sheet.mesh, points, uv));
		EXPECT_GE(place->polygon, piece.polygon); // the line takes what it enters first where polygons overlap
		EXPECT_EQ(place->cell.cell, sheet.mesh.polygon_cells[place->polygon].cell);
		const probe::Sheet& frame = sheet.slice.sheet;
		const double expected = linearAt(frame.origin + uv.x * frame.xAxis() + uv.y * frame.up);
		EXPECT_NEAR(lookup.value(*place, values), expected, tolerance);
		++places;
	}
	return places;
}

} // namespace

TEST(SheetLookup, FindsWhatALineFindsAndKeepsALinearField)
{
	std::mt19937 random(9);
	std::size_t places = 0;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet blocks = setOf(block);
		cut::Cutter cutter(blocks);
		const double size = blocks.bounds().diagonal();
		std::uniform_real_distribution<double> somewhere(-0.6 * size, 0.6 * size);
		for (const TestPlane& plane : randomPlanes(blocks.bounds(), 8, 22))
		{
			const SlicedSheet sheet = cut(cutter, plane);
			const SheetLookup lookup(sheet.mesh, sheet.slice.sheet);
			EXPECT_LE(lookup.bytes(), measure::kLookupBytes * sheet.mesh.polygons() + 64);
			for (int line = 0; line < 8; ++line)
			{
				const Uv a(somewhere(random), somewhere(random));
				const Uv b(somewhere(random), somewhere(random));
				places += compareAlongLine(sheet, lookup, a, b, 1e-9 * (1.0 + size));
			}
		}
	}
	EXPECT_GT(places, 2500u);
}

TEST(SheetLookup, VerticesAndMeansHaveTheirValues)
{
	const grid::BlockSet blocks = grid::makeDemo("shell", 8).value();
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {{0.2, 1.7, 0.1}, {0.3, 0.5, 0.8}});
	const SheetLookup lookup(sheet.mesh, sheet.slice.sheet);
	const std::vector<Uv> points = measure::planePoints(sheet.mesh, sheet.slice.sheet);
	// Any values, since places are known exactly here.
	std::vector<double> values;
	std::mt19937 random(4);
	for (std::size_t v = 0; v < points.size(); ++v)
		values.push_back(std::uniform_real_distribution<double>(-1.0, 1.0)(random));
	for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
	{
		const auto polygon = sheet.mesh.polygon(p);
		Uv center(0.0);
		double mean = 0.0;
		for (const std::uint32_t v : polygon)
		{
			center += points[v] / double(polygon.size());
			mean += values[v] / double(polygon.size());
		}
		const std::optional<SheetPlace> place = lookup.at(center);
		ASSERT_TRUE(place);
		EXPECT_EQ(place->polygon, p);
		EXPECT_NEAR(lookup.value(*place, values), mean, 1e-9);
		const Uv near_corner = points[polygon[0]] + 1e-9 * (center - points[polygon[0]]);
		const std::optional<SheetPlace> corner = lookup.at(near_corner);
		ASSERT_TRUE(corner);
		EXPECT_EQ(corner->polygon, p);
		EXPECT_NEAR(lookup.value(*corner, values), values[polygon[0]], 1e-6);
	}
}

TEST(SheetLookup, PolygonsOfAnyForm)
{
	// A hook, whose mean lies outside of it, run either way; a bow tie; a needle.
	std::vector<std::vector<Uv>> forms{{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {0, 1}},
	                                   {{10, 0}, {12, 2}, {12, 0}, {10, 2}},
	                                   {{0, 10}, {5, 10}, {10, 10 + 1e-9}}};
	std::mt19937 random(8);
	for (const bool reversed : {false, true})
	{
		if (reversed)
			for (std::vector<Uv>& form : forms)
				std::ranges::reverse(form);
		const SheetMesh mesh = meshOf(forms);
		const SheetLookup lookup(mesh, probe::Frame{});
		const std::vector<double> values = linearValues(mesh);
		const auto expect = [&](const Uv& uv, std::uint32_t polygon)
		{
			const std::optional<SheetPlace> place = lookup.at(uv);
			ASSERT_TRUE(place) << uv.x << " " << uv.y;
			EXPECT_EQ(place->polygon, polygon) << uv.x << " " << uv.y;
			expectWeights(*place);
			EXPECT_NEAR(lookup.value(*place, values), linearAt({uv.x, uv.y, 0.0}), 1e-9) << uv.x << " " << uv.y;
		};
		std::uniform_real_distribution<double> part(0.001, 0.999);
		for (int i = 0; i < 1000; ++i)
		{
			expect({4.0 * part(random), part(random)}, 0);
			expect({3.0 + part(random), 4.0 * part(random)}, 0);
			const double off = part(random);
			expect({10.0 + off, 1.0 + 0.9 * (1.0 - off)}, 1);
			expect({12.0 - off, 1.0 - 0.9 * (1.0 - off)}, 1);
			EXPECT_FALSE(lookup.at({3.0 * part(random) - 1e-6, 1.001 + 3.0 * part(random)}));
		}
		expect({7.0, 10.0 + 5.5e-10}, 2);
		EXPECT_FALSE(lookup.at({11.0, 0.5}));
		EXPECT_FALSE(lookup.at({-1.0, 0.5}));
		EXPECT_FALSE(lookup.at({1e30, -1e30}));
	}
}

TEST(SheetLookup, TheLastOfThoseOverEachOtherIsSeen)
{
	const std::vector<Uv> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
	const SheetMesh mesh = meshOf({square, square, {{2, 0}, {3, 0}, {3, 1}}});
	const SheetLookup lookup(mesh, probe::Frame{});
	EXPECT_EQ(lookup.at({0.3, 0.4})->polygon, 1u);
	EXPECT_TRUE(lookup.at({1.0, 1.0})); // the rim is within
	EXPECT_FALSE(lookup.at({1.0 + 1e-6, 1.0}));
	EXPECT_FALSE(SheetLookup(SheetMesh{}, probe::Frame{}).at({0.0, 0.0}));
}

// Slivers along the diagonal fill their rectangles worst; a few large polygons among many small ones lie in most bins.
TEST(SheetLookup, MemoryIsBoundedForAnyPolygons)
{
	constexpr int kMany = 20000;
	std::vector<std::vector<Uv>> slivers;
	std::vector<std::vector<Uv>> mixed;
	for (int i = 0; i < kMany; ++i)
	{
		const double x = 1e-6 * i;
		slivers.push_back({{x, 0.0}, {x + 1e-6, 0.0}, {x + 1.0 + 1e-6, 1.0}, {x + 1.0, 1.0}});
		const Uv at = i % 100 == 0 ? Uv(0.0, 1e-3 * i) : Uv(1e-5 * i, 1e-7 * i);
		const double size = i % 100 == 0 ? 1.0 : 1e-7;
		mixed.push_back({at, at + Uv(size, 0.0), at + Uv(0.0, size)});
	}
	for (const auto& polygons : {slivers, mixed})
	{
		const SheetMesh mesh = meshOf(polygons);
		const SheetLookup lookup(mesh, probe::Frame{});
		EXPECT_LE(lookup.bytes(), measure::kLookupBytes * kMany + 64);
		for (std::uint32_t i = 1; i < kMany; i += 97)
		{
			Uv middle(0.0);
			for (const Uv& corner : polygons[i])
				middle += corner / double(polygons[i].size());
			const std::optional<SheetPlace> place = lookup.at(middle);
			ASSERT_TRUE(place);
			if (polygons[i].size() == 4 || i % 100 != 0)
			{
				EXPECT_GE(place->polygon, i);
			}
		}
	}
}

} // namespace vp::test
