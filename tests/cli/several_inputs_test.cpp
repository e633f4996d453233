// Several inputs: blocks of one data set, or times of a series.
#include "program.h"

#include <string>

namespace cli
{

namespace
{

class SeveralInputs : public Program
{
protected:
	// An image of 3 x 3 x 3 points at 0..2, from x0 on, whose array is one value everywhere.
	std::string image(const std::string& name, double value, int x0 = 0) const
	{
		std::string text =
		    "# vtk DataFile Version 3.0\nimage\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 3\nORIGIN " +
		    std::to_string(x0) + " 0 0\nSPACING 1 1 1\nPOINT_DATA 27\nSCALARS f double 1\nLOOKUP_TABLE default\n";
		for (int p = 0; p < 27; ++p)
			text += std::to_string(value) + "\n";
		return write(name, text);
	}
	Outcome slice(const Arguments& arguments) const
	{
		return run(Arguments{"slice"} + arguments + Arguments{"--classify", "cpu", "--stats", "-"}, noDevice());
	}
	static double figure(const Outcome& outcome, const char* key)
	{
		return outcome.json().at("sheets").at(0).at(key).get<double>();
	}
};

} // namespace

TEST_F(SeveralInputs, NumberedFilesOfOneGridAreTimes)
{
	const Arguments files{image("a_2.vtk", 20.0), image("a_10.vtk", 100.0), image("a_3.vtk", 30.0)};
	const Outcome last = slice(files);
	ASSERT_EQ(last.status, 0) << last.err;
	EXPECT_EQ(figure(last, "mean"), 100.0);
	EXPECT_EQ(figure(last, "area"), 4.0);
	EXPECT_TRUE(contains(last.err, "times of one series")) << last.err;
	EXPECT_EQ(figure(slice(files + Arguments{"--time", "first"}), "mean"), 20.0);
	EXPECT_EQ(figure(slice(files + Arguments{"--time", "3"}), "mean"), 30.0);
	EXPECT_EQ(figure(slice(files + Arguments{"--time", "#2"}), "mean"), 100.0);
	const Outcome late = slice(files + Arguments{"--time", "#3"});
	EXPECT_EQ(late.status, 2);
	EXPECT_TRUE(contains(late.err, "--time #3") && contains(late.err, "#0 to #2")) << late.err;
	const Outcome told = run(Arguments{"info", "--json"} + files);
	EXPECT_EQ(told.json().at("times"), (nlohmann::json{2.0, 3.0, 10.0}));
	// A sweep over the times shows each.
	ASSERT_EQ(run(Arguments{"sweep"} + files +
	                  Arguments{"--path", "times", "--classify", "cpu", "-o", path("s.pvd"), "--stats", path("s.json")},
	              noDevice())
	              .status,
	          0);
	EXPECT_TRUE(contains(contents(path("s.pvd")), "timestep=\"10\"")); // the files' own times
	const nlohmann::json frames = nlohmann::json::parse(contents(path("s.json"))).at("frames");
	ASSERT_EQ(frames.size(), 3u);
	EXPECT_EQ(frames.at(0).at("sheets").at(0).at("mean"), 20.0);
	EXPECT_EQ(frames.at(1).at("sheets").at(0).at("mean"), 30.0);
}

TEST_F(SeveralInputs, TheSettingDecides)
{
	const Arguments files{image("a_2.vtk", 20.0), image("a_4.vtk", 40.0)};
	const Outcome blocks = slice(files + Arguments{"--inputs", "blocks"});
	EXPECT_EQ(figure(blocks, "area"), 8.0);
	EXPECT_EQ(figure(blocks, "mean"), 30.0);
	// Both count, and a line says so.
	EXPECT_EQ(figure(blocks, "overlap_area"), 4.0);
	EXPECT_TRUE(contains(blocks.err, "a_2.vtk and ") && contains(blocks.err, "a_4.vtk overlap")) << blocks.err;
	// Whatever they are called, and even if the grid moves.
	const Arguments others{image("first.vtk", 1.0), image("second.vtk", 2.0, 5)};
	EXPECT_EQ(figure(slice(others + Arguments{"--inputs", "times"}), "mean"), 2.0);
	EXPECT_EQ(figure(slice(others + Arguments{"--inputs", "times", "--time", "0"}), "mean"), 1.0);
	EXPECT_EQ(figure(slice(others), "area"), 8.0);
	EXPECT_TRUE(isError(slice(others + Arguments{"demo:hexes:4", "--inputs", "times"}), 1, {"demo:hexes:4"}));
}

TEST_F(SeveralInputs, PiecesStayBlocks)
{
	const Outcome pieces = slice({image("p_0.vtk", 1.0), image("p_1.vtk", 2.0, 2)});
	EXPECT_EQ(figure(pieces, "area"), 8.0);
	EXPECT_TRUE(pieces.err.empty()) << pieces.err;
}

} // namespace cli
