#include "tries.h"
#include "view/file_places.h"
#include "view/state_file.h"
#include "view/words.h"

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

// Equal specs have equal texts, which tells more than operator==: it calls -0 and 0 the same.
TEST_F(StateFile, AnUntouchedSpecRoundTrips)
{
	const view::ViewSpec spec;
	ASSERT_TRUE(view::saveState(spec, path("a.json")));
	view::ViewSpec read;
	read.look.samples = 3;                   // is written, so it comes back
	read.probe.normal = Vec3(1.0, 2.0, 3.0); // is not set, so it is not written and stays
	ASSERT_TRUE(view::loadState(read, path("a.json")));
	EXPECT_EQ(read.look.samples, spec.look.samples);
	EXPECT_EQ(read.probe.normal, Vec3(1.0, 2.0, 3.0));
	read.probe.normal.reset();
	EXPECT_EQ(read, spec);
}

// JSON holds no other encoding: such a name would come back as that of another file.
TEST_F(StateFile, NamesThatAreNotUtf8AreRefused)
{
	view::ViewSpec spec;
	spec.input.files = {path("a\xE4.vtu")};
	const Status saved = view::saveState(spec, path("a.json"));
	ASSERT_FALSE(saved);
	EXPECT_EQ(saved.error().kind, ErrorKind::output);
	EXPECT_EQ(saved.error().message, path("a.json") +
	                                     ": cannot keep /input/files, which is not UTF-8; rename the file, or "
	                                     "write the text in UTF-8");
	EXPECT_FALSE(std::filesystem::exists(path("a.json")));
	spec.input.files = {path("a\xC3\xA4.vtu")};
	ASSERT_TRUE(view::saveState(spec, path("a.json")));
	view::ViewSpec read;
	ASSERT_TRUE(view::loadState(read, path("a.json")));
	EXPECT_EQ(read.input.files, spec.input.files);
}

TEST_F(StateFile, AColorMapsFileIsRelativeToo)
{
	view::ViewSpec spec;
	spec.look.colormap = path("maps.json");
	ASSERT_TRUE(view::saveState(spec, path("a.json")));
	EXPECT_NE(textOf(path("a.json")).find("\"maps.json\""), std::string::npos);
	view::ViewSpec read;
	ASSERT_TRUE(view::loadState(read, path("a.json")));
	EXPECT_EQ(read.look.colormap, path("maps.json"));
}

namespace
{

// Any finite number that JSON can hold.
double anyNumber(std::mt19937_64& random)
{
	std::uniform_int_distribution<std::uint64_t> bits;
	for (;;)
		if (const double number = std::bit_cast<double>(bits(random)); std::isfinite(number))
			return number;
}

view::ViewSpec anySpec(std::mt19937_64& random)
{
	const auto number = [&] { return anyNumber(random); };
	const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
	const auto coin = [&] { return random() % 2 == 0; };
	const auto vector = [&] { return Vec3(number(), number(), number()); };
	view::ViewSpec spec;
	spec.input.files = {"demo:shell:8"};
	spec.input.time = coin() ? read::timeAt(random() % 100) : read::TimeChoice{read::TimeChoice::Kind::value, number()};
	spec.input.displace = number();
	view::ProbeSpec& probe = spec.probe;
	probe.shape = coin() ? view::ProbeShape::stack : view::ProbeShape::paddlewheel;
	probe.origin = vector();
	probe.normal = coin() ? vector() : Vec3(0.0, 1.0, 0.0);
	probe.up = vector();
	probe.window = probe::WindowSize{share() + 0.1, share() + 0.1};
	probe.surface = *view::parseSurface(coin() ? "sphere:0.25" : coin() ? "i=2.5..7" : "patch=in=let");
	probe.crinkle = coin();
	probe.offsets.assign(random() % 5, number());
	probe.sheets = static_cast<int>(1 + random() % 8);
	probe.corners = coin() ? mesh::Corners::skip : mesh::Corners::keep;
	probe.hanging = coin() ? mesh::Hanging::interpolate : mesh::Hanging::keep;
	probe.array = "point:\"é\n\\";
	probe.component = static_cast<int>(random() % 9) - 1;
	probe.threshold = find::Threshold{number(), number()};
	probe.seeds = coin() ? seed::SeedMode::hotspot : seed::SeedMode::boundary;
	probe.outside = coin() ? seed::OutsidePolicy::refuse : seed::OutsidePolicy::report;
	probe.vectors.kind = coin() ? std::optional(view::TraceKind::tubes) : std::nullopt;
	probe.vectors.jitter = share();
	probe.vectors.steps = 1000.0 * share();
	probe.vectors.direction = vectors::Direction::both;
	probe.vectors.part = vectors::VectorPart::tangential;
	view::LookSpec& look = spec.look;
	look.size = {static_cast<std::uint32_t>(1 + random() % 1000), 77};
	look.color_by = coin() ? view::ColorBy::generation : view::ColorBy::array;
	look.range = std::pair{number(), number()};
	look.range_of = view::RangeOf::slice;
	look.opacity_points = {share(), share(), share(), share()};
	look.opacity = share();
	look.background = *render::parseBackground(coin() ? "#0a2b3c" : "transparent");
	look.camera = coin() ? render::fixedCamera({.position = vector(), .focal_point = vector(), .up = vector()})
	                     : *render::parseCamera("30,-20.5");
	look.outline = render::Outline::edges;
	look.context = {*view::parseContext("boundary"), *view::parseContext("k=3.5:0.25"),
	                *view::parseContext("patch=a:b")};
	look.axes = view::AxesStyle::box;
	look.title = coin() ? "" : "\"é\n\\";
	look.contour.values = {number(), number()};
	look.contour.at = std::pair{number(), number()};
	spec.sweep.over_times = coin();
	spec.sweep.frames = 7;
	return spec;
}

} // namespace

TEST_F(StateFile, AnySpecKeepsEveryBit)
{
	std::mt19937_64 random(7);
	for (int round = 0; round < tries(200); ++round)
	{
		const view::ViewSpec spec = anySpec(random);
		const std::string text = view::stateText(spec, path("a.json"));
		view::ViewSpec read;
		const Status done = view::readState(read, text, path("a.json"));
		ASSERT_TRUE(done) << done.error().message << '\n' << text;
		ASSERT_EQ(read, spec) << text;
		ASSERT_EQ(view::stateText(read, path("a.json")), text);
	}
}

TEST_F(StateFile, ProbesAndPathsOfTheUsersMaking)
{
	view::ViewSpec spec;
	spec.probe.shape = view::ProbeShape::own;
	spec.probe.own = probe::ProbeFile{{{probe::makeSheet({0.1, 0.2, 0.3}, {0.3, 0.5, 0.81})}}, false};
	spec.sweep.own.emplace().kind = probe::PathKind::spin;
	spec.sweep.own->degrees = 0.1 + 0.2;
	ASSERT_TRUE(view::saveState(spec, path("a.json")));
	view::ViewSpec read;
	ASSERT_TRUE(view::loadState(read, path("a.json")));
	EXPECT_EQ(read, spec);

	spec.probe.own->placed = true;
	spec.probe.own->probe.frame.origin = {1.0, 2.0, 3.0};
	ASSERT_TRUE(view::saveState(spec, path("a.json")));
	ASSERT_TRUE(view::loadState(read, path("a.json")));
	EXPECT_EQ(read, spec);
}

TEST_F(StateFile, WhatDoesNotFitIsOneLineThatSaysWhere)
{
	const auto refused = [&](const std::string& text, const std::string& where)
	{
		std::ofstream(path("s.json")) << text;
		view::ViewSpec spec;
		spec.look.samples = 3;
		const view::ViewSpec before = spec;
		const Status loaded = view::loadState(spec, path("s.json"));
		ASSERT_FALSE(loaded) << text;
		EXPECT_EQ(spec, before);
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
	refused(R"({"version": 1, "look": {"sz": ""}})", "/look/sz: unknown key");
	refused(R"({"version": 1, "probe": {"array": ""}})", "/probe/array");
	refused(R"({"version": 1, "probe": {"array": 1}})", "/probe/array");
	refused(R"({"version": 1, "look": {"samples": 2147483648}})", "/look/samples");
	refused(R"({"version": 1, "look": {"samples": 1, "samples": 1}})", "/look/samples: a key given twice");
	refused(R"({"version": 1, "look": {"samples": 0}})", "/look/samples: 0: give a number from 1 to 256");
	refused(R"({"version": 1, "look": {"mesh": 0}})", "/look/mesh");
	refused(R"({"version": 1, "look": {"opacity": 1.5}})", "/look/opacity: 1.5");
	refused(R"({"version": 1, "look": {"size": "big"}})", "/look/size: big: no size");
	refused(R"({"version": 1, "look": {"camera": "up"}})", "/look/camera: up: no view");
	refused(R"({"version": 1, "look": {"axes": "all"}})", "/look/axes: all: takes corner, box or none");
	refused(R"({"version": 1, "probe": {"origin": [1, 2, "a"]}})", "/probe/origin/2");
	refused(R"({"version": 1, "probe": {"origin": [1, 2]}})", "/probe/origin");
	refused(R"({"version": 1, "probe": {"normal": "0 0 0"}})", "/probe/normal: 0 0 0: a zero vector");
	refused(R"({"version": 1, "probe": {"vanes": 0}})", "/probe/vanes");
	refused(R"({"version": 1, "probe": {"component": "w"}})", "/probe/component: w");
	refused(R"({"version": 1, "probe": {"surface": "i=x"}})", "/probe/surface: i=x");
	refused(R"({"version": 1, "look": {"context": ["boundary", 1]}})", "/look/context/1");
	refused(R"({"version": 1, "look": {"context": ["glass"]}})", "/look/context: glass");
	refused(R"({"version": 1, "look": {"context": "boundary"}})", "/look/context");
	refused(R"({"version": 1, "look": {"opacity": null}})", "/look/opacity");
	refused(R"({"version": 1, "input": {"files": "a.vtu"}})", "/input/files");
	refused(R"({"version": 1, "input": {"time": "noon"}})", "/input/time: noon");
	refused(R"({"version": 1, "probe": {"probe": "cube"}})", "/probe/probe: cube");
	refused(R"({"version": 1, "probe": {"probe": {"sheets": [{"opacity": 2}]}}})", "/probe/probe/sheets/0/opacity");
	refused(R"({"version": 1, "sweep": {"path": "fly"}})", "/sweep/path: fly");
	refused(R"({"version": 1, "sweep": {"path": {"path": "fly"}}})", "/sweep/path/path");
}

TEST_F(StateFile, FilesAreRelativeToIt)
{
	fs::create_directories(folder_ / "a/b");
	fs::create_directories(folder_ / "c");
	const std::string state = path("a/b/s.json");
	EXPECT_EQ(view::relativeTo(state, path("c/grid.vtu")), "../../c/grid.vtu");
	EXPECT_EQ(view::relativeTo(state, path("a/b/grid.vtu")), "grid.vtu");
	EXPECT_EQ(view::relativeTo(state, path("a/../c/./grid.vtu")), "../../c/grid.vtu");
	EXPECT_EQ(view::relativeTo(state, "demo:shell:8"), "demo:shell:8");
	EXPECT_TRUE(fs::equivalent(folder_ / "c", fs::path(view::fromState(state, "../../c/grid.vtu")).parent_path()));
	EXPECT_EQ(view::fromState(state, "demo:shell:8"), "demo:shell:8");
	EXPECT_EQ(view::fromState(state, "/data/grid.vtu"), "/data/grid.vtu");
}

// A link that is an input keeps its name; one on the way to it is followed.
TEST_F(StateFile, LinksLeadToTheSameFile)
{
	fs::create_directories(folder_ / "deep/data");
	std::ofstream(path("deep/data/v1.vtu")) << "x";
	fs::create_symlink("v1.vtu", path("deep/data/latest.vtu"));
	fs::create_directory_symlink("deep/data", path("data"));
	EXPECT_EQ(view::relativeTo(path("s.json"), path("data/latest.vtu")), "deep/data/latest.vtu");
	const std::string back =
	    view::fromState(path("data/s.json"), view::relativeTo(path("data/s.json"), path("deep/data/v1.vtu")));
	EXPECT_TRUE(fs::equivalent(back, path("deep/data/v1.vtu")));
}

} // namespace vp::test
