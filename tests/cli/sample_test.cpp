#include "program.h"
#include "sample_files.h"

#include <cmath>
#include <random>
#include <sstream>

namespace cli
{

namespace
{

using CsvRow = std::vector<std::string>;

std::vector<CsvRow> csvRows(const std::string& csv)
{
	std::vector<CsvRow> rows;
	std::istringstream lines(csv);
	for (std::string line; std::getline(lines, line);)
	{
		rows.emplace_back(1);
		for (const char c : line)
			if (c == ',')
				rows.back().emplace_back();
			else
				rows.back().back() += c;
	}
	return rows;
}

// Points of a box as lines of text.
std::string pointsWithin(double lo, double hi, int count)
{
	std::mt19937 random(5);
	std::uniform_real_distribution<double> any(lo, hi);
	std::ostringstream text;
	for (int i = 0; i < count; ++i)
	{
		text << any(random) << ' ';
		text << any(random) << ' ';
		text << any(random) << '\n';
	}
	return text.str();
}

class Sample : public Program
{
protected:
	// Samples points. The run must succeed, and all points must be inside.
	std::vector<CsvRow> sample(const Arguments& arguments) const
	{
		const Outcome outcome = run(Arguments{"sample"} + arguments, noDevice());
		EXPECT_TRUE(isQuiet(outcome));
		return csvRows(outcome.out);
	}
	// Returns the largest error of s, whose formula is known.
	double largestError(const std::string& input) const
	{
		double largest = 0.0;
		const std::vector<CsvRow> rows = sample({input, "--line", "-0.7", "1.1", "-0.9", "1.4", "1.3", "1.2", "300"});
		EXPECT_EQ(rows.size(), 301u);
		for (std::size_t i = 1; i < rows.size(); ++i)
		{
			const double x = std::stod(rows[i][0]), y = std::stod(rows[i][1]), z = std::stod(rows[i][2]);
			const double s = std::sin(3.0 * x) * std::cos(2.0 * y) + 0.5 * z;
			largest = std::max(largest, std::abs(std::stod(rows[i][5]) - s));
		}
		return largest;
	}
};

} // namespace

TEST_F(Sample, AnArrayOfKnownFormulaConverges)
{
	for (const std::string name : {"shell", "hexes", "tets", "mixed"})
	{
		const double coarse = largestError("demo:" + name + ":32");
		const double fine = largestError("demo:" + name + ":64");
		EXPECT_LT(fine, 0.35 * coarse) << name; // a quarter, at second order
		EXPECT_LT(fine, 0.1) << name;
		EXPECT_GT(coarse, 1e-4) << name;
	}
}

// v = (-y, x, 0.3)
TEST_F(Sample, ALinearArrayIsExact)
{
	const std::string points = write("points.txt", pointsWithin(-2.9, 2.9, 400));
	for (const char* input : {"demo:mixed:7", "demo:blob:5", "demo:graded:6"})
	{
		const std::vector<CsvRow> rows = sample({input, "--points", points, "--array", "v"});
		ASSERT_EQ(rows.size(), 401u) << input;
		EXPECT_EQ(rows[0], (CsvRow{"x", "y", "z", "block", "cell", "v_x", "v_y", "v_z"}));
		for (std::size_t i = 1; i < rows.size(); ++i)
		{
			EXPECT_NEAR(std::stod(rows[i][5]), -std::stod(rows[i][1]), 1e-6) << input;
			EXPECT_NEAR(std::stod(rows[i][6]), std::stod(rows[i][0]), 1e-6) << input;
			EXPECT_NEAR(std::stod(rows[i][7]), 0.3, 1e-6) << input;
		}
	}
	const std::vector<CsvRow> rows =
	    sample({"demo:tets:9", "--line", "-1", "1", "-0.5", "1", "1.5", "0.7", "100", "--array", "v"});
	for (std::size_t i = 1; i < rows.size(); ++i)
		EXPECT_NEAR(std::stod(rows[i][6]), std::stod(rows[i][0]), 1e-6);
}

TEST_F(Sample, ALineHasBothItsEnds)
{
	const std::vector<CsvRow> rows = sample({"demo:blob:4", "--line", "-3", "-2.9", "0.1", "3", "0.7", "1.3", "5"});
	ASSERT_EQ(rows.size(), 6u);
	EXPECT_EQ(CsvRow(rows[1].begin(), rows[1].begin() + 5), (CsvRow{"-3", "-2.9", "0.1", "0", "32"}));
	EXPECT_EQ(CsvRow(rows[5].begin(), rows[5].begin() + 3), (CsvRow{"3", "0.7", "1.3"}));
	EXPECT_EQ(rows[3][0], "0");
}

// Arrays of points and cells, in the file's numbers.
TEST_F(Sample, EveryArrayHasItsColumns)
{
	const std::string points = write("p.txt", "0.25 0.5 0.75\n1.5,2.5,2.25\n");
	const std::vector<CsvRow> rows = sample({write("image.vtk", legacyImage()), "--points", points});
	ASSERT_EQ(rows.size(), 3u);
	const CsvRow header{"x",    "y",      "z",      "block",  "cell",   "height",
	                    "both", "wind_x", "wind_y", "wind_z", "both_2", "mass"};
	EXPECT_EQ(rows[0], header);
	EXPECT_EQ(rows[1], (CsvRow{"0.25", "0.5", "0.75", "0", "0", "0.75", "0.25", "1", "2", "2", "100", "7"}));
	EXPECT_EQ(rows[2], (CsvRow{"1.5", "2.5", "2.25", "0", "25", "2.25", "1.5", "1", "2", "2", "125", "7"}));
	const std::vector<CsvRow> some =
	    sample({write("image.vtk", legacyImage()), "--points", points, "--array", "cell:both", "--array", "height"});
	ASSERT_EQ(some.size(), 3u);
	EXPECT_EQ(some[0], (CsvRow{"x", "y", "z", "block", "cell", "height", "both"}));
	EXPECT_EQ(some[2], (CsvRow{"1.5", "2.5", "2.25", "0", "25", "2.25", "125"}));
}

TEST_F(Sample, OutsideIsTold)
{
	const std::string points = write("p.txt", "0 0 0\n9 0 0\n1e300 0 0\n");
	const Outcome outcome = run({"sample", "demo:blob:4", "--points", points});
	EXPECT_TRUE(isDoneWithAWord(outcome, {"2 of 3", "outside"}));
	const std::vector<CsvRow> rows = csvRows(outcome.out);
	ASSERT_EQ(rows.size(), 4u);
	EXPECT_EQ(rows[2], (CsvRow{"9", "0", "0", "", "", "nan", "nan", "nan", "nan"}));
	EXPECT_NE(rows[1][4], "");
	// In the hollow of the shell.
	EXPECT_TRUE(isDoneWithAWord(run({"sample", "demo:shell:8", "--line", "0", "0", "0", "0", "0.5", "0", "4"}),
	                            {"4 of 4", "outside"}));
}

TEST_F(Sample, HiddenCellsAreOutside)
{
	const std::string file = write("hidden.vti", imageWithHiddenCells());
	const Outcome outcome = run({"sample", file, "--line", "0.5", "1.5", "1.5", "2.5", "1.5", "1.5", "3"});
	EXPECT_EQ(outcome.status, 0);
	EXPECT_TRUE(contains(outcome.err, "1 of 3 points lie outside")) << outcome.err; // reading tells of hidden cells
	const std::vector<CsvRow> rows = csvRows(outcome.out);
	ASSERT_EQ(rows.size(), 4u);
	EXPECT_EQ(rows[1][4], "12");
	EXPECT_EQ(rows[2][4], "");
	EXPECT_EQ(rows[3][4], "14");
}

TEST_F(Sample, SeveralInputsAreBlocks)
{
	const std::string file = write("image.vtk", legacyImage());
	const std::string points = write("p.txt", "-2 -2 -2\n2.5 2.5 2.5\n");
	const std::vector<CsvRow> rows = sample({file, "demo:blob:4", "--points", points});
	ASSERT_EQ(rows.size(), 3u);
	EXPECT_EQ(rows[1][3], "1");
	EXPECT_EQ(rows[2][3], "0");   // both hold it
	EXPECT_EQ(rows[1][5], "nan"); // height is not in the demo
	EXPECT_EQ(rows[2][5], "2.5");
}

TEST_F(Sample, PointsOfStandardInput)
{
	const std::string points = write("p.txt", "  1e-1\t+.5 , -.25 \r\n\n0,0,0");
	const Outcome outcome = run({"sample", "demo:blob:4", "--points", "-", "-o", "-"}, {.standard_input = points});
	EXPECT_TRUE(isQuiet(outcome));
	const std::vector<CsvRow> rows = csvRows(outcome.out);
	ASSERT_EQ(rows.size(), 3u);
	EXPECT_EQ(CsvRow(rows[1].begin(), rows[1].begin() + 3), (CsvRow{"0.1", "0.5", "-0.25"}));
	EXPECT_TRUE(isDoneWithAWord(run({"sample", "demo:blob:4", "--points", "-"}), {"standard input", "no points"}));
}

TEST_F(Sample, AFileIsAsStandardOutput)
{
	const Arguments line{"sample", "demo:tets:4", "--line", "1.1", "0.9", "0", "0.5", "1.8", "0.4", "7"};
	ASSERT_TRUE(isQuiet(run(line + Arguments{"-o", path("out.csv")})));
	EXPECT_EQ(contents(path("out.csv")), run(line).out);
}

// Its own output, what other programs write, and comments.
TEST_F(Sample, PointsWithAHeader)
{
	const std::string points = write("p.txt", "0.25 0.5 0.75\n1.5,2.5,2.25\n");
	const std::string image = write("image.vtk", legacyImage());
	const std::vector<CsvRow> wanted = sample({image, "--points", points});
	ASSERT_TRUE(isQuiet(run({"sample", image, "--points", points, "-o", path("out.csv")})));
	EXPECT_EQ(sample({image, "--points", path("out.csv")}), wanted);
	for (const std::string text : {
	         "x y z\n0.25 0.5 0.75\n1.5 2.5 2.25\n",
	         "\xEF\xBB\xBFX;Y;Z\r\n0.25;0.5;0.75\r\n1.5;2.5;2.25\r\n",
	         "# of a probe\n0.25 0.5 0.75 # the first\n\n1.5D0\t25-1\t+2.25\n",
	         "u,\"Points:0\",\"Points:1\",\"Points:2\"\nnan,0.25,0.5,0.75\n\"a, b\",1.5,2.5,2.25\n",
	         "x [m]\tz [m]\ty [m]\n0.25\t0.75\t0.5\n1.5\t2.25\t2.5\n",
	         "east,north,up\n0.25,0.5,0.75\n1.5,2.5,2.25\n",
	     })
		EXPECT_EQ(sample({image, "--points", write("h.csv", text)}), wanted) << text;
	for (const std::string text : {"id,east,north,up\n1,0,0,0\n", "x,y,z\n1,2\n", "x,y,z\n1;2;3\n", "a 2 3\n1 2 3\n"})
		EXPECT_TRUE(isError(run({"sample", image, "--points", write("h.csv", text)}), 2, {"h.csv", "line"})) << text;
	EXPECT_TRUE(
	    isError(run({"sample", image, "--points", write("n.csv", "1 2 NaN\n")}), 2, {"line 1", "NaN", "leave"}));
}

TEST_F(Sample, BadPointsNameFileAndLine)
{
	for (const std::string line :
	     {"1 2", "1 2 3 4", "x y z", "1,,2,3", "1 2 3,", "1 2 nan", "1 2 1e999", "1 2 3x", ",1 2 3", "+-1 2 3"})
	{
		const std::string points = write("bad.txt", "0 0 0\n\n" + line + "\n1 2 3\n");
		EXPECT_TRUE(isError(run({"sample", "demo:blob:4", "--points", points, "-o", path("out.csv")}), 2,
		                    {"bad.txt", "line 3", "three numbers"}))
		    << line;
	}
	EXPECT_TRUE(isError(run({"sample", "demo:blob:4", "--points", path("none.txt")}), 2, {"none.txt", "cannot be"}));
	EXPECT_TRUE(isError(run({"sample", "demo:blob:4", "--points", path("")}), 2, {"cannot be read"})); // a folder
	EXPECT_EQ(files(), Arguments{"bad.txt"});
}

TEST_F(Sample, WhatCannotBeIsRefused)
{
	const Arguments sample{"sample", "demo:blob:4"};
	const auto line = [&](const std::string& x1, const std::string& n) {
		return run(sample + Arguments{"--line", "0", "0", "0", x1, "0", "0", n});
	};
	EXPECT_TRUE(isError(run(sample), 1, {"--points", "--line"}));
	EXPECT_TRUE(isError(run(sample + Arguments{"--points", "-", "--line", "0", "0", "0", "1", "1", "1", "5"}), 1,
	                    {"--points", "--line"}));
	for (const char* count : {"1", "0", "-3", "2.5", "1e9"})
		EXPECT_TRUE(isError(line("1", count), 1, {"--line"})) << count;
	EXPECT_TRUE(isError(line("0", "5"), 1, {"--line", "length"}));
	EXPECT_TRUE(isError(line("inf", "5"), 1, {"--line"}));
	EXPECT_TRUE(isError(run(sample + Arguments{"--line", "0", "0", "0", "1", "1", "1"}), 1, {"--line"}));
	const Arguments good = sample + Arguments{"--line", "0", "0", "0", "1", "1", "1", "5"};
	EXPECT_TRUE(isError(run(good + Arguments{"--array", "none"}), 2, {"none", "point:s"}));
	write("none", "a file where the folder would be");
	EXPECT_TRUE(isError(run(good + Arguments{"-o", path("none/out.csv")}), 4, {"none/out.csv"}));
	const Arguments many = sample + Arguments{"--line", "0", "0", "0", "1", "1", "1", "500", "-o", path("out.csv")};
	EXPECT_TRUE(isError(run(many, {.file_size_limit = 3000}), 4, {"out.csv", "make room"}));
	EXPECT_EQ(files(), Arguments{"none"});
}

} // namespace cli
