#include "probe/probe_file.h"

#include "random_probes.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace vp::test
{

namespace
{

struct Malformed
{
	std::string text;
	std::string message; // after the file's name
};

probe::SheetWishes randomWishes(std::mt19937& random)
{
	std::bernoulli_distribution coin;
	probe::SheetWishes wishes;
	if (coin(random))
		wishes.opacity = between(0.0, 1.0, random);
	if (coin(random))
		wishes.array = "point:\"T\"\\\n\t\xC3\xA4/~";
	if (coin(random))
		wishes.component = coin(random) ? grid::kMagnitude : 12;
	if (coin(random))
		wishes.colormap = "turbo";
	if (coin(random))
		wishes.range = {between(-1e300, 0.0, random), between(0.0, 1e-300, random)};
	if (coin(random))
		wishes.lines = std::uniform_int_distribution(0, probe::kMaxLines)(random);
	wishes.hidden = coin(random);
	return wishes;
}

// In a sheet among others, so that paths have something to say.
std::string inSheet(const std::string& members)
{
	return R"({"sheets": [{}, {)" + members + "}]}";
}

std::string inFrame(const std::string& members)
{
	return R"({"to_probe": {)" + members + R"(}, "sheets": [{}]})";
}

std::string manySheets(std::size_t count)
{
	std::string sheets = "{}";
	for (std::size_t i = 1; i < count; ++i)
		sheets += ", {}";
	return R"({"sheets": [)" + sheets + "]}";
}

} // namespace

TEST(ProbeFile, ReadAgainItIsTheSameToTheLastBit)
{
	std::mt19937 random(61);
	for (int i = 0; i < 300; ++i)
	{
		probe::Probe probe = randomProbe(random);
		for (probe::Sheet& sheet : probe.sheets)
			sheet.wishes = randomWishes(random);
		probe.sheets[1].window.reset();
		probe.sheets[2].fx = {};
		const std::string text = probeText(probe);
		const auto read = probe::parseProbe(text, "probe.json");
		ASSERT_TRUE(read) << read.error().message;
		EXPECT_EQ(read->probe, probe);
		EXPECT_TRUE(read->placed);
		EXPECT_EQ(probeText(read->probe), text);
	}
}

TEST(ProbeFile, WhatIsLeftOutHasItsDefault)
{
	const auto read = probe::parseProbe(R"({"sheets": [{}]})", "probe.json");
	ASSERT_TRUE(read) << read.error().message;
	EXPECT_EQ(read->probe, probe::Probe{{probe::Sheet()}});
	EXPECT_FALSE(read->placed);
}

TEST(ProbeFile, SaysWhatASheetIs)
{
	const auto read = probe::parseProbe(R"({
		"$schema": "probe.schema.json", "name": "corner",
		"to_probe": {"origin": [1, 2, 3], "normal": [0, 0, -4]},
		"sheets": [
			{"to_sheet": {"normal": [2, 0, 0], "up": [0, 1, 1]}, "window": [4, 2], "opacity": 0.5, "array": "cell:p",
			 "component": 1, "colormap": "turbo", "range": [-1, 2.5], "lines": 7, "hidden": true},
			{"fx": {"magnification": 3, "pan": [1, 0, 0.5]}, "window": {"x": [0, 1], "y": [-2, 5]}}
		]})",
	                                    "probe.json");
	ASSERT_TRUE(read) << read.error().message;
	const probe::Probe& probe = read->probe;
	EXPECT_EQ(probe.name, "corner");
	EXPECT_EQ(probe.frame, probe::makeFrame({1.0, 2.0, 3.0}, {0.0, 0.0, -1.0}));
	ASSERT_EQ(probe.sheets.size(), 2u);
	EXPECT_EQ(probe.sheets[0].normal, Vec3(1.0, 0.0, 0.0));
	expectNear(probe.sheets[0].up, {0.0, std::sqrt(0.5), std::sqrt(0.5)}, 1e-15);
	EXPECT_EQ(probe.sheets[0].window, (probe::Window{-2.0, 2.0, -1.0, 1.0}));
	EXPECT_EQ(probe.sheets[0].wishes, (probe::SheetWishes{0.5, "cell:p", 1, "turbo", std::pair{-1.0, 2.5}, 7, true}));
	EXPECT_EQ(probe.sheets[1].fx, (probe::Fx{3.0, {1.0, 0.0, 0.5}}));
	EXPECT_EQ(probe.sheets[1].window, (probe::Window{0.0, 1.0, -2.0, 5.0}));
}

// to_sheet as the paper writes it: points are rows, the bottom row is the translation.
TEST(ProbeFile, AMatrixIsThePapers)
{
	std::mt19937 random(62);
	for (int i = 0; i < 100; ++i)
	{
		const probe::Frame frame = randomFrame(random);
		const probe::Transform to = toFrame(frame);
		nlohmann::json rows;
		for (int r = 0; r < 4; ++r)
			rows.push_back({to.row[r].x, to.row[r].y, to.row[r].z, r == 3 ? 1 : 0});
		const nlohmann::json document{{"sheets", {{{"to_sheet", {{"matrix", rows}}}}}}};
		const auto read = probe::parseProbe(document.dump(), "probe.json");
		ASSERT_TRUE(read) << read.error().message;
		expectNear(read->probe.sheets[0], frame, 1e-13);
	}
}

TEST(ProbeFile, SaysWhereAndWhatIsWrong)
{
	const std::string sheet_keys =
	    "to_sheet, fx, window, surface, opacity, array, component, colormap, range, lines, hidden";
	const std::string rigid = "give a rotation and a translation";
	const std::vector<Malformed> table{
	    {"", "line 1, column 1: this is no JSON; mend it (docs/PROBES.md shows how such a file looks)"},
	    {"{\n\"sheets\": [{,}]}",
	     "line 2, column 13: this is no JSON; mend it (docs/PROBES.md shows how such a file looks)"},
	    {"{\"sheets\": [{}]} x",
	     "line 1, column 18: this is no JSON; mend it (docs/PROBES.md shows how such a file looks)"},
	    {inSheet(R"("opacity": NaN)"),
	     "line 1, column 29: this is no JSON; mend it (docs/PROBES.md shows how such a file looks)"},
	    {"[]", "the document: an array where an object with $schema, name, to_probe, sheets belongs"},
	    {"{}", "the document: \"sheets\" is missing; add it"},
	    {R"({"sheets": [], "sheet": 1})", "/sheet: unknown key; the keys here are $schema, name, to_probe, sheets"},
	    {"{\"sheets\": [{}], \"a/b~\\n\": 1}",
	     "/a~1b~0?: unknown key; the keys here are $schema, name, to_probe, sheets"},
	    {R"({"name": 3, "sheets": [{}]})", "/name: 3 where a string that is not empty belongs"},
	    {R"({"name": "", "sheets": [{}]})", "/name: \"\" where a string that is not empty belongs"},
	    {R"({"sheets": {}})", "/sheets: an object where an array of 1 to 64 sheets belongs"},
	    {R"({"sheets": []})", "/sheets: an array of 0 where 1 to 64 sheets belong"},
	    {manySheets(65), "/sheets: an array of 65 where 1 to 64 sheets belong"},
	    {R"({"sheets": [{}, 5]})", "/sheets/1: 5 where an object with " + sheet_keys + " belongs"},
	    {inSheet(R"("opaque": 1)"), "/sheets/1/opaque: unknown key; the keys here are " + sheet_keys},
	    {inSheet(R"("lines": 1, "lines": 2)"), "/sheets/1/lines: a key given twice; remove one"},
	    {inSheet(R"("opacity": 1.5)"),
	     "/sheets/1/opacity: 1.5 is not between 0 and 1; 0 is clear, 1 hides what lies behind"},
	    {inSheet(R"("opacity": "half")"), "/sheets/1/opacity: a string where a number belongs"},
	    {inSheet(R"("opacity": null)"), "/sheets/1/opacity: null where a number belongs"},
	    {inSheet(R"("range": [0, 1e999])"), "/sheets/1/range/1: a number that is not finite; give one that is"},
	    {inSheet(R"("range": [2, 2])"), "/sheets/1/range: 2 is not below 2; give the lower number first"},
	    {inSheet(R"("range": [2])"), "/sheets/1/range: an array of 1 where 2 numbers belong"},
	    {inSheet(R"("lines": 2.5)"), "/sheets/1/lines: 2.5 is not a whole number from 0 to 1000; give one"},
	    {inSheet(R"("hidden": 1)"), "/sheets/1/hidden: 1 where true or false belongs"},
	    {inSheet(R"("component": "w")"),
	     "/sheets/1/component: not a component; use \"magnitude\", \"x\", \"y\", \"z\" or a number from 0"},
	    {inSheet(R"("component": -1)"), "/sheets/1/component: -1 is not a whole number from 0 to 65535; give one"},
	    {inSheet(R"("window": 3)"),
	     "/sheets/1/window: a window is [W, H] or {\"x\": [x0, x1], \"y\": [y0, y1]}; give one of them"},
	    {inSheet(R"("window": [3, 0])"), "/sheets/1/window/1: 0 is no size; give a number above 0"},
	    {inSheet(R"("window": [1e101, 1])"),
	     "/sheets/1/window/0: 1e+101 is not between -1e+100 and 1e+100; give a number that is"},
	    {inSheet(R"("window": {"x": [0, 1e-101], "y": [0, 1]})"),
	     "/sheets/1/window/x: too narrow for a window; give numbers that are farther apart"},
	    {inSheet(R"("window": {"x": [0, 1]})"), "/sheets/1/window: \"y\" is missing; add it"},
	    {inSheet(R"("window": {"x": [1, 0], "y": [0, 1]})"),
	     "/sheets/1/window/x: 1 is not below 0; give the lower number first"},
	    {inSheet(R"("fx": {"magnification": 0})"),
	     "/sheets/1/fx/magnification: 0 is not between 1e-06 and 1000000; 1 shows the content as it is"},
	    {inSheet(R"("fx": {"pan": [1, 2]})"), "/sheets/1/fx/pan: an array of 2 where 3 numbers belong"},
	    {inFrame(R"("normal": [0, 0, 0.0])"),
	     "/to_probe/normal: a zero vector is no direction; give three numbers that are not all zero"},
	    {inFrame(R"("up": [0, 0, 0])"),
	     "/to_probe/up: a zero vector is no direction; give three numbers that are not all zero"},
	    {inFrame(R"("origin": [0, true, 0])"), "/to_probe/origin/1: true or false where a number belongs"},
	    {inFrame(R"("matrix": 1, "up": [0, 1, 0])"), "/to_probe/up: unknown key; the keys here are matrix"},
	    {inFrame(R"("matrix": [[1, 0, 0, 0]])"), "/to_probe/matrix: an array of 1 where 4 rows of 4 numbers belong"},
	    {inFrame(R"("matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0], [0, 0, 0, 1]])"),
	     "/to_probe/matrix: a singular matrix; " + rigid},
	    {inFrame(R"("matrix": [[1, 2, 3, 0], [4, 5, 6, 0], [7, 8, 9, 0], [0, 0, 0, 1]])"),
	     "/to_probe/matrix: a singular matrix; " + rigid},
	    {inFrame(R"("matrix": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]])"),
	     "/to_probe/matrix: a matrix that scales or shears; " + rigid + ", and sizes as the window or fx"},
	    {inFrame(R"("matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]])"),
	     "/to_probe/matrix: a matrix that mirrors; " + rigid},
	    {inFrame(R"("matrix": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"),
	     "/to_probe/matrix/0/3: the last column is 0, 0, 0, 1: points are rows, and the bottom row is the translation; "
	     "transpose the matrix"}};
	for (const Malformed& malformed : table)
	{
		const auto read = probe::parseProbe(malformed.text, "probe.json");
		ASSERT_FALSE(read) << malformed.text;
		EXPECT_EQ(read.error().message, "probe.json: " + malformed.message) << malformed.text;
		EXPECT_EQ(read.error().kind, ErrorKind::input);
	}
	EXPECT_TRUE(probe::parseProbe(manySheets(64), "probe.json"));
	EXPECT_EQ(probe::parseProbe(std::string(1 << 20, '['), "probe.json").error().message,
	          "probe.json: nested more than 32 deep; no probe or path is");
}

// Whatever becomes of a file, it is read as a probe that can be used or refused in one line.
TEST(ProbeFile, DamagedFilesAreReadOrRefused)
{
	std::mt19937 random(64);
	const std::string tokens[] = {"0", "-1", "1e308", "1e-320", "null",  "[",    "]",  "{",
	                              "}", ",",  ":",     "\"",     "\"x\"", "\xFF", "\n", "e"};
	int refused = 0;
	for (int i = 0; i < 3000; ++i)
	{
		std::string text = probeText(randomProbe(random));
		for (int damage = 0; damage <= i % 3; ++damage)
		{
			const auto at = std::uniform_int_distribution<std::size_t>(0, text.size() - 1)(random);
			const auto cut = std::uniform_int_distribution<std::size_t>(0, 20)(random);
			text.replace(at, cut, tokens[random() % std::size(tokens)]);
		}
		const auto read = probe::parseProbe(text, "probe.json");
		if (!read)
		{
			++refused;
			EXPECT_TRUE(read.error().message.starts_with("probe.json: "));
			EXPECT_EQ(read.error().message.find('\n'), std::string::npos) << read.error().message;
			continue;
		}
		for (const probe::Sheet& sheet : placed(read->probe).sheets)
		{
			EXPECT_NEAR(glm::length(sheet.normal), 1.0, 1e-14);
			EXPECT_NEAR(glm::dot(sheet.normal, sheet.up), 0.0, 1e-14);
			for (const Vec3& row : worldToSheet(sheet).row)
				EXPECT_TRUE(std::isfinite(row.x + row.y + row.z)) << text;
		}
	}
	EXPECT_GT(refused, 1000);
	EXPECT_LT(refused, 2999);
}

TEST(ProbeFile, WithinALargerDocumentErrorsSayWhere)
{
	const auto read =
	    probe::probeFromJson(nlohmann::json::parse(R"({"sheets": [{"lines": -1}]})"), "state.json", "/probe");
	ASSERT_FALSE(read);
	EXPECT_EQ(read.error().message,
	          "state.json: /probe/sheets/0/lines: -1 is not a whole number from 0 to 1000; give one");
}

TEST(ProbeFile, ReadsFilesAndNamesThoseItCannot)
{
	const std::string folder = testing::TempDir();
	const std::string file = folder + "vprobe_probe_file_test.json";
	std::mt19937 random(63);
	const probe::Probe probe = randomProbe(random);
	std::ofstream(file) << probeText(probe);
	const auto read = probe::readProbe(file);
	ASSERT_TRUE(read) << read.error().message;
	EXPECT_EQ(read->probe, probe);
	std::remove(file.c_str());
	EXPECT_EQ(probe::readProbe(file).error().message, file + ": no such file; check the name");
	EXPECT_EQ(probe::readProbe(folder).error().message, folder + ": a folder; name a JSON file");
	EXPECT_EQ(probe::readProbe("/dev/zero").error().message,
	          "/dev/zero: larger than 16 MiB; name a JSON file that describes a probe or a path");
}

// Array names come from files in any encoding.
TEST(ProbeFile, NamesThatAreNoUtf8AreWrittenAllTheSame)
{
	probe::Probe probe{{probe::Sheet()}};
	probe.sheets[0].wishes.array = "Temp\xE9rature";
	const auto read = probe::parseProbe(probeText(probe), "probe.json");
	ASSERT_TRUE(read) << read.error().message;
	EXPECT_EQ(read->probe.sheets[0].wishes.array, "Temp\xEF\xBF\xBDrature");
}

TEST(ProbeFile, AFormIsReadAgainWhateverFxStandsBesideIt)
{
	probe::Probe probe;
	probe.sheets.push_back(probe::makeSheet(Vec3(0.0), Vec3(0.0, 0.0, 1.0)));
	probe.sheets[0].form = surface::ImplicitSurface::parse("x*x + y*y - z").value();
	probe.sheets[0].fx.magnification = 3.0;
	const Result<probe::ProbeFile> read = probe::parseProbe(probe::probeText(probe), "probe.json");
	ASSERT_TRUE(read) << read.error().message;
	EXPECT_EQ(read->probe.sheets[0].form, probe.sheets[0].form);
}

} // namespace vp::test
