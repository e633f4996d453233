#include "measure/sheet_line.h"

#include "exhaustive.h"
#include "grid/demo/demo.h"
#include "measure/plane_triangles.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <random>

namespace vp::test
{

namespace
{

using measure::LinePiece;
using Uv = glm::dvec2;

// The witness: a place asked polygon by polygon, even-odd.
bool inAnyPolygon(const mesh::SheetMesh& mesh, const std::vector<Uv>& points, const Uv& p)
{
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
			return true;
	}
	return false;
}

double covered(const std::vector<LinePiece>& pieces)
{
	double sum = 0.0;
	for (const LinePiece& piece : pieces)
		sum += piece.to - piece.from;
	return sum;
}

} // namespace

TEST(SheetLine, PiecesAreInOrderCoverTheSliceAndKeepALinearField)
{
	std::mt19937 random(5);
	std::size_t crossings = 0;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet blocks = setOf(block);
		cut::Cutter cutter(blocks);
		const double size = glm::length(blocks.bounds().hi - blocks.bounds().lo);
		std::uniform_real_distribution<double> somewhere(-0.6 * size, 0.6 * size);
		for (const TestPlane& plane : randomPlanes(blocks.bounds(), 3, 21))
		{
			const SlicedSheet sheet = cut(cutter, plane);
			const std::vector<Uv> points = measure::planePoints(sheet.mesh, sheet.slice.sheet);
			const auto place = [&]
			{
				const double v = somewhere(random);
				return Uv(somewhere(random), v);
			};
			const Uv a = place();
			const Uv b = place();
			const std::vector<LinePiece> pieces = measure::alongLine(sheet.mesh, points, a, b);
			double end = 0.0;
			for (const LinePiece& piece : pieces)
			{
				EXPECT_GE(piece.from, end);
				EXPECT_GT(piece.to, piece.from);
				EXPECT_LE(piece.to, 1.0);
				end = piece.to;
				for (const measure::SideCrossing& side : {piece.enter, piece.leave})
				{
					const double low = linearAt(sheet.mesh.positions[side.a]);
					const double high = linearAt(sheet.mesh.positions[side.b]);
					const Uv uv = a + side.t * (b - a);
					const Vec3 at =
					    sheet.slice.sheet.origin + uv.x * sheet.slice.sheet.xAxis() + uv.y * sheet.slice.sheet.up;
					EXPECT_NEAR(low + side.part * (high - low), linearAt(at), 1e-9 * (1.0 + size));
					++crossings;
				}
			}
			constexpr int kPlaces = 1000;
			int inside = 0;
			for (int i = 0; i < kPlaces; ++i)
				inside += inAnyPolygon(sheet.mesh, points, a + (i + 0.5) / kPlaces * (b - a));
			// A place counts for a thousandth; each end of a stretch may be off by one.
			EXPECT_NEAR(covered(pieces), inside / double(kPlaces), 0.008);
		}
	}
	EXPECT_GT(crossings, 250u);
}

TEST(SheetLine, AlongSidesAndTheRimNothingIsLost)
{
	const grid::BlockSet blocks = grid::makeDemo("blob", 6).value(); // points at whole numbers
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {{0.0, 0.0, 0.25}, {0.0, 0.0, 1.0}});
	const std::vector<Uv> points = measure::planePoints(sheet.mesh, sheet.slice.sheet);
	for (const double y : {-3.0, -1.0, 0.0, 2.0, 3.0})
		for (const bool back : {false, true})
		{
			SCOPED_TRACE(y);
			const Uv a(back ? 3.0 : -3.0, y);
			const std::vector<LinePiece> pieces = measure::alongLine(sheet.mesh, points, a, {-a.x, y});
			EXPECT_EQ(pieces.size(), 6u);
			EXPECT_NEAR(covered(pieces), 1.0, 1e-12);
		}
	EXPECT_NEAR(covered(measure::alongLine(sheet.mesh, points, {-3.0, -3.0}, {3.0, 3.0})), 1.0, 1e-12);
	EXPECT_NEAR(covered(measure::alongLine(sheet.mesh, points, {-6.0, 0.5}, {6.0, 0.5})), 0.5, 1e-12);
	EXPECT_TRUE(measure::alongLine(sheet.mesh, points, {-3.0, 3.5}, {3.0, 3.5}).empty());
	// Within one polygon.
	const std::vector<LinePiece> inner = measure::alongLine(sheet.mesh, points, {0.2, 0.3}, {0.7, 0.6});
	ASSERT_EQ(inner.size(), 1u);
	EXPECT_EQ(inner[0].from, 0.0);
	EXPECT_EQ(inner[0].to, 1.0);
	EXPECT_LT(inner[0].enter.t, 0.0);
	EXPECT_GT(inner[0].leave.t, 1.0);
}

} // namespace vp::test
