// verify and slice --expect where figures are compared. Pictures are in drawn_verify_test.cpp.

#include "program.h"

#include <filesystem>

namespace cli
{

namespace
{

using nlohmann::json;

const Arguments kShell{"demo:shell:8", "--normal", "0.3", "0.5", "0.8"};

class Verify : public Program
{
protected:
	// A state with its figures, which need no device.
	void saveFigures(const std::string& name, const Arguments& options, const json& expected = {}) const
	{
		const Outcome cut = run(Arguments{"slice"} + options +
		                        Arguments{"--classify", "cpu", "--stats", "-", "--save", path(name + ".json")});
		ASSERT_EQ(cut.status, 0) << cut.err;
		const json sheet = cut.json()["sheets"][0];
		json figures = {{"sheets", {{{"area", sheet["area"]}, {"polygons", sheet["polygons"]}}}}};
		if (!expected.is_null())
			figures.update(expected);
		write(name + ".figures.json", figures.dump());
	}
	Outcome verify(const Arguments& arguments) const { return run(Arguments{"verify"} + arguments); }
};

std::size_t timesFound(const std::string& text, const std::string& part)
{
	std::size_t found = 0;
	for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
		++found;
	return found;
}

} // namespace

TEST_F(Verify, FiguresAsExpected)
{
	saveFigures("a", kShell);
	const Outcome outcome = verify({path("a.json")});
	EXPECT_EQ(outcome.status, 0);
	EXPECT_EQ(outcome.err, "");
	EXPECT_TRUE(contains(outcome.out, "passed  " + path("a.figures.json") + "  [cpu]\n")) << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "1 passed; vprobe ")) << outcome.out;
}

TEST_F(Verify, FiguresThatMovedAreExitCode6AndUpdateWritesThem)
{
	saveFigures("a", kShell, {{"grid", {{"cells", 511}}}, {"tolerance", {{"relative", 1e-3}}}});
	saveFigures("b", kShell);
	Outcome outcome = verify({path("")});
	EXPECT_EQ(outcome.status, 6) << outcome.err;
	EXPECT_TRUE(
	    contains(outcome.out, "differs  " + path("a.figures.json") + "  grid/cells is 512, expected 511  [cpu]\n"))
	    << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "1 passed, 1 different")) << outcome.out;

	outcome = verify({"--update", path("")});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	EXPECT_TRUE(contains(outcome.out, "updated  " + path("a.figures.json"))) << outcome.out;
	const json updated = json::parse(contents(path("a.figures.json")));
	EXPECT_EQ(updated["grid"], (json{{"cells", 512}})); // no other keys
	EXPECT_EQ(updated["tolerance"], (json{{"relative", 1e-3}}));
	EXPECT_EQ(verify({path("")}).status, 0);
}

// The area of the plane x = 0 through half a spherical shell with radii of 1 and 3 is known: half a ring, cut to the
// program's polygons.
TEST_F(Verify, ToleranceIsThatOfTheFile)
{
	const double ring = 3.14159265358979 * (3.0 * 3.0 - 1.0) / 2.0;
	const auto with = [&](const json& tolerance)
	{
		saveFigures("a", {"demo:shell:8", "--normal", "x"},
		            {{"sheets", {{{"area", ring}, {"polygons", 60}}}}, {"tolerance", tolerance}});
		return verify({path("a.json")});
	};
	const json count_may = {{"polygons", {{"absolute", 4}}}};
	EXPECT_EQ(with({{"relative", 0.2}, {"keys", count_may}}).status, 0);
	EXPECT_EQ(with({{"relative", 0.01}, {"keys", count_may}}).status, 6);
	EXPECT_EQ(with({{"relative", 0.2}}).status, 6); // counts are equal, unless their key has a tolerance
	const Outcome unknown = with({{"relatve", 0.2}});
	EXPECT_EQ(unknown.status, 2);
	EXPECT_TRUE(contains(unknown.err, "a.figures.json: /tolerance/relatve: unknown key")) << unknown.err;
	const Outcome negative = with({{"relative", -1}});
	EXPECT_EQ(negative.status, 2);
	EXPECT_TRUE(contains(negative.err, "a.figures.json: /tolerance/relative: a tolerance is")) << negative.err;
}

TEST_F(Verify, ABrokenCaseDoesNotStopTheOthersAndItsCodeComesFirst)
{
	saveFigures("b", kShell, {{"sheets", {{{"polygons", 1}}}}});
	saveFigures("d", kShell);
	write("a.json", "{\"version\": 1, \"inpt\": {}}");
	write("c.json", "{\"version\": 1, \"input\": {\"files\": [\"none.vtu\"]}}");
	write("c.figures.json", "{}");
	write("preset.json", "{\"RGBPoints\": []}"); // not a state
	const Outcome outcome = verify({path("")});
	EXPECT_EQ(outcome.status, 2);
	EXPECT_TRUE(contains(outcome.err, "vprobe: " + path("a.json") + ": ")) << outcome.err;
	EXPECT_TRUE(contains(outcome.err, "none.vtu")) << outcome.err;
	EXPECT_EQ(timesFound(outcome.err, "\n"), 2u) << outcome.err;
	EXPECT_TRUE(contains(outcome.out, "differs  " + path("b.figures.json"))) << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "passed  " + path("d.figures.json"))) << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "1 passed, 1 different, 2 not judged")) << outcome.out;
}

TEST_F(Verify, NothingToCompareIsAnError)
{
	std::filesystem::create_directory(path("empty"));
	Outcome outcome = verify({path("empty")});
	EXPECT_EQ(outcome.status, 2);
	EXPECT_TRUE(contains(outcome.err, "empty: holds no state; write one with vprobe render INPUT --save"))
	    << outcome.err;
	saveFigures("a", kShell);
	std::filesystem::remove(path("a.figures.json"));
	outcome = verify({path("a.json")});
	EXPECT_EQ(outcome.status, 2);
	EXPECT_TRUE(contains(outcome.err, "a.json: nothing is expected of it; --update writes")) << outcome.err;
	outcome = verify({path("none.json")});
	EXPECT_EQ(outcome.status, 2);
	EXPECT_TRUE(contains(outcome.err, "none.json")) << outcome.err;
}

TEST_F(Verify, WithoutADeviceFiguresAreJudged)
{
	saveFigures("a", kShell);
	write("a.png", "a picture");
	const Outcome outcome = run({"verify", path("a.json")}, noDevice());
	EXPECT_EQ(outcome.status, 3) << outcome.err;
	EXPECT_TRUE(contains(outcome.err, path("a.png") + ": ")) << outcome.err;
	EXPECT_TRUE(contains(outcome.out, "passed  " + path("a.figures.json"))) << outcome.out;
}

TEST_F(Verify, JunitHoldsEachVerdict)
{
	saveFigures("a", kShell);
	saveFigures("b", kShell, {{"sheets", {{{"polygons", 1}}}}});
	write("c.json", "{\"version\": 1, \"look\": \"<&>\"}");
	EXPECT_EQ(verify({path(""), "--junit", path("out/junit.xml")}).status, 2);
	const std::string xml = contents(path("out/junit.xml"));
	EXPECT_TRUE(xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites ")) << xml;
	EXPECT_TRUE(contains(xml, "tests=\"3\" failures=\"1\" errors=\"1\"")) << xml;
	EXPECT_EQ(timesFound(xml, "<testcase classname=\""), 3u);
	EXPECT_TRUE(contains(xml, "<failure message=\"sheets/0/polygons is ")) << xml;
	EXPECT_TRUE(contains(xml, "<error message=\"")) << xml;
	EXPECT_TRUE(contains(xml, " name=\"a.figures.json\"")) << xml;
	EXPECT_FALSE(contains(xml, "<&>")) << xml;
	EXPECT_TRUE(xml.ends_with("</testsuite>\n</testsuites>\n")) << xml;
	EXPECT_EQ(verify({path("a.json"), "--junit", path("a.json")}).status, 4); // not over an input
}

TEST_F(Verify, SliceExpect)
{
	const Arguments slice = Arguments{"slice"} + kShell + Arguments{"--classify", "cpu"};
	const std::string good = write("good.json", "{\"grid\": {\"cells\": 512}}");
	EXPECT_TRUE(isQuiet(run(slice + Arguments{"--expect", good})));
	const std::string bad = write("bad.json", "{\"grid\": {\"cells\": 513}, \"paint\": 1}");
	EXPECT_TRUE(
	    isError(run(slice + Arguments{"--expect", bad}), 6, {"bad.json: grid/cells is 512, expected 513, and 1 more"}));
	EXPECT_TRUE(isError(run(slice + Arguments{"--expect", path("none.json")}), 2, {"none.json"}));
	EXPECT_TRUE(
	    isError(run(slice + Arguments{"--expect", write("list.json", "[]")}), 2, {"list.json: holds no figures"}));
}

} // namespace cli
