#include "read/read.h"
#include "sample_files.h"
#include "tries.h"

#include <gtest/gtest.h>

using namespace vp;

namespace
{

// One cell, with a value at each point.
std::string tetrahedron(const char* apex, const char* values)
{
	return std::string("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
	                   "0 0 0 1 0 0 0 1 0 ") +
	       apex + "\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\nSCALARS f float\nLOOKUP_TABLE default\n" +
	       values + "\n";
}

} // namespace

TEST(Values, AreTakenOverWhereTheGridIsTheSame)
{
	const TemporaryFolder folder;
	const std::string path = folder / "t.vtk";
	writeContents(path, tetrahedron("0 0 1", "1 2 3 4"));
	auto set = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	const CellId before = std::get<grid::UnstructuredGrid>(set->blocks[0].grid).cellCount();

	writeContents(path, tetrahedron("0 0 1", "5 6 7 8"));
	const auto same = read::readValues({path}, {}, *set, nullptr);
	ASSERT_TRUE(same) << same.error().message;
	EXPECT_TRUE(*same);
	EXPECT_EQ(set->blocks[0].fields[0].value(3, 0), 8.0);
	EXPECT_EQ(std::get<grid::UnstructuredGrid>(set->blocks[0].grid).cellCount(), before);
}

TEST(Values, AreLeftWhereAPointMoved)
{
	const TemporaryFolder folder;
	const std::string path = folder / "t.vtk";
	writeContents(path, tetrahedron("0 0 1", "1 2 3 4"));
	auto set = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	writeContents(path, tetrahedron("0 0 1.5", "5 6 7 8"));
	const auto same = read::readValues({path}, {}, *set, nullptr);
	ASSERT_TRUE(same) << same.error().message;
	EXPECT_FALSE(*same);
	EXPECT_EQ(set->blocks[0].fields[0].value(3, 0), 4.0);
}

// Every format that is written here, read once more.
TEST(Values, EveryFormatIsTheSameGridTwice)
{
	test::Taken taken;
	for (const SampleFile& sample : sampleFiles())
	{
		if (!taken.next())
			continue;
		const TemporaryFolder folder;
		const std::string path = folder / sample.name;
		sample.write(path);
		auto set = read::readInputs({path}, {}, nullptr);
		ASSERT_TRUE(set) << set.error().message;
		const auto same = read::readValues({path}, {}, *set, nullptr);
		ASSERT_TRUE(same) << same.error().message;
		EXPECT_TRUE(*same) << sample.name;
	}
}
