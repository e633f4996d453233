#include "program.h"
#include "sample_files.h"

#include <algorithm>
#include <sstream>

namespace cli
{

namespace
{

class Output : public Program
{
protected:
	Outcome slice(const Arguments& options, const Surroundings& surroundings = {}) const
	{
		return run(Arguments{"slice", "demo:shell:16", "--normal", "1", "2", "3", "--classify", "cpu"} + options,
		           surroundings);
	}
	nlohmann::json sheet() const { return stats({"demo:shell:16", "--normal", "1", "2", "3"})["sheets"][0]; }
};

// The number after `key` in a text such as NumberOfPoints="12" or "element vertex 12".
long numberAfter(const std::string& text, const std::string& key)
{
	const std::size_t at = text.find(key);
	return at == std::string::npos ? -1 : std::strtol(text.c_str() + at + key.size(), nullptr, 10);
}

void expectWholeVtp(const std::string& vtp, const nlohmann::json& sheet)
{
	EXPECT_TRUE(contains(vtp, "<VTKFile")) << vtp.substr(0, 200);
	EXPECT_TRUE(contains(vtp, "PolyData"));
	EXPECT_TRUE(contains(vtp, "</VTKFile>"));
	EXPECT_EQ(numberAfter(vtp, "NumberOfPoints=\""), sheet["vertices"].get<long>());
	EXPECT_EQ(numberAfter(vtp, "NumberOfPolys=\""), sheet["polygons"].get<long>());
	for (const char* array : {"\"s\"", "\"v\"", "\"vprobe:cell\"", "\"vprobe:block\"", "\"vprobe:sheet\""})
		EXPECT_TRUE(contains(vtp, array)) << array;
}

} // namespace

TEST_F(Output, Vtp)
{
	ASSERT_TRUE(isQuiet(slice({"-o", path("out.vtp")})));
	EXPECT_EQ(files(), Arguments{"out.vtp"});
	expectWholeVtp(contents(path("out.vtp")), sheet());
}

TEST_F(Output, VtpOnStandardOutput)
{
	const Outcome outcome = slice({"-o", "-"});
	ASSERT_TRUE(isQuiet(outcome));
	expectWholeVtp(outcome.out, sheet());
	EXPECT_TRUE(files().empty());
}

TEST_F(Output, Ply)
{
	ASSERT_TRUE(isQuiet(slice({"-o", path("out.ply")})));
	const std::string ply = contents(path("out.ply"));
	EXPECT_EQ(ply.substr(0, 4), "ply\n");
	EXPECT_EQ(numberAfter(ply, "element vertex "), sheet()["vertices"].get<long>());
	EXPECT_EQ(numberAfter(ply, "element face "), sheet()["polygons"].get<long>());
}

TEST_F(Output, Csv)
{
	ASSERT_TRUE(isQuiet(slice({"-o", path("out.csv")})));
	std::istringstream lines(contents(path("out.csv")));
	std::string header, line;
	std::getline(lines, header);
	EXPECT_TRUE(contains(header, "x,y,z")) << header;
	const auto commas = std::count(header.begin(), header.end(), ',');
	long rows = 0;
	for (; std::getline(lines, line); ++rows)
		ASSERT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
	EXPECT_GE(rows, sheet()["vertices"].get<long>()); // a row for each corner of each polygon
}

TEST_F(Output, StatsInAFileOrOnStandardOutput)
{
	ASSERT_TRUE(isQuiet(slice({"--stats", path("out.json")})));
	EXPECT_EQ(nlohmann::json::parse(contents(path("out.json")))["sheets"][0]["cut_cells"], sheet()["cut_cells"]);
	EXPECT_EQ(slice({"--stats", "-"}).json()["sheets"][0]["cut_cells"], sheet()["cut_cells"]);
	// One for the file, one for standard output.
	const Outcome both = slice({"-o", "-", "--stats", path("other.json")});
	ASSERT_TRUE(isQuiet(both));
	EXPECT_TRUE(contains(both.out, "<VTKFile"));
	EXPECT_TRUE(nlohmann::json::accept(contents(path("other.json"))));
}

TEST_F(Output, ReplacesWhatWasThere)
{
	write("out.vtp", std::string(1 << 20, 'x'));
	ASSERT_TRUE(isQuiet(slice({"-o", path("out.vtp")})));
	const std::string vtp = contents(path("out.vtp"));
	EXPECT_TRUE(vtp.ends_with("</VTKFile>\n") || vtp.ends_with("</VTKFile>"));
}

TEST_F(Output, FoldersAreMadeForOutputThatIsComplete)
{
	for (const std::string output : {"a/out.vtp", "a/b/out.ply", "c/d/e/out.csv"})
	{
		EXPECT_TRUE(isQuiet(slice({"-o", path(output)})));
		EXPECT_TRUE(std::filesystem::is_regular_file(path(output))) << output;
	}
	EXPECT_TRUE(isQuiet(slice({"--stats", path("f/out.json")})));
	EXPECT_EQ(files(), (Arguments{"a", "c", "f"}));
	// Nothing is left of a command that fails before.
	EXPECT_EQ(run({"slice", "demo:shell:4", "--array", "none", "-o", path("g/out.vtp")}).status, 2);
	EXPECT_EQ(files(), (Arguments{"a", "c", "f"}));
}

TEST_F(Output, AFileStandsInTheFoldersPlace)
{
	write("taken", "x");
	for (const std::string output : {"taken/out.vtp", "taken/a/out.ply"})
		EXPECT_TRUE(isError(slice({"-o", path(output)}), 4, {path(output), "in the place of its folder"}));
	EXPECT_TRUE(isError(slice({"--stats", path("taken/out.json")}), 4, {path("taken/out.json")}));
	EXPECT_EQ(files(), Arguments{"taken"});
}

TEST_F(Output, IsAFolder)
{
	std::filesystem::create_directory(path("out.vtp"));
	EXPECT_TRUE(isError(slice({"-o", path("out.vtp")}), 4, {path("out.vtp")}));
	EXPECT_EQ(files(), Arguments{"out.vtp"});
}

// The figures of a sweep's frames wait in the folder for temporary files.
TEST_F(Output, ASweepNeedsAFolderForItsFigures)
{
	const Arguments sweep{"sweep", "demo:shell:6", "--classify", "cpu", "--frames", "2", "--stats", path("s.json")};
	EXPECT_TRUE(isError(run(sweep, {.environment = {{"TMPDIR", path("none")}}}), 4, {"--stats", "TMPDIR"}));
	EXPECT_FALSE(std::filesystem::exists(path("s.json")));
	EXPECT_EQ(run(sweep, {.environment = {{"TMPDIR", path("")}}}).status, 0);
	EXPECT_EQ(nlohmann::json::parse(contents(path("s.json")))["frames"].size(), 2u);
}

// All outputs or none: the slice could be written, its stats could not.
TEST_F(Output, OneOfTwoCannotBeWritten)
{
	write("taken", "x");
	EXPECT_TRUE(
	    isError(slice({"-o", path("out.vtp"), "--stats", path("taken/out.json")}), 4, {path("taken/out.json")}));
	EXPECT_EQ(files(), Arguments{"taken"});
}

TEST_F(Output, DiskIsFull)
{
	for (const std::string output : {"out.vtp", "out.ply", "out.csv"})
	{
		EXPECT_TRUE(isError(slice({"-o", path(output)}, {.file_size_limit = 4096}), 4, {path(output)}));
		EXPECT_TRUE(files().empty()) << output;
	}
	EXPECT_TRUE(isError(slice({"--stats", path("out.json")}, {.file_size_limit = 512}), 4, {path("out.json")}));
	EXPECT_TRUE(files().empty());
}

TEST_F(Output, StandardOutputIsFull)
{
	for (const Arguments& options : {Arguments{"-o", "-"}, Arguments{"--stats", "-"}, Arguments{}})
		EXPECT_TRUE(isError(slice(options, {.standard_output = "/dev/full"}), 4, {}));
	EXPECT_TRUE(isError(run({"info", "demo:shell:4"}, {.standard_output = "/dev/full"}), 4, {}));
	EXPECT_TRUE(isError(run({"info", "demo:shell:4", "--json"}, {.standard_output = "/dev/full"}), 4, {}));
}

// A closed stream is taken by no file, and ends nothing.
TEST_F(Output, StandardOutputIsClosed)
{
	const Surroundings closed{.closed = {1}};
	EXPECT_TRUE(isError(slice({}, closed), 4, {"standard output"}));
	EXPECT_TRUE(isError(run({"info", "demo:shell:4"}, closed), 4, {"standard output"}));
	EXPECT_TRUE(isError(run({"--help"}, closed), 4, {"standard output"}));
	for (const Arguments& told : {Arguments{"--version"}, Arguments{"--help"}, Arguments{"slice", "--help"}})
		for (const Surroundings& full : {closed, Surroundings{.standard_output = "/dev/full"}})
			EXPECT_TRUE(isError(run(told, full), 4, {"standard output"})) << told.back();
	EXPECT_TRUE(isQuiet(slice({"-o", path("out.vtp")}, {.closed = {0, 1, 2}})));
	expectWholeVtp(contents(path("out.vtp")), sheet());
}

// A line that cannot be written changes neither the exit code nor what is done after it.
TEST_F(Output, LinesCannotBeWritten)
{
	const Arguments nothing_cut = {"slice", "demo:shell:4", "--origin", "99", "0", "0", "-o", path("out.csv")};
	for (const Surroundings& without : {Surroundings{.standard_error = "/dev/full"}, Surroundings{.closed = {2}}})
	{
		EXPECT_EQ(run({"info", path("none.vtu")}, without).status, 2);
		EXPECT_EQ(run({"info", "--none"}, without).status, 1);
		EXPECT_EQ(run(nothing_cut, without).status, 0);
		EXPECT_EQ(files(), Arguments{"out.csv"});
		std::filesystem::remove(path("out.csv"));
	}
}

TEST_F(Output, StatsToAFullDevice)
{
	EXPECT_TRUE(isError(slice({"--stats", "/dev/full"}), 4, {"/dev/full"}));
}

// The old file stays if the new one cannot be written completely.
TEST_F(Output, KeepsTheOldFileWhenTheInputFails)
{
	write("out.vtp", "old");
	EXPECT_EQ(run({"slice", path("absent.vtu"), "--classify", "cpu", "-o", path("out.vtp")}).status, 2);
	EXPECT_EQ(contents(path("out.vtp")), "old");
}

TEST_F(Output, NamesOfFilesMayBeOdd)
{
	const std::string input = write("a b\xc3\xa9 'c'.vtk", legacyImage());
	const std::string output = path("o u t\xc3\xa9.vtp");
	ASSERT_TRUE(isQuiet(run({"slice", input, "--classify", "cpu", "-o", output})));
	EXPECT_TRUE(contains(contents(output), "</VTKFile>"));
}

} // namespace cli
