#include "name_of_sample.h"
#include "read/read.h"
#include "tries.h"

#include <gtest/gtest.h>

using namespace vp;

namespace
{

class EachFormatWithAWish : public testing::TestWithParam<std::size_t>
{
};

std::vector<std::string> namesOf(const grid::Block& block)
{
	std::vector<std::string> names;
	for (const grid::Field& field : block.fields)
		names.push_back(std::string(grid::associationName(field.association)) + ":" + field.name);
	return names;
}

} // namespace

TEST_P(EachFormatWithAWish, GivesTheArraysOfThatName)
{
	const SampleFile& sample = sampleFiles()[GetParam()];
	const TemporaryFolder folder;
	const std::string path = folder / sample.name;
	sample.write(path);
	const auto whole = read::readInputs({path}, {}, nullptr);
	read::ReadOptions options;
	options.arrays.all = false;
	options.identifies_geometry = false;
	const auto none = read::readInputs({path}, options, nullptr);
	options.arrays.names = {"f"};
	const auto one = read::readInputs({path}, options, nullptr);
	options.arrays = {false, {"cell:g"}, true};
	const auto two = read::readInputs({path}, options, nullptr);
	ASSERT_TRUE(whole && none && one && two);
	for (std::size_t b = 0; b < whole->blocks.size(); ++b)
	{
		const std::vector<std::string> all = namesOf(whole->blocks[b]);
		EXPECT_TRUE(whole->blocks[b].arrays_left_out.empty());
		EXPECT_NE(whole->blocks[b].geometry, 0u);
		EXPECT_EQ(none->blocks[b].geometry, 0u);
		EXPECT_TRUE(none->blocks[b].fields.empty());
		EXPECT_EQ(none->blocks[b].arrays_left_out, all);
		const auto expectBut = [&](const grid::Block& block, const std::vector<std::string>& wanted)
		{
			std::vector<std::string> given;
			std::vector<std::string> left_out;
			for (const std::string& name : all)
				(std::find(wanted.begin(), wanted.end(), name) == wanted.end() ? left_out : given).push_back(name);
			EXPECT_EQ(namesOf(block), given);
			EXPECT_EQ(block.arrays_left_out, left_out);
		};
		expectBut(one->blocks[b], {"point:f", "cell:f"});
		expectBut(two->blocks[b], {all[0], "cell:g"});
	}
}

INSTANTIATE_TEST_SUITE_P(Read, EachFormatWithAWish,
                         testing::Range(std::size_t(0), sampleFiles().size(), std::size_t(test::takeParameterEvery())),
                         nameOfSample);
