// Which parts of a file are handed over: numbers are the same whichever parts are asked for, and slabs cover a lattice.
#include "vprobe-read/base/part_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

using vp::reader::InsidePart;
using vp::reader::PartFilter;

namespace
{

std::vector<std::size_t> cellsOf(const PartFilter& filter)
{
	std::vector<std::size_t> cells;
	for (const auto& part : filter.parts())
		cells.push_back(part["cells"]);
	return cells;
}

TEST(PartFilter, SlabsCoverALatticeOnce)
{
	for (std::size_t slabs = 2; slabs < 9; ++slabs)
		for (std::size_t layers = 2; layers < 20; ++layers)
		{
			const std::string divided = "/" + std::to_string(slabs);
			PartFilter list("?" + divided);
			EXPECT_FALSE(list.beginLattice({{"kind", "image"}}, layers, 10));
			const std::vector<std::size_t> cells = cellsOf(list);
			EXPECT_EQ(cells.size(), std::min(slabs, layers));
			EXPECT_EQ(std::accumulate(cells.begin(), cells.end(), std::size_t(0)), layers * 10);
			std::size_t end = 0;
			for (std::size_t slab = 0; slab < cells.size(); ++slab)
			{
				PartFilter one(std::to_string(slab) + divided);
				const auto own = one.beginLattice({{"kind", "image"}}, layers, 10);
				ASSERT_TRUE(own);
				EXPECT_EQ(own->begin, end);
				EXPECT_EQ(own->count() * 10, cells[slab]);
				EXPECT_EQ(one.number(), slab);
				EXPECT_EQ(one.parts(), list.parts());
				EXPECT_EQ(one.blocks(), list.blocks());
				end = own->end;
			}
			EXPECT_EQ(end, layers);
		}
}

TEST(PartFilter, SlabsThatFollowEachOtherAreOne)
{
	PartFilter filter("1,2/4");
	const auto layers = filter.beginLattice(nullptr, 10, 1); // 3, 3, 2 and 2 layers
	ASSERT_TRUE(layers);
	EXPECT_EQ(layers->begin, 3u);
	EXPECT_EQ(layers->end, 8u);
	EXPECT_EQ(filter.number(), 1u);
}

TEST(PartFilter, SlabsAreOfOneBlockAndOtherPartsAreNot)
{
	PartFilter filter("0,1,2,3/2");
	EXPECT_TRUE(filter.begin(5));
	EXPECT_TRUE(filter.beginLattice({{"points", 8}}, 4, 6));
	EXPECT_EQ(cellsOf(filter), (std::vector<std::size_t>{5, 12, 12}));
	EXPECT_EQ(filter.parts()[0]["block"], 0);
	EXPECT_EQ(filter.parts()[1]["block"], 1);
	EXPECT_EQ(filter.parts()[2]["block"], 1);
	EXPECT_TRUE(filter.blocks()[0].is_null());
	EXPECT_EQ(filter.blocks()[1]["points"], 8);
}

TEST(PartFilter, ALatticeWithinAPartStaysWhole)
{
	PartFilter filter("0/3");
	ASSERT_TRUE(filter.begin(7));
	const InsidePart inside(filter);
	const auto layers = filter.beginLattice(nullptr, 9, 1);
	ASSERT_TRUE(layers);
	EXPECT_EQ(layers->count(), 9u);
	EXPECT_EQ(filter.parts().size(), 1u);
}

TEST(PartFilter, OneLayerStaysWhole)
{
	PartFilter filter("0/3");
	const auto layers = filter.beginLattice(nullptr, 1, 4);
	ASSERT_TRUE(layers);
	EXPECT_EQ(layers->count(), 1u);
	EXPECT_EQ(filter.parts().size(), 1u);
}

} // namespace
