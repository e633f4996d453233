#include "helix_traces.h"

#include "vectors/trace_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

namespace vp::test
{

namespace
{

using vectors::Curves;
using vectors::TraceMesh;
using vectors::Traces;

constexpr double kWidth = 0.1;

// Along x, so long; values are x.
struct Straight
{
	Traces traces;
	Curves curves;
	std::vector<double> values;

	explicit Straight(double length)
	{
		addHelix(traces, 1.0, 0.1, 0, 1);
		traces.points[0] = Vec3(0.0);
		traces.points[1] = Vec3(length, 0.0, 0.0);
		traces.vectors[0] = traces.vectors[1] = Vec3(1.0, 0.0, 0.0);
		curves = vectors::curvesOf(traces, traces.vectors);
		values = vectors::alongCurves(curves, std::vector<double>{0.0, length});
	}
};

struct Helix
{
	Traces traces;
	Curves curves;
	std::vector<double> values;

	Helix()
	{
		addHelix(traces, 2.0, 0.3, 5, 15);
		addHelix(traces, 1.0, 0.3, 0, 7);
		curves = vectors::curvesOf(traces, traces.vectors);
		values = vectors::alongCurves(curves, traces.times);
	}
};

// Returns true if the polygons use every edge once in each direction.
bool isClosed(const mesh::SheetMesh& mesh)
{
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
			++edges[{polygon[i], polygon[(i + 1) % polygon.size()]}];
	}
	for (const auto& [edge, times] : edges)
		if (times != 1 || !edges.contains({edge.second, edge.first}))
			return false;
	return !edges.empty();
}

// Positive where polygons wind counter-clockwise seen from outside.
double volume(const mesh::SheetMesh& mesh)
{
	double sum = 0.0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
			sum += glm::dot(mesh.positions[polygon[0]],
			                glm::cross(mesh.positions[polygon[i]], mesh.positions[polygon[i + 1]])) /
			       6.0;
	}
	return sum;
}

TEST(TraceMesh, TubesAreClosedAndRound)
{
	const Helix helix;
	for (const auto add : {vectors::addTubes, vectors::addLines, vectors::addArrows})
	{
		TraceMesh made;
		add(helix.curves, helix.values, kWidth, made);
		EXPECT_TRUE(isClosed(made.mesh));
		EXPECT_EQ(made.values.size(), made.mesh.positions.size());
	}
	TraceMesh tubes;
	vectors::addTubes(helix.curves, helix.values, kWidth, tubes);
	const double length = std::hypot(2.0, 0.3) * 20 * 0.3 + std::hypot(1.0, 0.3) * 7 * 0.3;
	const double round = std::numbers::pi * 0.25 * kWidth * kWidth * length;
	EXPECT_NEAR(volume(tubes.mesh), round, 0.08 * round); // ten sides
	for (std::size_t v = 0; v < tubes.values.size(); ++v)
	{
		const Vec3 axis = onHelix(std::hypot(tubes.mesh.positions[v].x, tubes.mesh.positions[v].y) > 1.5 ? 2.0 : 1.0,
		                          tubes.values[v]);
		EXPECT_NEAR(glm::length(tubes.mesh.positions[v] - axis), 0.5 * kWidth, 1e-3) << v;
	}
}

TEST(TraceMesh, ArrowsEndInATipWhereTheParticleComesTo)
{
	const Straight straight(1.0);
	TraceMesh made;
	vectors::addArrows(straight.curves, straight.values, 0.02, made);
	EXPECT_EQ(made.mesh.positions.back(), Vec3(1.0, 0.0, 0.0));
	EXPECT_EQ(made.values.back(), 1.0);
	double widest = 0.0;
	for (const Vec3& p : made.mesh.positions)
	{
		widest = std::max(widest, std::hypot(p.y, p.z));
		EXPECT_TRUE(p.x >= 0.0 && p.x <= 1.0);
		EXPECT_TRUE(p.x > 0.89 || std::hypot(p.y, p.z) < 0.0101);
	}
	EXPECT_NEAR(widest, 0.032, 1e-12);
}

TEST(TraceMesh, ShortArrowsKeepTheirForm)
{
	const Straight straight(0.01);
	TraceMesh made;
	vectors::addArrows(straight.curves, straight.values, 0.02, made);
	EXPECT_TRUE(isClosed(made.mesh));
	double widest = 0.0;
	for (const Vec3& p : made.mesh.positions)
	{
		EXPECT_TRUE(p.x >= 0.0 && p.x <= 0.01) << p.x;
		widest = std::max(widest, std::hypot(p.y, p.z));
	}
	EXPECT_LT(widest, 0.01);
	EXPECT_GT(widest, 0.0);
}

TEST(TraceMesh, RibbonsAreAsWideAsAskedAndTurnWithTheField)
{
	const Straight straight(2.0);
	const std::vector<double> turns{0.0, 0.5 * std::numbers::pi};
	TraceMesh made;
	vectors::addRibbons(straight.curves, straight.values, kWidth, {0.0, 1.0, 0.0}, turns, made);
	ASSERT_EQ(made.mesh.positions.size(), 4u);
	ASSERT_EQ(made.mesh.polygons(), 1u);
	const auto& p = made.mesh.positions;
	EXPECT_LT(glm::length(p[1] - p[0] - Vec3(0.0, kWidth, 0.0)), 1e-12);
	EXPECT_LT(glm::length(p[3] - p[2] - Vec3(0.0, 0.0, kWidth)), 1e-12); // right-handed about x
	const Helix helix;
	TraceMesh strips;
	vectors::addRibbons(helix.curves, helix.values, kWidth, {0.0, 0.0, 1.0}, {}, strips);
	for (std::size_t v = 0; v < strips.values.size(); v += 2)
		EXPECT_NEAR(glm::length(strips.mesh.positions[v + 1] - strips.mesh.positions[v]), kWidth, 1e-12);
}

} // namespace

} // namespace vp::test
