#include "own_samples.h"
#include "sample_bytes.h"
#include "sample_hdf5.h"

#include <fmt/format.h>

namespace
{

using vp::Vec3;

// The box's cells in two halves along x, as blocks: cells of a half, its points in all.
constexpr std::array<int, 3> kHalf = {2, 3, 5};
constexpr std::size_t kHalfCells = 2 * 3 * 5;
constexpr std::size_t kHalvesPoints = 2 * 3 * 4 * 6;

std::vector<double> valuesOfHalf(int half)
{
	std::vector<double> values;
	for (int k = 0; k < kHalf[2]; ++k)
		for (int j = 0; j < kHalf[1]; ++j)
			for (int i = 0; i < kHalf[0]; ++i)
				values.push_back(sampleValue(Vec3(i + 2 * half, j, k) + 0.5));
	return values;
}

// Two leaves and the block that they were made of, which has values too. A name ends with blanks.
void writeFlash(const std::string& path)
{
	SampleHdf5 file(path);
	file.texts("/unknown names", {1, 1}, 4, {"g"});
	const std::vector<int> tree(3 * 15, -1), kinds = {2, 1, 1}, levels = {1, 2, 2};
	file.set("/gid", {3, 15}, H5T_NATIVE_INT, tree.data());
	file.set("/node type", {3}, H5T_NATIVE_INT, kinds.data());
	file.set("/refine level", {3}, H5T_NATIVE_INT, levels.data());
	const std::vector<double> bounds = {0, 4, 0, 3, 0, 5, 0, 2, 0, 3, 0, 5, 2, 4, 0, 3, 0, 5};
	file.set("/bounding box", {3, 3, 2}, H5T_NATIVE_DOUBLE, bounds.data());
	std::vector<double> values(kHalfCells, -1.0);
	for (const int half : {0, 1})
	{
		const std::vector<double> more = valuesOfHalf(half);
		values.insert(values.end(), more.begin(), more.end());
	}
	file.set("/g   ", {3, 5, 3, 2}, H5T_NATIVE_DOUBLE, values.data());
	struct Scalar
	{
		char name[20];
		double value;
	};
	const std::array<Scalar, 2> scalars = {Scalar{"dt                 ", 0.125}, Scalar{"time               ", 1.5}};
	const hid_t text = H5Tcopy(H5T_C_S1);
	H5Tset_size(text, 20);
	const hid_t row = H5Tcreate(H5T_COMPOUND, sizeof(Scalar));
	H5Tinsert(row, "name", HOFFSET(Scalar, name), text);
	H5Tinsert(row, "value", HOFFSET(Scalar, value), H5T_NATIVE_DOUBLE);
	file.set("/real scalars", {2}, row, scalars.data());
	H5Tclose(row);
	H5Tclose(text);
}

// Leaves at level 1; a variable has a fifth side for its components.
void writeVelodyne(const std::string& path)
{
	SampleHdf5 file(path);
	const std::vector<int> levels = {1, 1};
	const std::vector<double> corners = {0, 0, 0, 2, 0, 0};
	std::vector<double> values = valuesOfHalf(0);
	const std::vector<double> more = valuesOfHalf(1);
	values.insert(values.end(), more.begin(), more.end());
	file.set("/AMR/Leaves/Level", {2}, H5T_NATIVE_INT, levels.data());
	file.set("/AMR/Leaves/X0", {2, 3}, H5T_NATIVE_DOUBLE, corners.data());
	file.set("/AMR/Leaves/g", {2, 5, 3, 2, 1}, H5T_NATIVE_DOUBLE, values.data());
	file.attribute("/AMR", "BlockDims", std::vector<double>{2, 3, 5});
	file.attribute("/AMR", "RootDX", std::vector<double>{1, 1, 1});
	file.attribute("/AMR", "SimTime", std::vector<double>{0.25});
}

// Two grids of one level in a packed file. Factors of the parameters give the values.
void writeEnzo(const std::string& path)
{
	const std::filesystem::path beside = std::filesystem::path(path).replace_extension("");
	SampleHdf5 file(beside.string() + ".cpu0000");
	std::string text;
	for (const int half : {0, 1})
	{
		std::vector<double> values = valuesOfHalf(half);
		for (double& value : values)
			value /= 4.0;
		file.set(fmt::format("/Grid{:08}/g", half + 1), {5, 3, 2}, H5T_NATIVE_DOUBLE, values.data());
		text += fmt::format(
		    "\nGrid = {0}\nTask              = 0\nGridRank          = 3\nGridDimension     = 8 9 11\n"
		    "GridStartIndex    = 3 3 3\nGridEndIndex      = 4 5 7\nGridLeftEdge      = {1} 0 0\n"
		    "GridRightEdge     = {2} 3 5\nTime              = 2.5\nSubgridsAreStatic = 0\nNumberOfBaryonFields = 1\n"
		    "FieldType = 0\nBaryonFileName = /run/DD0001/{3}.cpu0000\nNumberOfParticles   = 0\n"
		    "Pointer: Grid[{0}]->NextGridThisLevel = {4}\nPointer: Grid[{0}]->NextGridNextLevel = 0\n",
		    half + 1, 2 * half, 2 * half + 2, beside.filename().string(), half == 0 ? 2 : 0);
	}
	writeContents(path, text);
	writeContents(beside.string(),
	              "InitialTime = 2.5\nDataLabel[0]              = g\nDataUnits[0]              = none\n"
	              "#DataCGSConversionFactor[0] = 4\n");
}

// A folder: two boxes of one level in a file, big-endian floats and little-endian doubles.
void writeAmrex(const std::string& path)
{
	std::filesystem::create_directories(path + "/Level_0");
	writeContents(path + "/Header", "HyperCLaw-V1.1\n1\ng\n3\n0.5\n0\n0 0 0\n4 3 5\n\n((0,0,0) (3,2,4) (0,0,0))\n7\n"
	                                "1 1 1\n0\n0\n0 2 0.5\n7\n0 2\n0 3\n0 5\n2 4\n0 3\n0 5\nLevel_0/Cell\n");
	std::string values;
	std::array<std::size_t, 2> offsets = {};
	for (const int half : {0, 1})
	{
		offsets[static_cast<std::size_t>(half)] = values.size();
		values += fmt::format("FAB ((8, ({})),({}))(({},0,0) ({},2,4) (0,0,0)) 1\n",
		                      half == 0 ? "32 8 23 0 1 9 0 127" : "64 11 52 0 1 12 0 1023",
		                      half == 0 ? "4, (1 2 3 4)" : "8, (8 7 6 5 4 3 2 1)", 2 * half, 2 * half + 1);
		for (const double value : valuesOfHalf(half))
			half == 0 ? addBigEndian(values, static_cast<float>(value)) : addBytes(values, value);
	}
	writeContents(path + "/Level_0/Cell_D_00000", values);
	writeContents(path + "/Level_0/Cell_H",
	              fmt::format("1\n1\n1\n0\n(2 0\n((0,0,0) (1,2,4) (0,0,0))\n((2,0,0) (3,2,4) (0,0,0))\n)\n2\n"
	                          "FabOnDisk: Cell_D_00000 {}\nFabOnDisk: Cell_D_00000 {}\n",
	                          offsets[0], offsets[1]));
}

} // namespace

std::vector<SampleFile> boxSamples()
{
	return {
	    {"flash_hdf5_plt_cnt_0001", writeFlash, "block-structured", kSampleCellCount, kHalvesPoints, true, "", false},
	    {"leaves.xamr", writeVelodyne, "block-structured", kSampleCellCount, kHalvesPoints, true, "", false},
	    {"DD0001.hierarchy", writeEnzo, "block-structured", kSampleCellCount, kHalvesPoints, true, "DD0001.cpu0000",
	     false},
	    {"plt00001", writeAmrex, "block-structured", kSampleCellCount, kHalvesPoints, true,
	     "plt00001/Level_0/Cell_D_00000", false},
	};
}
