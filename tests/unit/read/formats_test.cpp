#include "name_of_sample.h"
#include "read/read.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace vp;

namespace
{

class EachFormat : public testing::TestWithParam<std::size_t>
{
};

// The formats with arrays of fixed names.
void renameArrays(grid::BlockSet& set)
{
	static const std::set<std::string> kNames = {"MetaImage",   "NIFTI",          "Density", "density",  "values",
	                                             "DICOM",       "MINC",           "trace",   "SLCImage", "PRESSURE",
	                                             "temperature", "plastic strain", "EP_g",    "SV_T"};
	for (grid::Block& block : set.blocks)
		for (grid::Field& field : block.fields)
			if (kNames.contains(field.name))
				field.name = field.association == grid::Association::point ? "f" : "g";
}

} // namespace

TEST_P(EachFormat, GivesCountsAndValues)
{
	const SampleFile& sample = sampleFiles()[GetParam()];
	const TemporaryFolder folder;
	const std::string path = folder / sample.name;
	sample.write(path);

	auto set = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	EXPECT_EQ(set->kind(), sample.kind);
	EXPECT_EQ(set->cellCount(), sample.cells);
	EXPECT_EQ(set->pointCount(), sample.points);
	EXPECT_EQ(set->left_out, 0u);
	renameArrays(*set);
	for (const grid::Block& block : set->blocks)
	{
		EXPECT_NO_THROW(grid::validate(block));
		expectSampleValues(block, sample.cell_array, sample.point_array);
	}
}

INSTANTIATE_TEST_SUITE_P(Read, EachFormat, testing::Range(std::size_t(0), sampleFiles().size()), nameOfSample);
