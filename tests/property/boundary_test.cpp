// Figures of sheets that lie in the boundary of the domain.
#include "field_sets.h"
#include "random_sets.h"
#include "sliced_sheet.h"
#include "test_grids.h"
#include "tries.h"

#include "lattice_cells.h"
#include "probe/sheet.h"
#include "vectors/flux.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vp::test
{

namespace
{

struct Figures
{
	measure::SheetMeasure measure;
	vectors::Flux flux;

	// Returns the area of everything that is shown.
	double area() const { return measure.area + measure.boundary_area; }
	double integral() const
	{
		return measure.mean.value_or(0.0) * measure.area + measure.boundary_mean.value_or(0.0) * measure.boundary_area;
	}
	double through() const { return flux.through + flux.boundary; }
};

// Returns the figures by a strategy. Returns nothing if the strategy cannot cut this set.
std::optional<Figures> figuresBy(find::Strategy strategy, cut::Cutter& cutter, const TestPlane& plane)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.field = kScalarField;
	request.strategy = strategy;
	const Result<cut::Cut> made = cutter.cut(std::move(request));
	if (!made)
		return std::nullopt;
	const grid::BlockSet& blocks = cutter.blocks();
	const mesh::SheetMesh mesh = made->mesh(blocks, 0);
	return Figures{measure::measure(blocks, mesh, kScalarField), vectors::fluxThrough(blocks, mesh, kVectorField)};
}

constexpr std::array kStrategies{find::Strategy::rows, find::Strategy::spans, find::Strategy::cells,
                                 find::Strategy::generations, find::Strategy::scan};

// The unit cube in n x n x n cells.
RawSet unitCube(RawKind kind, int n)
{
	RawBlock block;
	block.kind = kind == RawKind::cells ? RawKind::image : kind;
	const auto points = static_cast<std::uint32_t>(n + 1);
	block.points_along = {points, points, points};
	for (int k = 0; k <= n; ++k)
		for (int j = 0; j <= n; ++j)
			for (int i = 0; i <= n; ++i)
				block.points.push_back(Vec3(i, j, k) / static_cast<double>(n));
	return {"cube", {kind == RawKind::cells ? asHexahedra(block) : block}};
}

AtPlace byHand(const Vec3& p)
{
	return {p.x + 2.0 * p.y, {1.0, 2.0, 3.0}};
}

} // namespace

// The mean of u = x + 2 y over the unit square is 1.5, and the flux of (1, 2, 3) through it is 3.
TEST(Boundary, OfTheUnitCubeByHand)
{
	for (const RawKind kind : {RawKind::image, RawKind::rectilinear, RawKind::curvilinear, RawKind::cells})
		for (const int n : {1, 2, 3, 4})
		{
			const grid::BlockSet set = withFields(unitCube(kind, n), byHand);
			cut::Cutter cutter(set);
			std::size_t ways = 0;
			for (const find::Strategy strategy : kStrategies)
				for (const double z : {0.0, 1.0 / n, 1.0})
					for (const double side : {1.0, -1.0})
					{
						SCOPED_TRACE(std::string(find::nameOf(strategy)) + ", z = " + std::to_string(z));
						const auto told = figuresBy(strategy, cutter, {{0.5, 0.5, z}, {0.0, 0.0, side}});
						if (!told)
							continue;
						++ways;
						const bool low = z == 0.0; // no cell lies below
						EXPECT_NEAR(told->measure.area, low ? 0.0 : 1.0, 1e-14);
						EXPECT_NEAR(told->measure.boundary_area, low ? 1.0 : 0.0, 1e-14);
						EXPECT_NEAR(told->flux.through, low ? 0.0 : 3.0 * side, 1e-14);
						EXPECT_NEAR(told->flux.boundary, low ? 3.0 * side : 0.0, 1e-14);
						ASSERT_EQ(told->measure.mean.has_value(), !low);
						ASSERT_EQ(told->measure.boundary_mean.has_value(), low);
						EXPECT_NEAR(low ? *told->measure.boundary_mean : *told->measure.mean, 1.5, 1e-14);
					}
			EXPECT_GE(ways, 12u);
		}
}

// Cells of a chessboard meet in edges alone: half of a plane between two layers is cut, half lies in the boundary.
TEST(Boundary, OfAChessboardByHand)
{
	RawSet raw = unitCube(RawKind::cells, 4);
	const std::vector<RawCell> all = std::move(raw.blocks[0].cells);
	raw.blocks[0].cells.clear();
	for (std::size_t c = 0; c < all.size(); ++c)
		if ((c % 4 + c / 4 % 4 + c / 16) % 2 == 0)
			raw.blocks[0].cells.push_back(all[c]);
	const grid::BlockSet set = withFields(raw, byHand);
	cut::Cutter cutter(set);
	for (const find::Strategy strategy : kStrategies)
		if (const auto told = figuresBy(strategy, cutter, {{0.5, 0.5, 0.5}, {0.0, 0.0, 1.0}}))
		{
			SCOPED_TRACE(find::nameOf(strategy));
			EXPECT_NEAR(told->measure.area, 0.5, 1e-14);
			EXPECT_NEAR(told->measure.boundary_area, 0.5, 1e-14);
			// The middles of squares of either color have the same mean.
			EXPECT_NEAR(told->measure.mean.value(), 1.5, 1e-14);
			EXPECT_NEAR(told->measure.boundary_mean.value(), 1.5, 1e-14);
			EXPECT_NEAR(told->flux.through, 1.5, 1e-14);
			EXPECT_NEAR(told->flux.boundary, 1.5, 1e-14);
		}
}

// Cells without values, and values without cells.
TEST(Boundary, LeavesOutWhatIsNotFinite)
{
	const grid::BlockSet set = withFields(unitCube(RawKind::image, 2),
	                                      [](const Vec3& p)
	                                      {
		                                      AtPlace here = byHand(p);
		                                      if (p.x == 0.0 && p.y == 0.0)
			                                      here = {std::nan(""), Vec3(std::nan(""))};
		                                      return here;
	                                      });
	cut::Cutter cutter(set);
	const auto told = figuresBy(find::Strategy::rows, cutter, {{0.5, 0.5, 0.0}, {0.0, 0.0, 1.0}});
	ASSERT_TRUE(told);
	EXPECT_NEAR(told->measure.boundary_area, 1.0, 1e-14);
	// The square about (0.25, 0.25), where u is 0.75, has a corner without a value.
	EXPECT_NEAR(told->measure.boundary_mean.value(), (1.5 - 0.25 * 0.75) / 0.75, 1e-14);
	EXPECT_NEAR(told->flux.boundary, 0.75 * 3.0, 1e-14);
	EXPECT_EQ(told->measure.nan_area, 0.0); // the area that is cut
}

namespace
{

// In the mirror the cells above a plane lie below it: what was cut becomes boundary, and all together stays.
void expectTheSameInTheMirror(const RawSet& raw, const TestPlane& plane, int axis, const std::string& trace)
{
	SCOPED_TRACE(trace);
	const auto mirrored = [axis](Vec3 p)
	{
		p[axis] = -p[axis];
		return p;
	};
	const auto fields = [](const Vec3& p) {
		return AtPlace{linearAt(p), {1.0 + p.y - 2.0 * p.z, 0.5 * p.x + p.y, 3.0 - p.x + p.z}};
	};
	const grid::BlockSet set = withFields(raw, fields);
	const grid::BlockSet other = withFields(moved(raw, mirrored),
	                                        [&](const Vec3& p)
	                                        {
		                                        AtPlace here = fields(mirrored(p));
		                                        here.vector = mirrored(here.vector);
		                                        return here;
	                                        });
	cut::Cutter cutter(set);
	cut::Cutter other_cutter(other);
	const double reach = std::max(glm::length(set.bounds().lo), glm::length(set.bounds().hi)) + 1.0;
	std::size_t ways = 0;
	std::optional<Figures> there;
	for (const find::Strategy strategy : kStrategies)
		if (!there)
			there = figuresBy(strategy, other_cutter, {mirrored(plane.origin), mirrored(plane.normal)});
	ASSERT_TRUE(there);
	for (const find::Strategy strategy : kStrategies)
		if (const auto here = figuresBy(strategy, cutter, plane))
		{
			++ways;
			const double scale = 1e-12 * std::max(here->area(), 1e-300);
			EXPECT_NEAR(here->area(), there->area(), scale) << find::nameOf(strategy);
			EXPECT_NEAR(here->integral(), there->integral(), 8.0 * reach * scale) << find::nameOf(strategy);
			EXPECT_NEAR(here->through(), there->through(), 8.0 * reach * scale) << find::nameOf(strategy);
		}
	EXPECT_GE(ways, 1u);
}

} // namespace

TEST(Boundary, AndWhatIsCutMakeOneWholeInTheMirrorToo)
{
	constexpr LatticeKind kKinds[] = {LatticeKind::plain,     LatticeKind::curvilinear, LatticeKind::mixed,
	                                  LatticeKind::doubles,   LatticeKind::hexagonal,   LatticeKind::hexahedra,
	                                  LatticeKind::wedges,    LatticeKind::tetrahedra,  LatticeKind::pyramids,
	                                  LatticeKind::polyhedra, LatticeKind::blanked};
	std::size_t in_boundary = 0;
	for (int i = 0; i < tries(200); ++i)
	{
		Draw draw(static_cast<unsigned>(i));
		const RawSet raw = latticeSet(kKinds[static_cast<std::size_t>(i) % std::size(kKinds)], draw, {}, {1, 4});
		const Box bounds = build(raw).bounds();
		const int axis = draw.whole(0, 2);
		// A layer of points, or a side of the domain.
		Vec3 origin = draw.chance(0.5) ? bounds.lo : bounds.hi;
		if (draw.chance(0.4))
		{
			const std::vector<Vec3>& points = raw.blocks[0].points;
			origin = points[static_cast<std::size_t>(draw.whole(0, static_cast<int>(points.size()) - 1))];
		}
		Vec3 normal(0.0);
		normal[axis] = draw.chance(0.5) ? 1.0 : -1.0;
		expectTheSameInTheMirror(raw, {origin, normal}, axis, raw.name + " " + std::to_string(i));
		in_boundary += origin[axis] == bounds.lo[axis];
		if (testing::Test::HasFailure())
			return;
	}
	EXPECT_GT(in_boundary, static_cast<std::size_t>(tries(20)));
}

// The figures of boundary faces are those of their polygons.
TEST(Boundary, FiguresAreThoseOfThePolygons)
{
	std::size_t with_faces = 0;
	for (int i = 0; i < tries(300); ++i)
	{
		SCOPED_TRACE(i);
		const RawSet raw = randomSet(static_cast<unsigned>(i));
		const grid::BlockSet set = build(raw);
		cut::Cutter cutter(set);
		for (unsigned n = 0; n < 6; ++n)
		{
			const SlicedSheet sheet = cut(cutter, randomPlane(set, 6 * static_cast<unsigned>(i) + n));
			const measure::SheetMeasure told = measure::measure(set, sheet.mesh, grid::FieldChoice{"linear"});
			double area = 0.0;
			double integral = 0.0;
			double largest = 0.0;
			for (std::size_t p = sheet.mesh.polygons() - sheet.mesh.boundary_polygons; p < sheet.mesh.polygons(); ++p)
			{
				const auto polygon = sheet.mesh.polygon(p);
				const Vec3& first = sheet.mesh.positions[polygon[0]];
				for (std::size_t v = 1; v + 1 < polygon.size(); ++v)
				{
					const Vec3& a = sheet.mesh.positions[polygon[v]];
					const Vec3& b = sheet.mesh.positions[polygon[v + 1]];
					const double part = 0.5 * glm::dot(glm::cross(a - first, b - first), sheet.slice.sheet.normal);
					area += part;
					integral += part * linearAt((first + a + b) / 3.0);
					largest = std::max({largest, std::abs(linearAt(a)), std::abs(linearAt(b))});
				}
			}
			with_faces += area > 0.0;
			EXPECT_NEAR(told.boundary_area, area, 1e-10 * area);
			EXPECT_EQ(told.boundary_mean.has_value(), told.boundary_area > 0.0);
			if (told.boundary_mean)
			{
				EXPECT_NEAR(*told.boundary_mean * told.boundary_area, integral, 1e-6 * area * largest);
			}
		}
		if (testing::Test::HasFailure())
			return;
	}
	EXPECT_GE(with_faces, static_cast<std::size_t>(tries(10)));
}

} // namespace vp::test
