// CGNS files whose ZoneIterativeData name solutions that are not there, as some exporters write them.
#include "base/messages.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>
#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <array>
#include <string>
#include <vector>

using namespace vp;

namespace
{

constexpr std::array<cgsize_t, 3> kZonePoints = {4, 3, 5};
constexpr double kZoneTimes[] = {0.25, 0.5, 1.5};

void check(int status)
{
	ASSERT_EQ(status, CG_OK) << cg_get_error();
}

void writeField(int file, const char* solution, double value)
{
	const std::vector<double> pressure(4 * 3 * 5, value);
	int s = 0, f = 0;
	check(cg_sol_write(file, 1, 1, solution, CGNS_ENUMV(Vertex), &s));
	check(cg_field_write(file, 1, 1, s, CGNS_ENUMV(RealDouble), "Pressure", pressure.data(), &f));
}

// A structured zone, with solutions of three times under the names given. The pointers name others.
void writeUnsteadyZone(const std::string& path, const std::array<const char*, 3>& solutions,
                       const std::array<const char*, 3>& pointers)
{
	int file = 0, base = 0, zone = 0, c = 0;
	check(cg_set_file_type(CG_FILE_HDF5));
	check(cg_open(path.c_str(), CG_MODE_WRITE, &file));
	check(cg_base_write(file, "Base", 3, 3, &base));
	const std::array<cgsize_t, 9> size = {4, 3, 5, 3, 2, 4, 0, 0, 0};
	check(cg_zone_write(file, base, "Zone", size.data(), CGNS_ENUMV(Structured), &zone));
	const std::array<const char*, 3> names = {"CoordinateX", "CoordinateY", "CoordinateZ"};
	for (int axis = 0; axis < 3; ++axis)
	{
		std::vector<double> places;
		for (int k = 0; k < kZonePoints[2]; ++k)
			for (int j = 0; j < kZonePoints[1]; ++j)
				for (int i = 0; i < kZonePoints[0]; ++i)
					places.push_back(axis == 0 ? i : axis == 1 ? j : k);
		check(cg_coord_write(file, base, zone, CGNS_ENUMV(RealDouble), names[axis], places.data(), &c));
	}
	for (int t = 0; t < 3; ++t)
		writeField(file, solutions[t], 100.0 * (t + 1));

	const cgsize_t steps = 3;
	check(cg_biter_write(file, base, "TimeIterValues", 3));
	check(cg_goto(file, base, "BaseIterativeData_t", 1, "end"));
	check(cg_array_write("TimeValues", CGNS_ENUMV(RealDouble), 1, &steps, kZoneTimes));
	check(cg_ziter_write(file, base, zone, "ZoneIterativeData"));
	check(cg_goto(file, base, "Zone_t", zone, "ZoneIterativeData_t", 1, "end"));
	std::string text;
	for (std::string name : pointers)
	{
		name.resize(32, ' ');
		text += name;
	}
	const std::array<cgsize_t, 2> shape = {32, 3};
	check(cg_array_write("FlowSolutionPointers", CGNS_ENUMV(Character), 2, shape.data(), text.data()));
	check(cg_close(file));
}

double pressureAt(const std::string& path, const std::string& time, std::vector<std::string>& messages)
{
	const MessageListener listener([&](Severity, std::string_view line) { messages.emplace_back(line); });
	read::ReadOptions options;
	options.time = *read::parseTime(time);
	const auto set = read::readInputs({path}, options, nullptr);
	EXPECT_TRUE(set) << set.error().message;
	if (!set)
		return 0.0;
	EXPECT_EQ(set->times, std::vector<double>(std::begin(kZoneTimes), std::end(kZoneTimes)));
	EXPECT_EQ(set->pointCount(), 60u);
	EXPECT_EQ(set->cellCount(), 24u);
	EXPECT_EQ(set->blocks[0].fields.size(), 1u);
	return set->blocks[0].fields[0].value(59, 0);
}

} // namespace

TEST(Cgns, SolutionsThatPointersNameAreReadWithoutANote)
{
	const TemporaryFolder folder;
	const std::string path = folder / "good.cgns";
	writeUnsteadyZone(path, {"FlowA", "FlowB", "FlowC"}, {"FlowA", "FlowB", "FlowC"});
	std::vector<std::string> messages;
	EXPECT_EQ(pressureAt(path, "#1", messages), 200.0);
	EXPECT_EQ(pressureAt(path, "last", messages), 300.0);
	EXPECT_TRUE(messages.empty()) << messages[0];
}

TEST(Cgns, InvalidPointersAreANote)
{
	const TemporaryFolder folder;
	const std::string path = folder / "bad.cgns";
	writeUnsteadyZone(path, {"Flow0001", "Flow0002", "Flow0003"}, {"Sol_1", "Sol_2", "Sol_3"});
	std::vector<std::string> messages;
	EXPECT_EQ(pressureAt(path, "first", messages), 100.0);
	ASSERT_EQ(messages.size(), 2u);
	EXPECT_NE(messages[0].find("by the number at the end of their names"), std::string::npos) << messages[0];
	EXPECT_NE(messages[1].find("refer to invalid solution nodes"), std::string::npos) << messages[1];
	EXPECT_EQ(pressureAt(path, "#1", messages), 200.0);
	EXPECT_EQ(pressureAt(path, "last", messages), 300.0);
}

TEST(Cgns, InvalidPointersToSolutionsWithoutNumbersGiveTheFirst)
{
	const TemporaryFolder folder;
	const std::string path = folder / "bad.cgns";
	writeUnsteadyZone(path, {"FlowA", "FlowB", "FlowC"}, {"Sol_1", "Sol_2", "Sol_3"});
	std::vector<std::string> messages;
	EXPECT_EQ(pressureAt(path, "last", messages), 100.0);
	ASSERT_EQ(messages.size(), 2u);
	EXPECT_NE(messages[0].find("the first one is shown"), std::string::npos) << messages[0];
}
