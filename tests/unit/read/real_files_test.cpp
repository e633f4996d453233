// Published data sets, where the environment variable VPROBE_DATA names the folder that holds them.
#include "base/timeline.h"
#include "read/read.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

using namespace vp;

namespace
{

struct ExpectedArray
{
	const char* name;
	grid::Association association;
	int components;
	double low; // least value; for several components, the least length
	double high;
};

struct ExpectedFile
{
	const char* path;
	const char* kind;
	std::size_t cells;
	std::size_t points;
	std::size_t left_out;
	std::vector<ExpectedArray> arrays;
};

constexpr auto point = grid::Association::point;
constexpr auto cell = grid::Association::cell;

const std::vector<ExpectedFile> kFiles = {
    {"voxel/ironProt/ironProt.vtk", "image", 300763, 314432, 0, {{"scalars", point, 1, 0, 255}}},
    {"voxel/HeadMRVolume/HeadMRVolume.mhd", "image", 117547, 124992, 0, {{"MetaImage", point, 1, 0, 255}}},
    {"voxel/aneurism/aneurism.vti", "image", 16581375, 16777216, 0, {{"ImageFile", point, 1, 0, 255}}},
    {"uniform/carotid/carotid.vtk",
     "image",
     158400,
     167580,
     0,
     {{"scalars", point, 1, 0, 580}, {"vectors", point, 3, 0, 22.69}}},
    {"rectilinear/RectGrid2/RectGrid2.vtk",
     "rectilinear",
     14720,
     17061,
     0,
     {{"scalars", point, 1, 0, 10.4}, {"vectors", point, 3, 0, 10.4}}},
    {"structured/bluntfin/bluntfinxyz.bin",
     "curvilinear",
     37479,
     40960,
     0,
     {{"Density", point, 1, 0.1926, 4.977},
      {"Momentum", point, 3, 0, 6.256},
      {"StagnationEnergy", point, 1, 0.769, 25.16},
      {"Pressure", point, 1, 0.2595, 10.01}}},
    {"structured/SampleStructGrid/SampleStructGrid.vtk",
     "curvilinear",
     21489,
     24000,
     0,
     {{"scalars", point, 1, 0, 1.305}, {"scalars", cell, 1, -0.2629, 1}}},
    {"structured/office/office.binary.vtk",
     "curvilinear",
     7220,
     8400,
     0,
     {{"scalars", point, 1, -3.87, 0.7186}, {"vectors", point, 3, 0, 0.8049}}},
    {"multiblock/multi_bin/multi-bin-C.xyz", "block-structured", 1694, 2304, 0, {}},
    {"unstructured/hexa/hexa.vtk", "unstructured", 10648, 12167, 0, {{"scalars", point, 1, 0.7531, 17.32}}},
    {"unstructured/uGridEx/uGridEx.vtk",
     "unstructured",
     4,
     27,
     8,
     {{"scalars", point, 1, 0, 26}, {"vectors", point, 3, 1, 2}}},
    {"unstructured/disk_out_ref/disk_out_ref.ex2",
     "unstructured",
     7472,
     8499,
     0,
     {{"Temp", point, 1, 293.1, 913.2},
      {"V", point, 3, 0, 22.42},
      {"Pres", point, 1, 0.006786, 0.02882},
      {"AsH3", point, 1, 0.08048, 0.1848},
      {"GaMe3", point, 1, 0.0002228, 0.007214},
      {"CH4", point, 1, 0, 0.00117},
      {"H2", point, 1, 0.8076, 0.9177},
      {"ObjectId", cell, 1, 1, 1}}},
    {"unstructured/post_tets/post.vtk", "unstructured", 8750, 2288, 0, {{"Pressure", point, 1, 0.3554, 1.641}}},
    {"unstructured/box_hybrid/box_hybrid_mesh.vtu", "unstructured", 9407, 3655, 0, {{"attribute", cell, 1, 1, 6}}},
    {"polyhedral/pebi3d/pebi3d_with_properties.vtu",
     "unstructured",
     1630,
     3388,
     0,
     {{"DENSITY", cell, 1, 2600, 2700}, {"PERM", cell, 3, 1.732e-16, 5.196e-16}}},
    {"time/mug/mug.e", "unstructured", 2476, 3954, 0, {{"convected", point, 1, 0, 1}}},
    {"voxel/headsq/headsq/quarter.nhdr", "image", 365148, 380928, 0, {{"NRRD", point, 1, 0, 3926}}},
    {"multiblock/5blocks_struc/5blocks-struc.cgns", "block-structured", 1809, 2620, 0, {}},
    {"multiblock/sqnz/sqnz_s.adf.cgns", "block-structured", 11264, 15228, 0, {}},
    {"polyhedral/ensight_nfaced/TEST_bin.case",
     "unstructured",
     140,
     350,
     151,
     {{"Velocity", cell, 3, 0.007215, 0.03655}}},
    {"polyhedral/flange/flange.foam",
     "unstructured",
     15336,
     21024,
     0,
     {{"T", point, 1, 273, 573}, {"grad(T)", cell, 3, 1.945, 1.123e5}}},
    {"amr/HierarchicalBox/HierarchicalBoxDataset.v1.1.vthb", "block-structured", 2241, 5120, 0, {}},
    {"amr/chombo3d/chombo3d.vtm", "hybrid", 8968, 12679, 0, {}},
    {"time/can_hdf/can_1.hdf", "unstructured", 4800, 6724, 0, {{"EQPS", cell, 1, 0, 1.884}}},
    {"formats/cavity_foam/case.foam", "unstructured", 400, 882, 0, {{"p", point, 1, -4.367, 4.849}}},
    {"formats/office_ensight/office_bin.case", "curvilinear", 216, 343, 0, {{"scalars", point, 1, -3.866, 0.613}}},
};

std::string dataFile(const char* path)
{
	const char* folder = std::getenv("VPROBE_DATA");
	return folder ? (std::filesystem::path(folder) / path).string() : std::string();
}

class RealFile : public testing::TestWithParam<ExpectedFile>
{
};

} // namespace

TEST_P(RealFile, GivesCountsAndRanges)
{
	const ExpectedFile& expected = GetParam();
	const std::string path = dataFile(expected.path);
	if (path.empty() || !std::filesystem::exists(path))
		GTEST_SKIP() << "VPROBE_DATA names no folder with " << expected.path;
	Timeline timeline;
	const auto set = read::readInputs({path}, {}, &timeline);
	ASSERT_TRUE(set) << set.error().message;
	EXPECT_STREQ(set->kind(), expected.kind);
	EXPECT_EQ(set->cellCount(), expected.cells);
	EXPECT_EQ(set->pointCount(), expected.points);
	EXPECT_EQ(set->left_out, expected.left_out);
	EXPECT_GT(timeline.total("read"), 0.0);
	EXPECT_GT(timeline.total("build"), 0.0);
	for (const ExpectedArray& array : expected.arrays)
	{
		const auto& fields = set->blocks[0].fields;
		const auto field = std::find_if(fields.begin(), fields.end(),
		                                [&](const grid::Field& each)
		                                { return each.name == array.name && each.association == array.association; });
		ASSERT_NE(field, fields.end()) << array.name;
		EXPECT_EQ(field->components, array.components) << array.name;
		const auto [low, high] = grid::fieldRange(*field, array.components > 1 ? grid::kMagnitude : 0);
		// The figures are given to four digits.
		EXPECT_NEAR(low, array.low, 1e-3 * std::abs(array.low) + 1e-300) << array.name;
		EXPECT_NEAR(high, array.high, 1e-3 * std::abs(array.high)) << array.name;
	}
}

INSTANTIATE_TEST_SUITE_P(Read, RealFile, testing::ValuesIn(kFiles),
                         [](const testing::TestParamInfo<ExpectedFile>& info)
                         {
	                         std::string name = std::filesystem::path(info.param.path).stem().string();
	                         std::replace_if(
	                             name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
	                         return name;
                         });

TEST(RealCurvedCells, AreCountedAsTheFileHasThem)
{
	const std::string path = dataFile("higher-order/notch_disp/notch_disp.vtu");
	if (path.empty() || !std::filesystem::exists(path))
		GTEST_SKIP() << "VPROBE_DATA names no folder with higher-order/notch_disp/notch_disp.vtu";
	const auto set = read::readInputs({path}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	EXPECT_EQ(set->sourceCellCount(), 2192u);
	EXPECT_EQ(set->sourcePointCount(), 12717u);
	EXPECT_EQ(set->cellCount(), 2192u * 8); // hexahedra and wedges make eight each
	EXPECT_NO_THROW(grid::validate(set->blocks[0]));
	EXPECT_TRUE(set->blocks[0].inverted.empty());
}

TEST(RealTimes, AreOfferedAndChosen)
{
	const std::string path = dataFile("time/mug/mug.e");
	if (path.empty() || !std::filesystem::exists(path))
		GTEST_SKIP() << "VPROBE_DATA names no folder with time/mug/mug.e";
	const auto convectedAt = [&](const std::string& time)
	{
		read::ReadOptions options;
		options.time = *read::parseTime(time);
		const auto set = read::readInputs({path}, options, nullptr);
		EXPECT_TRUE(set);
		EXPECT_EQ(set->times.size(), 21u);
		double sum = 0.0;
		for (const grid::Field& field : set->blocks[0].fields)
			if (field.name == "convected")
				for (std::size_t i = 0; i < field.tuples(); ++i)
					sum += field.value(i, 0);
		return std::pair(set->times, sum);
	};
	const auto [times, last] = convectedAt("last");
	EXPECT_EQ(convectedAt("1e30").second, last);
	EXPECT_EQ(convectedAt(std::to_string(times[0] - 1.0)).second, convectedAt("first").second);
	EXPECT_NE(convectedAt("first").second, last);
	EXPECT_NE(convectedAt(std::to_string(times[10])).second, last);
}
