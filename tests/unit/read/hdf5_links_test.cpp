// Data sets of an HDF5 file that lie elsewhere.
#include "base/messages.h"
#include "read/read.h"
#include "sample_files.h"
#include "sample_hdf5.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>
#include <numeric>

#include <sys/stat.h>

using namespace vp;
using namespace vp::read;

namespace
{

// An image of 2 x 2 x 2 points with the array "sound", and what `add` puts into the group of arrays beside it.
void writeImage(const std::string& path, const std::function<void(hid_t arrays)>& add)
{
	{
		SampleHdf5 file(path);
		std::vector<double> values(8);
		std::iota(values.begin(), values.end(), 0.0);
		file.set("/VTKHDF/PointData/sound", {2, 2, 2}, H5T_NATIVE_DOUBLE, values.data());
		file.attribute("/VTKHDF", "Version", std::vector<double>{2.0, 0.0});
		file.attribute("/VTKHDF", "Type", "ImageData");
		file.attribute("/VTKHDF", "WholeExtent", std::vector<double>{0, 1, 0, 1, 0, 1});
		file.attribute("/VTKHDF", "Origin", std::vector<double>{0, 0, 0});
		file.attribute("/VTKHDF", "Spacing", std::vector<double>{1, 1, 1});
		file.attribute("/VTKHDF", "Direction", std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
	}
	const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
	const hid_t arrays = H5Gopen2(file, "/VTKHDF/PointData", H5P_DEFAULT);
	add(arrays);
	H5Gclose(arrays);
	H5Fclose(file);
}

// A virtual data set of 2 x 2 x 2 values that another one has.
void addVirtual(hid_t arrays, const char* name, const std::string& file, const std::string& source)
{
	constexpr std::array<hsize_t, 3> sides = {2, 2, 2};
	const hid_t space = H5Screate_simple(3, sides.data(), nullptr);
	const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
	H5Pset_virtual(layout, space, file.c_str(), ("/VTKHDF/PointData/" + source).c_str(), space);
	H5Dclose(H5Dcreate2(arrays, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, layout, H5P_DEFAULT));
	H5Pclose(layout);
	H5Sclose(space);
}

// One value of each of the numbered sets "NAME0", "NAME1" … of a file.
void addNumbered(hid_t arrays, const std::string& file, const std::string& source)
{
	constexpr std::array<hsize_t, 3> sides = {2, 2, 2}, most = {H5S_UNLIMITED, 2, 2}, begin = {0, 0, 0},
	                                 step = {1, 1, 1}, some = {H5S_UNLIMITED, 1, 1}, block = {1, 2, 2};
	const hid_t space = H5Screate_simple(3, sides.data(), most.data());
	const hid_t one = H5Screate_simple(3, block.data(), nullptr);
	H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), step.data(), some.data(), block.data());
	const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
	EXPECT_GE(H5Pset_virtual(layout, space, file.c_str(), ("/VTKHDF/PointData/" + source).c_str(), one), 0);
	H5Dclose(H5Dcreate2(arrays, "numbered0", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, layout, H5P_DEFAULT));
	H5Pclose(layout);
	H5Sclose(one);
	H5Sclose(space);
}

std::string errorOf(const std::string& file)
{
	const auto set = readInputs({file}, {}, nullptr);
	EXPECT_FALSE(set);
	return set ? "" : set.error().message;
}

} // namespace

// HDF5 would follow them until its stack is full.
TEST(VirtualSets, ThatAreMadeOfThemselvesAreRefused)
{
	const TemporaryFolder folder;
	const auto file = [&](const std::string& name, const std::function<void(hid_t)>& add)
	{
		writeImage(folder / name, add);
		return folder / name;
	};
	for (const std::string source : {".", "self.vtkhdf"})
	{
		const std::string self = file("self.vtkhdf", [&](hid_t arrays) { addVirtual(arrays, "a", source, "a"); });
		EXPECT_EQ(errorOf(self), self + ": truncated or damaged: its virtual data set /VTKHDF/PointData/a is made of "
		                                "itself");
	}
	const std::string one = file("one.vtkhdf", [&](hid_t arrays) { addVirtual(arrays, "a", "two.vtkhdf", "b"); });
	file("two.vtkhdf", [&](hid_t arrays) { addVirtual(arrays, "b", "one.vtkhdf", "a"); });
	EXPECT_NE(errorOf(one).find("is made of itself"), std::string::npos);
	const std::string numbered = file("numbered.vtkhdf", [&](hid_t arrays) { addNumbered(arrays, ".", "numbered%b"); });
	EXPECT_NE(errorOf(numbered).find("truncated or damaged: the array numbered0"), std::string::npos);
	const std::string chain = file("chain.vtkhdf",
	                               [&](hid_t arrays)
	                               {
		                               for (int i = 0; i < 40; ++i)
			                               addVirtual(arrays, ("v" + std::to_string(i)).c_str(), ".",
			                                          i < 39 ? "v" + std::to_string(i + 1) : "sound");
	                               });
	EXPECT_NE(errorOf(chain).find("leads on over more than 16 others"), std::string::npos) << errorOf(chain);
}

TEST(VirtualSets, OfOtherSetsAreRead)
{
	const TemporaryFolder folder;
	writeImage(folder / "a.vtkhdf",
	           [](hid_t arrays)
	           {
		           addVirtual(arrays, "b", ".", "sound");
		           addVirtual(arrays, "c", ".", "b");
		           addVirtual(arrays, "d", ".", "b");
	           });
	const auto set = readInputs({folder / "a.vtkhdf"}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	ASSERT_EQ(set->blocks.at(0).fields.size(), 4u);
	for (const grid::Field& field : set->blocks[0].fields)
		EXPECT_EQ(grid::fieldRange(field, 0).second, 7.0) << field.name;
}

// The sound array is there, and a line tells of the other one. A pipe or a device is no file.
TEST(Links, ThatLeadNowhereAreWarnings)
{
	const TemporaryFolder folder;
	ASSERT_EQ(mkfifo((folder / "pipe.h5").c_str(), 0600), 0);
	std::filesystem::create_symlink("/dev/zero", folder / "zero.h5");
	for (const std::string target : {"", "nowhere.h5", "pipe.h5", "zero.h5", "/dev/zero"})
	{
		const std::string file = folder / "linked.vtkhdf";
		writeImage(file,
		           [&](hid_t arrays)
		           {
			           target.empty()
			               ? H5Lcreate_soft("/nowhere", arrays, "gone", H5P_DEFAULT, H5P_DEFAULT)
			               : H5Lcreate_external(target.c_str(), "/a", arrays, "gone", H5P_DEFAULT, H5P_DEFAULT);
		           });
		std::string said;
		const MessageListener listener([&](Severity severity, std::string_view line)
		                               { said += severity == Severity::warning ? line : std::string_view(); });
		const auto set = readInputs({file}, {}, nullptr);
		ASSERT_TRUE(set) << target << ": " << set.error().message;
		EXPECT_EQ(set->blocks.at(0).fields.size(), 1u);
		EXPECT_EQ(said, file + ": the array gone is a link that leads nowhere, and is left out; keep the files that it "
		                       "names together");
	}
}
