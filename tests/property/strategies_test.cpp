// Every strategy that a set can take finds the same cells and the same figures.
#include "listed_block.h"
#include "overlapping_sets.h"
#include "random_sets.h"
#include "sliced_sheet.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace vp::test
{

namespace
{

struct Way
{
	std::string name;
	bool in_generations = false;
	bool device_first = false;
	std::optional<find::Strategy> strategy{};
};

std::vector<Way> ways()
{
	using enum find::Strategy;
	std::vector<Way> all{{.name = "in generations", .in_generations = true},
	                     {.name = "device first", .device_first = true},
	                     {.name = "fastest"}};
	for (const find::Strategy strategy : {rows, spans, cells, generations, scan})
		all.push_back({.name = find::nameOf(strategy), .strategy = strategy});
	return all;
}

// The result of one strategy for a plane, with the source numbers of cells.
struct Found
{
	std::vector<std::vector<std::size_t>> cells; // per block
	measure::SheetMeasure figures;
};

std::optional<Found> findBy(const Way& way, cut::Cutter& cutter, const TestPlane& plane)
{
	const grid::FieldChoice linear{"linear", grid::Association::point, 0};
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.field = linear;
	request.in_generations = way.in_generations;
	request.device_first = way.device_first;
	request.strategy = way.strategy;
	if (const auto plan = cutter.plan(request); !plan || plan->needs_neighbors)
		return std::nullopt;
	const Result<cut::Cut> made = cutter.cut(request);
	if (!made)
		return std::nullopt;
	const grid::BlockSet& blocks = cutter.blocks();
	Found found;
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
	{
		std::vector<std::size_t>& of_block = found.cells.emplace_back();
		visitGrid(blocks.blocks[b],
		          [&](const auto& grid)
		          {
			          find::forEachCutCell(blocks.blocks[b], made->sheets[0].cuts[b],
			                               [&](CellId cell) { of_block.push_back(grid.sourceCell(cell)); });
		          });
		std::ranges::sort(of_block);
	}
	found.figures = measure::measure(blocks, made->mesh(blocks, 0), linear);
	return found;
}

bool isAlike(double a, double b, double scale)
{
	return std::abs(a - b) <= 1e-12 * scale;
}

double largestValue(const grid::BlockSet& set)
{
	double largest = 0.0;
	for (const grid::Block& block : set.blocks)
		visitGrid(block,
		          [&](const auto& grid)
		          {
			          for (PointId p = 0; p < grid.pointCount(); ++p)
				          largest = std::max(largest, std::abs(linearAt(grid.point(p))));
		          });
	return largest;
}

void expectSame(const Found& found, const Found& expected, double largest)
{
	EXPECT_EQ(found.cells, expected.cells);
	const measure::SheetMeasure& a = found.figures;
	const measure::SheetMeasure& b = expected.figures;
	EXPECT_PRED3(isAlike, a.area, b.area, std::max(1e-300, b.area));
	EXPECT_PRED3(isAlike, a.boundary_area, b.boundary_area, std::max(1e-300, b.boundary_area));
	ASSERT_EQ(a.mean.has_value(), b.mean.has_value());
	if (a.mean && b.mean)
	{
		EXPECT_PRED3(isAlike, *a.mean, *b.mean, largest);
	}
	ASSERT_EQ(a.boundary_mean.has_value(), b.boundary_mean.has_value());
	if (a.boundary_mean && b.boundary_mean)
	{
		EXPECT_PRED3(isAlike, *a.boundary_mean, *b.boundary_mean, largest);
	}
	if (a.min && b.min)
	{
		EXPECT_PRED3(isAlike, *a.min, *b.min, largest);
		EXPECT_PRED3(isAlike, *a.max, *b.max, largest);
	}
}

// Returns the set without neighbors. Returns nothing if a block is a lattice.
std::optional<grid::BlockSet> listedSet(const grid::BlockSet& set)
{
	grid::BlockSet listed;
	for (const grid::Block& block : set.blocks)
	{
		if (!std::holds_alternative<grid::UnstructuredGrid>(block.grid))
			return std::nullopt;
		listed.blocks.push_back(listedBlock(block));
	}
	listed.matches_seams = false;
	return listed;
}

// Cells by their numbers in `linked`: a listed block has these for its own.
void toOwnNumbers(Found& found, const grid::BlockSet& linked)
{
	for (std::size_t b = 0; b < found.cells.size(); ++b)
	{
		visitGrid(linked.blocks[b],
		          [&](const auto& grid)
		          {
			          for (std::size_t& cell : found.cells[b])
				          cell = grid.sourceCell(static_cast<CellId>(cell));
		          });
		std::ranges::sort(found.cells[b]);
	}
}

// Every way against the traversal. Returns how many ways there were.
std::size_t compareWays(const grid::BlockSet& set, cut::Cutter& cutter, cut::Cutter* listed, const TestPlane& plane,
                        double largest)
{
	std::size_t count = 0;
	std::optional<Found> expected;
	for (const Way& way : ways())
	{
		SCOPED_TRACE(way.name);
		if (const std::optional<Found> found = findBy(way, cutter, plane))
		{
			++count;
			expected = expected ? expected : found;
			expectSame(*found, *expected, largest);
		}
		if (!listed)
			continue;
		SCOPED_TRACE("listed");
		if (std::optional<Found> found = findBy(way, *listed, plane))
		{
			++count;
			toOwnNumbers(*found, set);
			expectSame(*found, *expected, largest);
		}
	}
	return count;
}

// Returns the ways of the plane that had the fewest.
std::size_t compareWays(const RawSet& raw, const std::vector<TestPlane>& planes)
{
	const grid::BlockSet set = build(raw);
	const std::optional<grid::BlockSet> list = listedSet(set);
	cut::Cutter cutter(set);
	std::unique_ptr<cut::Cutter> listed;
	if (list)
		listed = std::make_unique<cut::Cutter>(*list);
	const double largest = largestValue(set);
	std::size_t least = ways().size();
	for (const TestPlane& plane : planes)
	{
		least = std::min(least, compareWays(set, cutter, listed.get(), plane, largest));
		if (testing::Test::HasFailure())
		{
			ADD_FAILURE() << raw.name << (list ? ", cells" : "") << ", plane at " << plane.origin.x << ' '
			              << plane.origin.y << ' ' << plane.origin.z << ", normal " << plane.normal.x << ' '
			              << plane.normal.y << ' ' << plane.normal.z;
			return least;
		}
	}
	return least;
}

class OverlappingSet : public testing::TestWithParam<RawSet>
{
};

} // namespace

TEST_P(OverlappingSet, IsCutAlikeByAllStrategies)
{
	EXPECT_GE(compareWays(GetParam(), planesOfOverlappingSets()), 4u);
}

INSTANTIATE_TEST_SUITE_P(, OverlappingSet, testing::ValuesIn(overlappingSets()),
                         [](const auto& info) { return "Number" + std::to_string(info.index); });

TEST(Strategies, AgreeOnRandomSets)
{
	for (int number = 0; number < tries(140); ++number)
	{
		SCOPED_TRACE(number);
		const RawSet raw = randomSet(7000 + static_cast<unsigned>(number));
		const grid::BlockSet set = build(raw);
		std::vector<TestPlane> planes;
		for (int n = 0; n < 4; ++n)
			planes.push_back(randomPlane(set, static_cast<unsigned>(4 * number + n)));
		EXPECT_GE(compareWays(raw, planes), 4u);
		if (testing::Test::HasFailure())
			return;
	}
}

} // namespace vp::test
