// No output takes the place of a file that is read, and what cannot be converted leaves nothing.
#include "program.h"

#include <filesystem>

using namespace cli;

namespace
{

constexpr const char* kImage = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 9 9 9\n"
                               "ORIGIN 0 0 0\nSPACING 1 1 1\n";

class InputKept : public Program
{
protected:
	InputKept() { write("a.vtk", kImage); }
	void expectRefused(const Arguments& arguments, const std::string& named) const
	{
		const std::vector<std::string> before = files();
		EXPECT_TRUE(isError(run(arguments), 4, {named + ": is one of the input files"}));
		EXPECT_EQ(files(), before) << named;
		EXPECT_EQ(contents(path("a.vtk")), kImage);
	}
	std::string image() const { return path("a.vtk"); }
};

} // namespace

TEST_F(InputKept, WhateverWouldReplaceIt)
{
	std::filesystem::create_symlink("a.vtk", path("link.vtu"));
	std::filesystem::create_hard_link(image(), path("hard.csv"));
	expectRefused({"convert", image(), "-o", path("link.vtu")}, path("link.vtu"));
	expectRefused({"slice", image(), "-o", path("hard.csv")}, path("hard.csv"));
	for (const char* option : {"--stats", "--save"})
		expectRefused({"slice", image(), "-o", path("x.vtp"), option, image()}, image());
	expectRefused({"profile", image(), "--planes", "2", "--json", image()}, image());
	expectRefused({"sample", image(), "--line", "0", "0", "0", "1", "1", "1", "3", "-o", path("hard.csv")},
	              path("hard.csv"));
	const std::string points = write("points.csv", "1 1 1\n");
	expectRefused({"sample", image(), "--points", points, "-o", points}, points);
	const std::string state = path("state.json");
	ASSERT_TRUE(isQuiet(run({"slice", image(), "--stats", path("s.json"), "--save", state})));
	expectRefused({"slice", "--state", state, "--save", state}, state);
	expectRefused({"slice", "--state", state, "-o", path("x.vtp"), "--stats", state}, state);
}

// The files that an input names are inputs too.
TEST_F(InputKept, AsAPieceOfAnIndex)
{
	ASSERT_TRUE(isQuiet(run({"convert", image(), "-o", path("set.vtm")})));
	const std::string piece = path("set/set_0.vti");
	const std::string before = contents(piece);
	ASSERT_GT(before.size(), 100u);
	EXPECT_TRUE(isError(run({"slice", path("set.vtm"), "-o", path("x.vtp"), "--stats", piece}), 4, {piece}));
	EXPECT_FALSE(std::filesystem::exists(path("x.vtp")));
	EXPECT_TRUE(isError(run({"convert", path("set.vtm"), "-o", piece}), 4, {piece}));
	EXPECT_EQ(contents(piece), before);

	// A folder as a piece, and a link that another one made in the place of the pieces.
	std::filesystem::remove(piece);
	std::filesystem::create_directory(piece);
	EXPECT_TRUE(isError(run({"info", path("set.vtm")}), 2, {piece, "cannot be opened"}));
	std::filesystem::create_symlink("elsewhere", path("new"));
	EXPECT_TRUE(isError(run({"convert", image(), "-o", path("new.vtm")}), 4, {"is there already"}));
	EXPECT_TRUE(std::filesystem::is_symlink(path("new")));
}

TEST_F(InputKept, AFullDiskIsNotDamage)
{
	const std::vector<std::string> before = files();
	// The reader hands over less than it writes: its head alone takes more than this.
	for (const char* output : {"full.vti", "full.vtm", "full.vtkhdf"})
	{
		EXPECT_TRUE(isError(run({"convert", image(), "-o", path(output)}, {.file_size_limit = 256}), 4,
		                    {path(output), "make room"}));
		EXPECT_EQ(files(), before) << output;
	}
	// Files in memory that may not grow: out of memory, and no damage either.
	const std::string values = std::string(kImage) + "POINT_DATA 729\nSCALARS u float\nLOOKUP_TABLE default\n" +
	                           []
	{
		std::string all;
		for (int i = 0; i < 729; ++i)
			all += "1\n";
		return all;
	}();
	EXPECT_TRUE(isError(run({"info", write("b.vtk", values)}, {.file_size_limit = 1024}), 4,
	                    {path("b.vtk"), "not enough memory", "make room"}));
}
