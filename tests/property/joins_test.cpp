// Joins change no figure: those of a whole are those of each of its cells, as a data set of its own.
#include "contact_sets.h"
#include "pair_checks.h"
#include "random_sets.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace vp::test
{

namespace
{

// The shown array. "linear" is continuous across any join, "smooth" if faces match, and the others jump anywhere, from
// copy to copy of a point.
const std::vector<grid::FieldChoice> kArrays = {{"linear"},
                                                {"smooth"},
                                                {"jump"},
                                                {"vector", grid::Association::point, grid::kMagnitude},
                                                {"vector", grid::Association::point, 1},
                                                {"point_ids"},
                                                {"id", grid::Association::cell}};

// A number between -1 and 1 for each pair.
double scattered(std::size_t block, std::size_t point)
{
	std::uint64_t x = (block * 1000003 + point + 1) * 0x9E3779B97F4A7C15ull;
	x ^= x >> 31;
	x *= 0xBF58476D1CE4E5B9ull;
	x ^= x >> 29;
	return 2.0 * static_cast<double>(x >> 11) * 0x1p-53 - 1.0;
}

// The arrays of one block in the order of its source's points: place and number of each.
void addArrays(grid::Block& block, const std::vector<Vec3>& places, const std::vector<std::size_t>& numbers,
               std::size_t of_block)
{
	std::vector<double> smooth;
	std::vector<double> jump;
	std::vector<double> vector;
	std::vector<std::int32_t> ids;
	for (std::size_t p = 0; p < places.size(); ++p)
	{
		const double some = scattered(of_block, numbers[p]);
		smooth.push_back(std::sin(places[p].x) + std::cos(2.0 * places[p].y) * places[p].z);
		jump.push_back(some);
		vector.insert(vector.end(), {some, -3.0 * some, scattered(of_block + 7, numbers[p])});
		ids.push_back(static_cast<std::int32_t>(1000 * of_block + numbers[p]));
	}
	const auto add = [&](const char* name, int components, auto values)
	{ block.fields.push_back(grid::makeField(name, grid::Association::point, components, std::move(values))); };
	add("smooth", 1, std::move(smooth));
	add("jump", 1, std::move(jump));
	add("vector", 3, std::move(vector));
	add("point_ids", 1, std::move(ids));
	block.fields.back().categorical = grid::namesCategories(block.fields.back());
}

// A set with its arrays, and its cells one by one.
class Parted
{
public:
	explicit Parted(RawSet raw) : raw_(std::move(raw)), set_(build(raw_))
	{
		for (std::size_t b = 0; b < set_.blocks.size(); ++b)
		{
			std::vector<Vec3>& places = places_.emplace_back(raw_.blocks[b].points);
			visitGrid(set_.blocks[b],
			          [&](const auto& grid)
			          {
				          for (PointId p = 0; p < grid.pointCount(); ++p)
					          places[grid.sourcePoint(p)] = grid.point(p);
			          });
			std::vector<std::size_t> numbers;
			for (std::size_t p = 0; p < places.size(); ++p)
				numbers.push_back(p);
			addArrays(set_.blocks[b], places, numbers, b);
		}
	}
	const RawSet& raw() const { return raw_; }
	const grid::BlockSet& set() const { return set_; }

	// Cell data are those of the whole.
	const grid::BlockSet& cell(std::uint32_t block, CellId cell)
	{
		const auto [at, is_new] = cells_.try_emplace({block, cell});
		if (is_new)
			at->second = alone(block, cell);
		return at->second;
	}

private:
	grid::BlockSet alone(std::uint32_t b, CellId cell) const
	{
		const RawBlock& whole = raw_.blocks[b];
		const auto source =
		    visitGrid(set_.blocks[b], [&](const auto& grid) { return std::size_t(grid.sourceCell(cell)); });
		RawBlock one;
		std::vector<std::size_t> numbers;
		std::map<std::int64_t, std::int64_t> known;
		const auto take = [&](std::int64_t id)
		{
			const auto [at, is_new] = known.try_emplace(id, static_cast<std::int64_t>(numbers.size()));
			if (is_new)
				numbers.push_back(static_cast<std::size_t>(id));
			return at->second;
		};
		if (whole.kind == RawKind::cells)
		{
			RawCell made = whole.cells[source];
			for (std::int64_t& id : made.ids)
				id = take(id);
			for (std::vector<std::int64_t>& face : made.faces)
				for (std::int64_t& id : face)
					id = take(id);
			one.cells.push_back(std::move(made));
		}
		else
		{
			const auto [ni, nj, nk] = whole.points_along;
			const std::size_t i = source % (ni - 1);
			const std::size_t j = source / (ni - 1) % (nj - 1);
			const std::size_t k = source / (ni - 1) / (nj - 1);
			one.kind = RawKind::curvilinear;
			one.points_along = {2, 2, 2};
			for (std::size_t corner = 0; corner < 8; ++corner)
				numbers.push_back(((k + corner / 4) * nj + j + corner / 2 % 2) * ni + i + corner % 2);
		}
		for (const std::size_t p : numbers)
			one.points.push_back(places_[b][p]);
		one.floats = whole.floats;
		RawSet raw{"one cell", {one}};
		grid::BlockSet set = build(raw);
		addArrays(set.blocks[0], one.points, numbers, b);
		for (grid::Field& field : set.blocks[0].fields)
			if (field.name == "id" && field.association == grid::Association::cell)
				field = idField(b, source, field);
		return set;
	}
	grid::Field idField(std::uint32_t b, std::size_t source, const grid::Field& like) const
	{
		const auto& fields = set_.blocks[b].fields;
		const auto whole = std::ranges::find_if(fields, [&](const grid::Field& f)
		                                        { return f.name == like.name && f.association == like.association; });
		return grid::makeField(like.name, like.association, 1, std::vector<double>{whole->value(source, 0)});
	}

	RawSet raw_;
	grid::BlockSet set_;
	std::vector<std::vector<Vec3>> places_; // places of the points, by their numbers in the source
	std::map<std::pair<std::uint32_t, CellId>, grid::BlockSet> cells_;
};

cut::Cut cutOf(const grid::BlockSet& set, const TestPlane& plane, mesh::Hanging hanging,
               const std::optional<probe::Window>& window)
{
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.probe.sheets[0].window = window;
	request.hanging = hanging;
	request.in_generations = true;
	return std::move(cutter.cut(std::move(request)).value());
}

struct Sums
{
	double area = 0.0;
	double value_area = 0.0;
	double min = std::numeric_limits<double>::infinity();
	double max = -std::numeric_limits<double>::infinity();
	bool has_faces = false; // in the plane, which count in the range alone

	void add(const grid::BlockSet& set, const mesh::SheetMesh& mesh, const grid::FieldChoice& array)
	{
		const measure::SheetMeasure figures = measure::measure(set, mesh, array);
		area += figures.area;
		value_area += figures.area * figures.mean.value_or(0.0);
		min = std::min(min, figures.min.value_or(min));
		max = std::max(max, figures.max.value_or(max));
		has_faces = has_faces || mesh.boundary_polygons > 0;
	}
};

double largestOf(const grid::BlockSet& set, const grid::FieldChoice& array)
{
	double largest = 0.0;
	for (const grid::Block& block : set.blocks)
	{
		const grid::Field* field = array.in(block);
		for (std::size_t t = 0; t < field->tuples(); ++t)
			for (int c = 0; c < field->components; ++c)
				largest = std::max(largest, std::abs(field->value(t, c)));
	}
	return largest;
}

void checkJoins(Parted& parted, const TestPlane& plane, const std::optional<probe::Window>& window)
{
	const grid::BlockSet& set = parted.set();
	const Box box = set.bounds();
	const double reach = glm::length(glm::max(glm::abs(box.lo), glm::abs(box.hi)));
	const bool generic = isGeneric(set, TestPlane{plane.origin, probe::makeSheet(plane.origin, plane.normal).normal});
	for (const mesh::Hanging hanging : {mesh::Hanging::keep, mesh::Hanging::interpolate})
	{
		const cut::Cut cut = cutOf(set, plane, hanging, window);
		const mesh::SheetMesh mesh = cut.mesh(set, 0);
		std::vector<std::pair<const grid::BlockSet*, mesh::SheetMesh>> cells;
		for (std::uint32_t b = 0; b < set.blocks.size(); ++b)
			find::forEachCutCell(set.blocks[b], cut.sheets[0].cuts[b],
			                     [&](CellId cell)
			                     {
				                     const grid::BlockSet& one = parted.cell(b, cell);
				                     cells.emplace_back(&one, cutOf(one, plane, hanging, window).mesh(one, 0));
			                     });
		for (const grid::FieldChoice& array : kArrays)
		{
			Sums whole;
			whole.add(set, mesh, array);
			Sums sum;
			for (const auto& [one, of_cell] : cells)
				sum.add(*one, of_cell, array);
			const double largest = largestOf(set, array);
			// Large coordinates have large rounding errors.
			const double rounding = 256.0 * std::numeric_limits<double>::epsilon() * reach;
			const double slack = 1e-12 * sum.area + rounding * box.diagonal();
			EXPECT_NEAR(whole.area, sum.area, slack) << array.name;
			if (hanging == mesh::Hanging::interpolate)
				continue;
			EXPECT_NEAR(whole.value_area, sum.value_area, 2.0 * slack * largest) << array.name;
			if (!generic || whole.has_faces || sum.has_faces || !(whole.min <= whole.max))
				continue;
			EXPECT_NEAR(whole.min, sum.min, 1e-12 * largest) << array.name;
			EXPECT_NEAR(whole.max, sum.max, 1e-12 * largest) << array.name;
		}
	}
}

// About the middle of the bounds, so that it cuts polygons.
std::optional<probe::Window> windowOf(const grid::BlockSet& set, const TestPlane& plane, unsigned number)
{
	if (number % 3 != 0)
		return std::nullopt;
	const double side = 0.25 * set.bounds().diagonal();
	const probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
	const Vec3 middle = set.bounds().center() - sheet.origin;
	const double x = glm::dot(middle, sheet.xAxis());
	const double y = glm::dot(middle, sheet.up);
	return probe::Window{x - 0.9 * side, x + side, y - side, y + 0.8 * side};
}

unsigned setCount()
{
	return std::getenv("VPROBE_LONG") ? 600 : static_cast<unsigned>(tries(60));
}

} // namespace

TEST(Joins, FiguresInContactAreThoseOfEachCell)
{
	std::size_t hangs = 0;
	std::size_t jumps = 0;
	const unsigned sets = setCount();
	for (unsigned seed = 0; seed < sets && !testing::Test::HasFailure(); ++seed)
	{
		SCOPED_TRACE("contact set " + std::to_string(seed));
		Parted parted(contactSet(seed));
		SCOPED_TRACE(parted.raw().name);
		for (const unsigned number : {2 * seed, 2 * seed + 1})
		{
			const TestPlane plane = randomPlane(parted.set(), number);
			SCOPED_TRACE("plane " + std::to_string(number));
			const std::optional<probe::Window> window = windowOf(parted.set(), plane, number);
			checkJoins(parted, plane, window);
			const mesh::SheetMesh mesh = cutOf(parted.set(), plane, mesh::Hanging::keep, window).mesh(parted.set(), 0);
			hangs += !mesh.is_added.empty();
			jumps += !mesh.seam_pairs.empty();
		}
	}
	EXPECT_GT(4 * hangs, sets);
	EXPECT_GT(2 * jumps, sets);
}

TEST(Joins, FiguresOfRandomSetsAreThoseOfEachCell)
{
	const unsigned sets = setCount();
	for (unsigned seed = 0; seed < sets && !testing::Test::HasFailure(); ++seed)
	{
		SCOPED_TRACE("random set " + std::to_string(seed));
		Parted parted(randomSet(1000 + seed));
		SCOPED_TRACE(parted.raw().name);
		const TestPlane plane = randomPlane(parted.set(), seed);
		checkJoins(parted, plane, windowOf(parted.set(), plane, seed));
	}
}

} // namespace vp::test
