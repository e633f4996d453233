#include "run_pairs.h"

#include "pair_checks.h"
#include "random_window.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <random>

namespace vp::test
{

namespace
{

// As many planes cut a set before the next one is built.
constexpr unsigned kPlanesPerSet = 5;

std::string describe(unsigned number, const RawSet& raw, const grid::BlockSet& set, const TestPlane& plane)
{
	std::size_t points = 0;
	for (const grid::Block& block : set.blocks)
		points += visitGrid(block, [](const auto& grid) { return grid.pointCount(); });
	char text[500];
	const Box box = set.bounds();
	std::snprintf(text, sizeof(text),
	              "VPROBE_PAIR=%u: %s, %zu blocks, %zu cells, %zu points%s%s, from %.9g %.9g %.9g to %.9g %.9g %.9g; "
	              "origin %.17g %.17g %.17g, normal %.17g %.17g %.17g",
	              number, raw.name.c_str(), set.blocks.size(), set.cellCount(), points,
	              raw.flat_faces ? ", flat faces" : "", raw.blocks[0].floats ? ", floats" : "", box.lo.x, box.lo.y,
	              box.lo.z, box.hi.x, box.hi.y, box.hi.z, plane.origin.x, plane.origin.y, plane.origin.z,
	              plane.normal.x, plane.normal.y, plane.normal.z);
	return text;
}

} // namespace

void runPairs(unsigned first, unsigned count)
{
	unsigned last = first + count;
	if (const char* only = std::getenv("VPROBE_PAIR"))
	{
		first = static_cast<unsigned>(std::strtoul(only, nullptr, 10));
		last = first + 1;
	}
	RawSet raw;
	grid::BlockSet set;
	std::unique_ptr<cut::Cutter> cutter;
	for (unsigned number = first; number < last; ++number)
	{
		if (!cutter || number % kPlanesPerSet == 0)
		{
			cutter.reset();
			raw = randomSet(number / kPlanesPerSet);
			set = build(raw);
			for (const grid::Block& block : set.blocks)
				grid::validate(block);
			cutter = std::make_unique<cut::Cutter>(set);
		}
		const TestPlane asked = randomPlane(set, number);
		const TestPlane plane{asked.origin, probe::makeSheet(asked.origin, asked.normal).normal};
		const Pair pair{raw, set, asked, plane, cut(*cutter, asked), isGeneric(set, plane)};
		checkCells(pair);
		checkVertices(pair);
		checkAreas(pair);
		checkWatertight(pair);
		checkInvariance(pair, number);
		checkFinders(pair, *cutter, std::nullopt);
		std::mt19937 random(number);
		checkFinders(pair, *cutter, randomWindow(set.bounds(), random));
		if (testing::Test::HasFailure())
		{
			ADD_FAILURE() << describe(number, raw, set, asked);
			return;
		}
	}
}

} // namespace vp::test
