#include "state/file_places.h"
#include "state/state_file.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

namespace vp::test
{

namespace
{

namespace fs = std::filesystem;

// One setting of each kind.
struct Values
{
	std::string text = "standard";
	std::optional<std::string> title;
	int number = 5;
	std::optional<int> count;
	double length = 0.5;
	bool flag = false;
	std::vector<double> numbers;
	std::vector<std::string> words;
	std::vector<std::string> inputs;
	std::string solution;
	std::string colors = "turbo";
	std::string probe = "single";
	std::optional<probe::ProbeFile> own_probe;
	std::string path = "translate";
	std::optional<probe::Path> own_path;

	state::Sections sections()
	{
		return {{"one",
		         {{"text", &text},
		          {"title", &title},
		          {"number", &number},
		          {"count", &count},
		          {"length", &length},
		          {"flag", &flag},
		          {"numbers", &numbers},
		          {"words", &words}}},
		        {"two",
		         {{"inputs", state::Files{&inputs}},
		          {"solution", state::File{&solution}},
		          {"colors", state::NameOrFile{&colors}},
		          {"probe", state::ProbeChoice{&probe, &own_probe}},
		          {"path", state::PathChoice{&path, &own_path}}}}};
	}
};

class StateFile : public testing::Test
{
protected:
	StateFile()
	{
		std::string pattern = (fs::temp_directory_path() / "vprobe-state-XXXXXX").string();
		if (mkdtemp(pattern.data()))
			folder_ = pattern;
	}
	~StateFile() override
	{
		std::error_code ignored;
		fs::remove_all(folder_, ignored);
	}
	std::string path(const std::string& name) const { return (folder_ / name).string(); }
	static std::string textOf(const std::string& file)
	{
		std::ostringstream text;
		text << std::ifstream(file, std::ios::binary).rdbuf();
		return text.str();
	}

	fs::path folder_;
};

} // namespace

TEST_F(StateFile, StandardValuesRoundTrip)
{
	Values values;
	ASSERT_TRUE(state::save(values.sections(), path("a.json")));
	Values read;
	read.number = 6; // is written, so it comes back as 5
	ASSERT_TRUE(state::load(read.sections(), path("a.json")));
	EXPECT_EQ(read.number, 5);
	EXPECT_FALSE(read.title);
	EXPECT_FALSE(read.count);
	EXPECT_TRUE(read.numbers.empty());
	EXPECT_TRUE(read.words.empty());
	EXPECT_EQ(read.colors, "turbo");
}

TEST_F(StateFile, AColorMapsFileIsRelativeToo)
{
	Values values;
	values.colors = path("maps.json");
	ASSERT_TRUE(state::save(values.sections(), path("a.json")));
	EXPECT_NE(textOf(path("a.json")).find("\"maps.json\""), std::string::npos);
	Values read;
	ASSERT_TRUE(state::load(read.sections(), path("a.json")));
	EXPECT_EQ(read.colors, path("maps.json"));
}

TEST_F(StateFile, AnyNumbersKeepEveryBit)
{
	std::mt19937_64 random(7);
	std::uniform_int_distribution<std::uint64_t> bits;
	for (int round = 0; round < tries(200); ++round)
	{
		Values values;
		for (int i = 0; i < 20; ++i)
			if (const double number = std::bit_cast<double>(bits(random)); std::isfinite(number))
				values.numbers.push_back(number);
		values.length = values.numbers.empty() ? -0.0 : values.numbers.front();
		values.number = std::numeric_limits<int>::min() + round;
		values.title = round % 2 ? "" : "\"é\n\\";
		values.count = round;
		values.flag = round % 3 == 0;
		values.words.assign(static_cast<std::size_t>(round % 5), "é:\"" + std::to_string(round));
		ASSERT_TRUE(state::save(values.sections(), path("a.json")));
		Values read;
		ASSERT_TRUE(state::load(read.sections(), path("a.json")));
		ASSERT_EQ(read.numbers.size(), values.numbers.size());
		for (std::size_t i = 0; i < read.numbers.size(); ++i)
			EXPECT_EQ(std::bit_cast<std::uint64_t>(read.numbers[i]), std::bit_cast<std::uint64_t>(values.numbers[i]));
		EXPECT_EQ(read.title, values.title);
		EXPECT_EQ(read.number, values.number);
		EXPECT_EQ(read.count, values.count);
		EXPECT_EQ(read.flag, values.flag);
		EXPECT_EQ(read.words, values.words);
		ASSERT_TRUE(state::save(read.sections(), path("b.json")));
		ASSERT_EQ(textOf(path("a.json")), textOf(path("b.json")));
	}
}

TEST_F(StateFile, ProbesAndPathsOfTheUsersMaking)
{
	Values values;
	values.probe = "p.json";
	values.own_probe = probe::ProbeFile{{{probe::makeSheet({0.1, 0.2, 0.3}, {0.3, 0.5, 0.81})}}, false};
	values.path = "k.json";
	values.own_path.emplace().kind = probe::PathKind::spin;
	values.own_path->degrees = 0.1 + 0.2;
	ASSERT_TRUE(state::save(values.sections(), path("a.json")));
	Values read;
	ASSERT_TRUE(state::load(read.sections(), path("a.json")));
	EXPECT_TRUE(read.probe.empty());
	ASSERT_TRUE(read.own_probe);
	EXPECT_EQ(read.own_probe->probe, values.own_probe->probe);
	EXPECT_FALSE(read.own_probe->placed);
	EXPECT_EQ(read.own_path, values.own_path);

	values.own_probe->placed = true;
	values.own_probe->probe.frame.origin = {1.0, 2.0, 3.0};
	ASSERT_TRUE(state::save(values.sections(), path("a.json")));
	ASSERT_TRUE(state::load(read.sections(), path("a.json")));
	EXPECT_TRUE(read.own_probe->placed);
	EXPECT_EQ(read.own_probe->probe, values.own_probe->probe);
}

TEST_F(StateFile, WhatDoesNotFitIsOneLineThatSaysWhere)
{
	const auto refused = [&](const std::string& text, const std::string& where)
	{
		std::ofstream(path("s.json")) << text;
		Values values;
		const Status loaded = state::load(values.sections(), path("s.json"));
		ASSERT_FALSE(loaded) << text;
		EXPECT_EQ(loaded.error().kind, ErrorKind::input);
		EXPECT_NE(loaded.error().message.find(path("s.json") + ": " + where), std::string::npos)
		    << loaded.error().message;
		EXPECT_EQ(loaded.error().message.find('\n'), std::string::npos);
	};
	refused("{\"version\": 1", "line 1, column 14");
	refused("7", "the document");
	refused("{}", "the document: \"version\" is missing");
	refused(R"({"version": 1.5})", "/version");
	refused(R"({"version": "1"})", "/version");
	refused(R"({"version": 1, "three": {}})", "/three: unknown key");
	refused(R"({"version": 1, "one": {"txt": ""}})", "/one/txt: unknown key");
	refused(R"({"version": 1, "one": {"text": ""}})", "/one/text");
	refused(R"({"version": 1, "one": {"text": 1}})", "/one/text");
	refused(R"({"version": 1, "one": {"number": 2147483648}})", "/one/number");
	refused(R"({"version": 1, "one": {"number": 1, "number": 1}})", "/one/number: a key given twice");
	refused(R"({"version": 1, "one": {"flag": 0}})", "/one/flag");
	refused(R"({"version": 1, "one": {"numbers": [1, "a"]}})", "/one/numbers/1");
	refused(R"({"version": 1, "one": {"words": ["a", 1]}})", "/one/words/1");
	refused(R"({"version": 1, "one": {"words": "a"}})", "/one/words");
	refused(R"({"version": 1, "one": {"length": null}})", "/one/length");
	refused(R"({"version": 1, "two": {"inputs": "a.vtu"}})", "/two/inputs");
	refused(R"({"version": 1, "two": {"probe": {"sheets": [{"opacity": 2}]}}})", "/two/probe/sheets/0/opacity");
	refused(R"({"version": 1, "two": {"path": {"path": "fly"}}})", "/two/path/path");
}

TEST_F(StateFile, FilesAreRelativeToIt)
{
	fs::create_directories(folder_ / "a/b");
	fs::create_directories(folder_ / "c");
	const std::string state = path("a/b/s.json");
	EXPECT_EQ(state::relativeTo(state, path("c/grid.vtu")), "../../c/grid.vtu");
	EXPECT_EQ(state::relativeTo(state, path("a/b/grid.vtu")), "grid.vtu");
	EXPECT_EQ(state::relativeTo(state, path("a/../c/./grid.vtu")), "../../c/grid.vtu");
	EXPECT_EQ(state::relativeTo(state, "demo:shell:8"), "demo:shell:8");
	EXPECT_TRUE(fs::equivalent(folder_ / "c", fs::path(state::fromState(state, "../../c/grid.vtu")).parent_path()));
	EXPECT_EQ(state::fromState(state, "demo:shell:8"), "demo:shell:8");
	EXPECT_EQ(state::fromState(state, "/data/grid.vtu"), "/data/grid.vtu");
}

// A link that is an input keeps its name; one on the way to it is followed.
TEST_F(StateFile, LinksLeadToTheSameFile)
{
	fs::create_directories(folder_ / "deep/data");
	std::ofstream(path("deep/data/v1.vtu")) << "x";
	fs::create_symlink("v1.vtu", path("deep/data/latest.vtu"));
	fs::create_directory_symlink("deep/data", path("data"));
	EXPECT_EQ(state::relativeTo(path("s.json"), path("data/latest.vtu")), "deep/data/latest.vtu");
	const std::string back =
	    state::fromState(path("data/s.json"), state::relativeTo(path("data/s.json"), path("deep/data/v1.vtu")));
	EXPECT_TRUE(fs::equivalent(back, path("deep/data/v1.vtu")));
}

} // namespace vp::test
