// A pack, of which the window reads what the sheet meets.

#include "desktop.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace view
{

namespace
{

class Packs : public Desktop
{
protected:
	// Shows an input and carries out some commands. Returns the middle of the sheet after each.
	std::vector<vp::render::Picture> seen(const std::string& input, const std::vector<std::string>& commands)
	{
		const Area middle{240, 280, 80, 60};
		open({input, "--normal", "0.3", "0.5", "0.8"});
		std::vector<vp::render::Picture> pictures;
		for (const std::string& line : commands)
		{
			command(line);
			settle();
			pictures.push_back(rest(middle));
		}
		close();
		std::filesystem::remove(path("commands"));
		return pictures;
	}

	// Three times of a cube, whose values rise along z, y and x.
	std::string series() const
	{
		std::string list = "<VTKFile type=\"Collection\"><Collection>";
		for (int time = 0; time < 3; ++time)
		{
			std::string points, values;
			for (int point = 0; point < 8; ++point)
			{
				const std::array<int, 3> at = {point & 1, point >> 1 & 1, point >> 2};
				points += fmt::format("{}\n", fmt::join(at, " "));
				values += fmt::format("{}\n", at[static_cast<std::size_t>(2 - time)]);
			}
			std::ofstream(path(fmt::format("{}.vtk", time)))
			    << "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
			    << points << "CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n12\nPOINT_DATA 8\n"
			    << "SCALARS f double\nLOOKUP_TABLE default\n"
			    << values;
			list += fmt::format("<DataSet timestep=\"{0}\" file=\"{0}.vtk\"/>", time);
		}
		std::ofstream(path("cube.pvd")) << list << "</Collection></VTKFile>";
		return path("cube.pvd");
	}
};

void expectAlike(const std::vector<vp::render::Picture>& a, const std::vector<vp::render::Picture>& b)
{
	ASSERT_EQ(a.size(), b.size());
	for (std::size_t picture = 0; picture < a.size(); ++picture)
		EXPECT_EQ(difference(a[picture], b[picture]), 0.0) << picture;
}

} // namespace

TEST_F(Packs, LookLikeTheirInputs)
{
	const std::string pack = path("pack.vtkhdf");
	ASSERT_EQ(run({"pack", "demo:tets:8", "-o", pack, "--part", "64"}).status, 0);
	const std::vector<std::string> commands = {"do push_forward", "do push_back", "set crinkle true", "do push_back",
	                                           "set crinkle false"};
	const std::vector<vp::render::Picture> wanted = seen("demo:tets:8", commands);
	EXPECT_GT(difference(wanted[1], wanted[2]), 0.0);
	expectAlike(wanted, seen(pack, commands));
}

TEST_F(Packs, GoThroughTheTimesOfTheirInputs)
{
	const std::string input = series(), pack = path("cube.vtkhdf");
	ASSERT_EQ(run({"pack", input, "-o", pack}).status, 0);
	const std::vector<std::string> commands = {"set time #0", "set time #1",      "do push_forward",
	                                           "set time #2", "set crinkle true", "set time #0"};
	const std::vector<vp::render::Picture> wanted = seen(input, commands);
	EXPECT_GT(difference(wanted[0], wanted[1]), 0.0);
	EXPECT_GT(difference(wanted[2], wanted[3]), 0.0);
	expectAlike(wanted, seen(pack, commands));
}

} // namespace view
