#include "mesh/host_records.h"
#include "twisted_sets.h"

#include "sliced_sheet.h"
#include "test_grids.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

// Sections of polyhedra of two warped lattice cells, ten faces each. The witness is the vector area about a vertex,
// whose triangles cancel where they overlap.
struct Witness
{
	double area = 0.0;
	double moment = 0.0;    // moment of the linear field
	double unsigned_ = 0.0; // area of the triangles about the mean of the vertices
	bool crosses = false;   // the polygon crosses itself
};

double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal)
{
	return glm::dot(glm::cross(b - a, c - a), normal);
}

bool segmentsCross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& normal)
{
	return turn(a, b, c, normal) * turn(a, b, d, normal) < 0.0 && turn(c, d, a, normal) * turn(c, d, b, normal) < 0.0;
}

Witness witnessOf(const mesh::SheetMesh& mesh, std::size_t p, const Vec3& normal)
{
	std::vector<Vec3> corners;
	Vec3 middle(0.0);
	for (const std::uint32_t v : mesh.polygon(p))
	{
		corners.push_back(mesh.positions[v]);
		middle += corners.back() / static_cast<double>(mesh.polygon(p).size());
	}
	Witness witness;
	const std::size_t n = corners.size();
	for (std::size_t i = 0; i < n; ++i)
	{
		const Vec3& a = corners[i];
		const Vec3& b = corners[(i + 1) % n];
		const double part = 0.5 * turn(corners[0], a, b, normal);
		witness.area += part;
		witness.moment += part * linearAt((corners[0] + a + b) / 3.0);
		witness.unsigned_ += 0.5 * std::abs(turn(middle, a, b, normal));
		for (std::size_t j = i + 2; j < n; ++j)
			witness.crosses |= segmentsCross(a, b, corners[j], corners[(j + 1) % n], normal);
	}
	return witness;
}

double recordTurn(const shared::PolygonRecord& record, std::uint32_t i)
{
	const auto at = [&](std::uint32_t v) { return glm::dvec2(record.uv[2 * v], record.uv[2 * v + 1]); };
	const glm::dvec2 ab = at(i) - at(0);
	const glm::dvec2 ac = at(i + 1) - at(0);
	return ab.x * ac.y - ab.y * ac.x;
}

template <class Visit>
void forSections(Visit&& visit)
{
	for (std::uint32_t mask = 1; mask < (1u << twistedPoints(LatticeKind::doubles)) - 1u; mask += 7)
	{
		SCOPED_TRACE(mask);
		const TwistedSet twisted = twistedSet(LatticeKind::doubles, mask, mask);
		const grid::BlockSet set = build(twisted.raw);
		cut::Cutter cutter(set);
		visit(set, cut(cutter, twisted.plane));
		if (testing::Test::HasFailure())
			return;
	}
}

const grid::FieldChoice kLinear{"linear", grid::Association::point, 0};

} // namespace

TEST(Concave, AreaAndMeanAreThePolygons)
{
	double too_much = 0.0; // what triangles without a sign would add
	forSections(
	    [&](const grid::BlockSet& set, const SlicedSheet& sheet)
	    {
		    Witness sum;
		    for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
		    {
			    const Witness one = witnessOf(sheet.mesh, p, sheet.slice.sheet.normal);
			    sum.area += one.area;
			    sum.moment += one.moment;
			    sum.unsigned_ += one.unsigned_;
		    }
		    too_much = std::max(too_much, sum.unsigned_ - sum.area);
		    const measure::SheetMeasure measure = measure::measure(set, sheet.mesh, kLinear);
		    EXPECT_NEAR(measure.area, sum.area, 1e-12 * sum.area);
		    EXPECT_NEAR(measure.mean.value(), sum.moment / sum.area, 1e-11);
		    EXPECT_NEAR(measure::measure(set, sheet.mesh, {}).area, sum.area, 1e-12 * sum.area);
	    });
	EXPECT_GT(too_much, 0.01);
}

// Triangles of one sense whose areas add up to the polygon's cover it once and nothing else.
TEST(Concave, RecordsCoverThePolygonAndNothingElse)
{
	std::size_t concave = 0;
	forSections(
	    [&](const grid::BlockSet& set, const SlicedSheet& sheet)
	    {
		    const auto records = mesh::recordsFromMesh(set, sheet.slice.sheet, sheet.mesh, kLinear);
		    std::size_t next = 0;
		    for (std::size_t p = 0; p < sheet.mesh.polygons(); ++p)
		    {
			    const Witness witness = witnessOf(sheet.mesh, p, sheet.slice.sheet.normal);
			    concave += witness.unsigned_ > 1.001 * witness.area;
			    double area = 0.0;
			    double least = 0.0;
			    // As many triangles as any parting of the polygon has.
			    for (std::size_t triangles = 0; triangles < sheet.mesh.polygon(p).size() - 2; ++next)
			    {
				    ASSERT_LT(next, records.size());
				    ASSERT_EQ(records[next].cell, sheet.mesh.polygon_cells[p].cell);
				    const std::uint32_t corners = records[next].vertices & shared::kRecordVertices;
				    ASSERT_GE(corners, 3u);
				    for (std::uint32_t i = 1; i + 1 < corners; ++i, ++triangles)
				    {
					    area += 0.5 * recordTurn(records[next], i);
					    least = std::min(least, recordTurn(records[next], i));
				    }
			    }
			    EXPECT_NEAR(area, witness.area, 1e-5);
			    EXPECT_TRUE(witness.crosses || least > -1e-5) << "polygon " << p;
		    }
		    EXPECT_EQ(next, records.size());
	    });
	EXPECT_GT(concave, 20u);
}

} // namespace vp::test
