// --save and --state. What a state draws is tested in drawn_state_test.cpp.

#include "program.h"
#include "sample_files.h"

#include <filesystem>
#include <set>

namespace cli
{

namespace
{

using nlohmann::json;

class State : public Program
{
protected:
	Outcome slice(const Arguments& options) const
	{
		return run(Arguments{"slice"} + options + Arguments{"--classify", "cpu", "--stats", "-"});
	}
	json figures(const Arguments& options) const
	{
		const Outcome outcome = slice(options);
		EXPECT_EQ(outcome.status, 0) << outcome.err;
		return outcome.json().value("sheets", json());
	}
};

class BadState : public Program, public testing::WithParamInterface<std::pair<std::string, std::string>>
{
};

const Arguments kEverything{"demo:mixed:6",
                            "--probe",
                            "paddlewheel",
                            "--vanes",
                            "4",
                            "--origin",
                            "0.1",
                            "0.2",
                            "0.30000000000000004",
                            "--normal",
                            "0.3",
                            "0.5",
                            "0.81",
                            "--up",
                            "0",
                            "1",
                            "1e-300",
                            "--window",
                            "1.5",
                            "0.7",
                            "--corners",
                            "skip",
                            "--array",
                            "v",
                            "--component",
                            "z",
                            "--threshold",
                            "-10",
                            "10.25",
                            "--seeds",
                            "boundary",
                            "--outside",
                            "report",
                            "--time",
                            "first",
                            "--refine",
                            "1"};

} // namespace

TEST_F(State, SavedLoadedAndSavedAgainIsTheSame)
{
	ASSERT_EQ(slice(kEverything + Arguments{"--save", path("a.json")}).status, 0);
	ASSERT_EQ(slice({"--state", path("a.json"), "--save", path("b.json")}).status, 0);
	EXPECT_EQ(contents(path("a.json")), contents(path("b.json")));
	EXPECT_EQ(figures(kEverything), figures({"--state", path("a.json")}));
}

TEST_F(State, ProbesOfFilesStandInItWhole)
{
	const std::string file = write("p.json", R"({"name": "lens", "sheets": [
		{"to_sheet": {"normal": [0.1, 0.2, 0.3]}, "fx": {"magnification": 3.3}, "window": [0.7, 0.3], "array": "v"}]})");
	const Arguments given{"demo:mixed:6", "--probe", file, "--origin", "0.3", "0.1", "0.2"};
	const json cut = figures(given + Arguments{"--save", path("a.json")});
	std::filesystem::remove(file);
	EXPECT_EQ(figures({"--state", path("a.json"), "--save", path("b.json")}), cut);
	EXPECT_EQ(contents(path("a.json")), contents(path("b.json")));
	// It is still one without a place of its own.
	EXPECT_FALSE(json::parse(contents(path("a.json"))).at("probe").at("probe").contains("to_probe"));
	EXPECT_EQ(figures({"--state", path("a.json"), "--probe", "trihedral"}).size(), 3u);
}

TEST_F(State, OptionsBesideItGoBeforeIt)
{
	ASSERT_EQ(slice(kEverything + Arguments{"--save", path("a.json")}).status, 0);
	for (const Arguments& order : {Arguments{"--state", path("a.json"), "--vanes", "2", "--origin", "0", "0", "1"},
	                               Arguments{"--vanes", "2", "--origin", "0", "0", "1", "--state", path("a.json")}})
	{
		const json cut = figures(order);
		ASSERT_EQ(cut.size(), 2u);
		EXPECT_EQ(cut[0].at("origin"), json({0.0, 0.0, 1.0}));
	}
	EXPECT_EQ(slice({"demo:shell:4", "--state", path("a.json")}).json().at("input"), "demo:shell:4");
}

TEST_F(State, InputsAreRelativeToIt)
{
	std::filesystem::create_directories(path("data"));
	std::filesystem::create_directories(path("kept"));
	write("data/a.vtk", legacyImage());
	const json cut = figures({path("data/a.vtk"), "--save", path("kept/s.json")});
	EXPECT_EQ(json::parse(contents(path("kept/s.json"))).at("input").at("files"), json({"../data/a.vtk"}));
	// Both folders move together.
	std::filesystem::create_directories(path("moved"));
	std::filesystem::rename(path("data"), path("moved/data"));
	std::filesystem::rename(path("kept"), path("moved/kept"));
	EXPECT_EQ(figures({"--state", path("moved/kept/s.json")}), cut);
	std::filesystem::remove(path("moved/data/a.vtk"));
	EXPECT_TRUE(isError(slice({"--state", path("moved/kept/s.json")}), 2, {"a.vtk"}));
}

TEST_F(State, NothingIsSavedOfWhatFails)
{
	EXPECT_EQ(slice({"demo:shell:4", "--array", "depth", "--save", path("a.json")}).status, 2);
	EXPECT_TRUE(isError(slice({"demo:shell:4", "--save", "-"}), 1, {"--save -"}));
	// Places are tried before anything is written.
	write("none", "a file where the folder would be");
	for (const char* option : {"--save", "--stats"})
	{
		EXPECT_TRUE(isError(run({"slice", "demo:shell:4", option, path("none/s.json"), "-o", path("left.vtp")}), 4,
		                    {"none/s.json"}));
		EXPECT_FALSE(std::filesystem::exists(path("left.vtp")));
	}
	EXPECT_EQ(slice({"demo:shell:4", "--save", path("none/a.json")}).status, 4);
	EXPECT_EQ(files(), Arguments{"none"});
}

TEST_F(State, SchemaHasTheKeysOfAFile)
{
	const json schema = json::parse(run({"manual", "--schema"}).out);
	for (const char* section : {"input", "probe", "look", "vectors", "contours", "sweep"})
	{
		const std::string file = write("s.json", std::string(R"({"version": 1, ")") + section + R"(": {"?": 1}})");
		const std::string error = slice({"--state", file}).err;
		const std::string start = "the keys here are ";
		const std::size_t at = error.find(start);
		ASSERT_NE(at, std::string::npos) << error;
		std::set<std::string> read, described;
		std::istringstream words(error.substr(at + start.size()));
		for (std::string word; words >> word;)
			read.insert(word.substr(0, word.find(',')));
		for (const auto& [key, value] : schema.at("properties").at(section).at("properties").items())
			described.insert(key);
		EXPECT_EQ(read, described) << section;
	}
}

TEST_P(BadState, IsOneLine)
{
	const auto& [text, word] = GetParam();
	const std::string file = write("s.json", text);
	EXPECT_TRUE(isError(run({"slice", "demo:shell:4", "--state", file}), 2, {"s.json: ", word}));
}

INSTANTIATE_TEST_SUITE_P(
    States, BadState,
    testing::Values(std::pair("{\n\"version\": 1,,}", "line 2, column 14"), std::pair("[]", "an object"),
                    std::pair("{}", "\"version\" is missing"), std::pair(R"({"version": 2})", "/version"),
                    std::pair(R"({"version": 1, "input": 3})", "/input"),
                    std::pair(R"({"version": 1, "view": {}})", "/view: unknown key"),
                    std::pair(R"({"version": 1, "look": {"color": 1}})", "/look/color: unknown key"),
                    std::pair(R"({"version": 1, "look": {"samples": 0}})", "/look/samples"),
                    std::pair(R"({"version": 1, "look": {"samples": 1.5}})", "/look/samples"),
                    std::pair(R"({"version": 1, "look": {"opacity": 1.5}})", "/look/opacity"),
                    std::pair(R"({"version": 1, "look": {"range": [1]}})", "/look/range"),
                    std::pair(R"({"version": 1, "probe": {"origin": [1, 2]}})", "/probe/origin"),
                    std::pair(R"({"version": 1, "probe": {"seeds": "all"}})", "/probe/seeds"),
                    std::pair(R"({"version": 1, "probe": {"probe": {"sheets": [{"window": [0, 1]}]}}})",
                              "/probe/probe/sheets/0/window"),
                    std::pair(R"({"version": 1, "probe": {"probe": 7}})", "/probe/probe"),
                    std::pair(R"({"version": 1, "sweep": {"path": {"path": "spin", "length": -1}}})",
                              "/sweep/path/length"),
                    std::pair(R"({"version": 1, "sweep": {"frames": 0}})", "/sweep/frames"),
                    std::pair(R"({"version": 1, "input": {"files": []}})", "/input/files")));

TEST_F(State, MissingOne)
{
	EXPECT_TRUE(isError(run({"slice", "--state", path("absent.json")}), 2, {"absent.json"}));
}

} // namespace cli
