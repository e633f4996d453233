// Cells with holes and concave cells, with answers by hand: flux, contour lines, thresholds, whole cells, particles.
#include "field_sets.h"
#include "hollow_cells.h"
#include "prism_sets.h"
#include "sliced_sheet.h"
#include "tries.h"

#include "locate/place.h"
#include "measure/contour_lines.h"
#include "measure/plane_triangles.h"
#include "mesh/mesh_values.h"
#include "probe/sheet.h"
#include "vectors/flux.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace vp::test
{

namespace
{

using vectors::TraceEnd;

AtPlace linearFields(const Vec3& p)
{
	return {p.x, p};
}

struct Made
{
	cut::Cut cut;
	mesh::SheetMesh mesh;
};

Made made(const grid::BlockSet& set, const TestPlane& plane, std::optional<find::Threshold> threshold = {},
          const grid::FieldChoice& field = kScalarField)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.field = field;
	request.threshold = threshold;
	cut::Cutter cutter(set);
	Made result{std::move(cutter.cut(std::move(request)).value()), {}};
	result.mesh = result.cut.mesh(set, 0);
	return result;
}

double fluxOf(const grid::BlockSet& set, const TestPlane& plane)
{
	return vectors::fluxThrough(set, made(set, plane).mesh, kVectorField).through;
}

double areaOf(const grid::BlockSet& set, const TestPlane& plane, std::optional<find::Threshold> threshold = {},
              const grid::FieldChoice& field = kScalarField)
{
	return measure::measure(set, made(set, plane, threshold, field).mesh, field).area;
}

const Vec3 kUp(0.0, 0.0, 1.0);
const TestPlane kAcross{{1.5, 1.5, 0.5}, {0.0, 0.0, 1.0}};      // a ring, or a U
const TestPlane kAcrossShell{{1.5, 1.5, 1.5}, {0.0, 0.0, 1.0}}; // a shell, through its void

// The length of the lines of one level of u on a sheet.
double lengthOfLines(const grid::BlockSet& set, const TestPlane& plane, double level)
{
	const Made sheet = made(set, plane);
	std::vector<double> values;
	const auto fields = kScalarField.inEach(set);
	for (std::size_t v = 0; v < sheet.mesh.positions.size(); ++v)
		values.push_back(mesh::vertexValue(set, sheet.mesh, v, fields, 0));
	const measure::PlaneTriangles triangles =
	    measure::planeTriangles(sheet.mesh, probe::makeSheet(plane.origin, plane.normal), values);
	double length = 0.0;
	for (const measure::PlaneLine& line : measure::Contours(triangles, {level}).lines(0))
		for (std::size_t i = 1; i < line.points.size(); ++i)
			length += glm::length(line.points[i] - line.points[i - 1]);
	return length;
}

struct Crinkled
{
	double area = 0.0;
	double volume = 0.0; // that the faces enclose, by their sense
};

Crinkled crinkled(const grid::BlockSet& set, const TestPlane& plane)
{
	const mesh::SheetMesh mesh = made(set, plane).cut.crinkle(set, 0);
	Crinkled sum;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		const Vec3& first = mesh.positions[polygon[0]];
		Vec3 whole(0.0);
		for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
		{
			const Vec3& a = mesh.positions[polygon[i]];
			const Vec3& b = mesh.positions[polygon[i + 1]];
			whole += 0.5 * glm::cross(a - first, b - first);
			sum.volume += glm::dot(first, glm::cross(a, b)) / 6.0;
		}
		sum.area += glm::length(whole);
	}
	return sum;
}

struct Path
{
	Vec3 end;
	double time;
	TraceEnd why;
};

Path flown(const grid::BlockSet& set, const Vec3& from, const char* array,
           vectors::Direction direction = vectors::Direction::forward)
{
	locate::PlaceFinder finder(set);
	const locate::Place& place = finder.find(from);
	EXPECT_TRUE(place.found());
	vectors::TraceOptions options;
	options.steps = 100;
	options.dt = 0.37;
	options.direction = direction;
	const std::vector<vectors::Launch> launches{{from, place.block, place.cell, 0}};
	const vectors::Traces traces =
	    vectors::trace(set, vectors::chooseVectors(set, array).value(), launches, options).value();
	const bool back = direction == vectors::Direction::backward;
	return {back ? traces.points.front() : traces.points.back(), back ? traces.times.front() : traces.times.back(),
	        back ? traces.begins[0] : traces.ends[0]};
}

void expectLeaves(const Path& path, const Vec3& end, double time, double precision = 1e-6)
{
	EXPECT_EQ(path.why, TraceEnd::left_grid);
	EXPECT_LT(glm::length(path.end - end), precision) << path.end.x << ' ' << path.end.y << ' ' << path.end.z;
	EXPECT_NEAR(path.time, time, precision);
}

grid::BlockSet flowing(const RawSet& raw, const Vec3& along)
{
	return withFields(raw, [along](const Vec3& p) { return AtPlace{p.x, along}; });
}

// A vector array over the cells, by their numbers in the file.
void addCellVectors(grid::BlockSet& set, const std::vector<Vec3>& of_cells)
{
	std::vector<double> numbers;
	for (const Vec3& v : of_cells)
		numbers.insert(numbers.end(), {v.x, v.y, v.z});
	set.blocks[0].fields.push_back(grid::makeField("wind", grid::Association::cell, 3, std::move(numbers)));
}

} // namespace

// The flux of (x, y, z) is half the area through z = 1/2, and three halves of the area through x = 3/2.
TEST(Hollow, Flux)
{
	for (const bool filled : {false, true})
	{
		const grid::BlockSet ring = withFields(ringCell(filled), linearFields);
		EXPECT_NEAR(fluxOf(ring, kAcross), 0.5 * (filled ? 9.0 : 8.0), 1e-12);
		EXPECT_NEAR(fluxOf(ring, {kAcross.origin, -kUp}), -0.5 * (filled ? 9.0 : 8.0), 1e-12);
		EXPECT_NEAR(fluxOf(ring, {kAcross.origin, {1.0, 0.0, 0.0}}), 1.5 * (filled ? 3.0 : 2.0), 1e-12);
		EXPECT_NEAR(fluxOf(withFields(uCell(filled), linearFields), kAcross), 0.5 * (filled ? 9.0 : 7.0), 1e-12);
		EXPECT_NEAR(fluxOf(withFields(shellCell(filled), linearFields), kAcrossShell), 1.5 * (filled ? 9.0 : 8.0),
		            1e-12);
	}
	// A side of the domain.
	const grid::BlockSet ring = flowing(ringCell(), {1.0, 2.0, 3.0});
	const Made low = made(ring, {{1.5, 1.5, 0.0}, kUp});
	EXPECT_NEAR(vectors::fluxThrough(ring, low.mesh, kVectorField).boundary, 24.0, 1e-12);
	EXPECT_NEAR(measure::measure(ring, low.mesh, kScalarField).boundary_area, 8.0, 1e-12);
	EXPECT_NEAR(measure::measure(ring, low.mesh, kScalarField).boundary_mean.value(), 1.5, 1e-12);
	EXPECT_NEAR(fluxOf(ring, {{1.5, 1.5, 1.0}, kUp}), 24.0, 1e-12);
}

// For u = x, a contour line is as long as the section at that x.
TEST(Hollow, ContourLines)
{
	for (const bool filled : {false, true})
	{
		const grid::BlockSet ring = withFields(ringCell(filled), linearFields);
		EXPECT_NEAR(lengthOfLines(ring, kAcross, 0.5), 3.0, 1e-12);
		EXPECT_NEAR(lengthOfLines(ring, kAcross, 1.5), filled ? 3.0 : 2.0, 1e-12);
		EXPECT_NEAR(lengthOfLines(ring, kAcross, 2.5), 3.0, 1e-12);
		const grid::BlockSet u = withFields(uCell(filled), linearFields);
		EXPECT_NEAR(lengthOfLines(u, kAcross, 1.25), filled ? 3.0 : 1.0, 1e-12);
		EXPECT_NEAR(lengthOfLines(u, kAcross, 2.75), 3.0, 1e-12);
		const grid::BlockSet shell = withFields(shellCell(filled), linearFields);
		EXPECT_NEAR(lengthOfLines(shell, kAcrossShell, 1.75), filled ? 3.0 : 2.0, 1e-12);
	}
}

// A cell is shown whole if a point of it is in the range.
TEST(Hollow, Thresholds)
{
	const grid::FieldChoice id{"id", grid::Association::cell, 0};
	for (const auto& [raw, plane, whole, inside] : {std::tuple(ringCell(true), kAcross, 9.0, 1.0),
	                                                {shellCell(true), kAcrossShell, 9.0, 1.0},
	                                                {uCell(true), kAcross, 9.0, 2.0}})
	{
		SCOPED_TRACE(raw.name);
		const grid::BlockSet set = withFields(raw, linearFields);
		EXPECT_NEAR(areaOf(set, plane, find::Threshold{0.0, 0.0}, id), whole - inside, 1e-12);
		EXPECT_NEAR(areaOf(set, plane, find::Threshold{1.0, 1.0}, id), inside, 1e-12);
		EXPECT_NEAR(areaOf(set, plane, find::Threshold{0.0, 1.0}, id), whole, 1e-12);
		// For u = x, values go from 1 to 2 in the inner cell, and from 0 to 3 in the outer one.
		EXPECT_NEAR(areaOf(set, plane, find::Threshold{2.5, 9.0}), whole - inside, 1e-12);
		EXPECT_NEAR(areaOf(set, plane, find::Threshold{1.2, 1.8}), whole, 1e-12);
		EXPECT_EQ(areaOf(set, plane, find::Threshold{3.5, 9.0}), 0.0);
	}
}

TEST(Hollow, WholeCellsEncloseTheirVolume)
{
	for (const auto& [raw, plane, area, volume] : {std::tuple(ringCell(), kAcross, 32.0, 8.0),
	                                               {ringCell(true), kAcross, 30.0, 9.0},
	                                               {shellCell(), kAcrossShell, 60.0, 26.0},
	                                               {shellCell(true), kAcrossShell, 54.0, 27.0},
	                                               {uCell(), kAcross, 30.0, 7.0},
	                                               {uCell(true), kAcross, 30.0, 9.0}})
	{
		SCOPED_TRACE(raw.name);
		const Crinkled sum = crinkled(withFields(raw, linearFields), plane);
		EXPECT_NEAR(sum.area, area, 1e-12);
		EXPECT_NEAR(sum.volume, volume, 1e-12);
	}
}

TEST(Hollow, ParticlesEndAtTheHole)
{
	const grid::BlockSet ring = flowing(ringCell(), {1.0, 0.0, 0.0});
	expectLeaves(flown(ring, {0.5, 1.5, 0.5}, "flow"), {1.0, 1.5, 0.5}, 0.5);
	expectLeaves(flown(ring, {0.5, 0.5, 0.5}, "flow"), {3.0, 0.5, 0.5}, 2.5);
	expectLeaves(flown(ring, {2.5, 1.5, 0.5}, "flow", vectors::Direction::backward), {2.0, 1.5, 0.5}, -0.5);
	const grid::BlockSet shell = flowing(shellCell(), {0.0, 1.0, 0.0});
	expectLeaves(flown(shell, {1.5, 0.25, 1.5}, "flow"), {1.5, 1.0, 1.5}, 0.75);
	expectLeaves(flown(shell, {1.5, 0.25, 0.5}, "flow"), {1.5, 3.0, 0.5}, 2.75);
	const grid::BlockSet u = flowing(uCell(), {2.0, 0.0, 0.0});
	expectLeaves(flown(u, {0.5, 2.0, 0.5}, "flow"), {1.0, 2.0, 0.5}, 0.25);
	expectLeaves(flown(u, {0.5, 0.5, 0.5}, "flow"), {3.0, 0.5, 0.5}, 1.25);
}

TEST(Hollow, ParticlesGoThroughWhatFillsTheHole)
{
	grid::BlockSet ring = flowing(ringCell(true), {1.0, 0.0, 0.0});
	expectLeaves(flown(ring, {0.5, 1.5, 0.5}, "flow"), {3.0, 1.5, 0.5}, 2.5);
	expectLeaves(flown(ring, {1.5, 1.5, 0.5}, "flow"), {3.0, 1.5, 0.5}, 1.5);
	// Half as long in the cell in the middle.
	addCellVectors(ring, {{1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}});
	expectLeaves(flown(ring, {0.5, 1.5, 0.5}, "wind"), {3.0, 1.5, 0.5}, 0.5 + 0.5 + 1.0);
	expectLeaves(flown(ring, {0.5, 0.5, 0.5}, "wind"), {3.0, 0.5, 0.5}, 2.5);
	grid::BlockSet shell = flowing(shellCell(true), {1.0, 0.0, 0.0});
	addCellVectors(shell, {{1.0, 0.0, 0.0}, {4.0, 0.0, 0.0}});
	expectLeaves(flown(shell, {0.5, 1.5, 1.5}, "flow"), {3.0, 1.5, 1.5}, 2.5);
	expectLeaves(flown(shell, {0.5, 1.5, 1.5}, "wind"), {3.0, 1.5, 1.5}, 0.5 + 0.25 + 1.0);
	grid::BlockSet u = flowing(uCell(true), {1.0, 0.0, 0.0});
	addCellVectors(u, {{1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}});
	expectLeaves(flown(u, {0.5, 2.0, 0.5}, "flow"), {3.0, 2.0, 0.5}, 2.5);
	expectLeaves(flown(u, {0.5, 2.0, 0.5}, "wind"), {3.0, 2.0, 0.5}, 0.5 + 2.0 + 1.0);
}

// Around the middle of the foot's upper side: from one arm through the foot's lower side, a quarter of a circle on.
TEST(Hollow, ParticlesTurnWithinTheCell)
{
	const grid::BlockSet u = withFields(uCell(),
	                                    [](const Vec3& p) {
		                                    return AtPlace{p.x, {1.0 - p.y, p.x - 1.5, 0.0}};
	                                    });
	expectLeaves(flown(u, {0.5, 2.0, 0.5}, "flow"), {0.5, 0.0, 0.5}, 0.5 * std::numbers::pi, 1e-4);
	const grid::BlockSet ring = withFields(ringCell(),
	                                       [](const Vec3& p) {
		                                       return AtPlace{p.x, {1.5 - p.y, p.x - 1.5, 0.0}};
	                                       });
	const Path around = flown(ring, {0.5, 1.5, 0.5}, "flow");
	EXPECT_EQ(around.why, TraceEnd::steps); // a circle of radius 1 goes around the hole
	EXPECT_NEAR(glm::length(around.end - Vec3(1.5, 1.5, 0.5)), 1.0, 1e-3);
}

namespace
{

// When a way along `along` from p, in the set's own axes, first leaves a prism over a polygon.
double leavesPrism(const std::vector<glm::dvec2>& polygon, double height, const Vec3& p, const Vec3& along)
{
	double first = along.z == 0.0 ? HUGE_VAL : ((along.z > 0.0 ? height : 0.0) - p.z) / along.z;
	const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
	for (std::size_t i = 0; i < polygon.size(); ++i)
	{
		const glm::dvec2 a = polygon[i] - glm::dvec2(p);
		const glm::dvec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
		const double turned = cross(glm::dvec2(along), side);
		const double time = cross(a, side) / turned;
		const double at = cross(a, glm::dvec2(along)) / turned;
		if (time > 0.0 && at >= 0.0 && at <= 1.0)
			first = std::min(first, time);
	}
	return first;
}

} // namespace

// Random prisms, each in a box that is the rest: straight through both to the side of the box, and if there is nothing
// around it only to the side of the prism, however concave that is.
TEST(Hollow, ParticlesRunStraightThroughRandomPrisms)
{
	std::size_t parted = 0;
	for (int i = 0; i < tries(60); ++i)
	{
		SCOPED_TRACE(i);
		const PrismSet prism = prismSet(static_cast<unsigned>(i));
		Draw draw(static_cast<unsigned>(i));
		RawSet alone = prism.raw;
		alone.blocks[0].cells.resize(1);
		const std::vector<glm::dvec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
		for (int n = 0; n < 6; ++n)
		{
			const Vec3 along = draw.direction();
			const Vec3 flow = prism.placed(along) - prism.shift;
			const Vec3 p(draw.real(0.01, 0.99), draw.real(0.01, 0.99), draw.real(0.01, 0.99) * prism.height);
			const double through = leavesPrism(square, prism.height, p, along);
			expectLeaves(flown(flowing(prism.raw, flow), prism.placed(p), "flow"), prism.placed(p + through * along),
			             through);
			const grid::BlockSet only = flowing(alone, flow);
			if (!locate::PlaceFinder(only).find(prism.placed(p)).found())
				continue;
			const double within = leavesPrism(prism.polygon, prism.height, p, along);
			expectLeaves(flown(only, prism.placed(p), "flow"), prism.placed(p + within * along), within);
			++parted;
		}
		if (testing::Test::HasFailure())
			return;
	}
	EXPECT_GT(parted, static_cast<std::size_t>(tries(20)));
}

} // namespace vp::test
