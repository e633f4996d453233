#include "probe/path_file.h"

#include "random_probes.h"

namespace vp::test
{

using probe::Path;
using probe::PathKind;

namespace
{

Path randomPath(PathKind kind, std::mt19937& random)
{
	std::bernoulli_distribution coin;
	Path path;
	path.kind = kind;
	path.unit = coin(random) ? probe::TimeUnit::seconds : probe::TimeUnit::frames;
	path.there_and_back = coin(random);
	if (kind == PathKind::translate || kind == PathKind::rotate)
		path.axis = randomDirection(random);
	if (kind == PathKind::rotate && coin(random))
		path.through = randomPoint({Vec3(-9.0), Vec3(9.0)}, random);
	if (kind == PathKind::rotate || kind == PathKind::spin)
		path.degrees = between(-720.0, 720.0, random);
	if (kind == PathKind::revolve && coin(random))
		path.vanes = 7;
	if (kind != PathKind::keyframes)
	{
		path.length = between(1.0, 500.0, random);
		return path;
	}
	path.loop = !path.there_and_back;
	for (int k = 0; k < 4; ++k)
		path.keys.push_back({k + between(0.0, 0.9, random), randomFrame(random)});
	if (path.loop)
		path.length = 4.5;
	return path;
}

std::string keyframes(const std::string& keys, const std::string& more = "")
{
	return R"({"path": "keyframes", "keys": [)" + keys + "]" + more + "}";
}

} // namespace

TEST(PathFile, ReadAgainItIsTheSameToTheLastBit)
{
	std::mt19937 random(71);
	for (int i = 0; i < 200; ++i)
	{
		const Path path = randomPath(static_cast<PathKind>(i % 6), random);
		const auto read = probe::parsePath(pathText(path), "path.json");
		ASSERT_TRUE(read) << read.error().message;
		EXPECT_EQ(*read, path);
	}
}

TEST(PathFile, KnowsThePathsByName)
{
	for (const char* name : {"translate", "rotate", "spin", "revolve", "profile", "keyframes"})
	{
		ASSERT_TRUE(probe::pathKind(name)) << name;
		EXPECT_EQ(nameOf(*probe::pathKind(name)), name);
	}
	EXPECT_FALSE(probe::pathKind("wander"));
	EXPECT_EQ(probe::pathKind("spin"), PathKind::spin);
}

TEST(PathFile, SaysWhereAndWhatIsWrong)
{
	const std::string two = R"({"at": 0, "to_probe": {}}, {"at": 5, "to_probe": {}})";
	const std::vector<std::pair<std::string, std::string>> table{
	    {"3", "the document: 3 where an object with path belongs"},
	    {"{}", "the document: \"path\" is missing; add it"},
	    {R"({"path": "wander"})",
	     "/path: no path of this name; use translate, rotate, spin, revolve, profile, keyframes"},
	    {R"({"path": "spin", "axis": [0, 0, 1]})",
	     "/axis: unknown key; the keys here are $schema, path, there_and_back, unit, length, degrees"},
	    {R"({"path": "rotate", "axis": [0, 0, 0]})",
	     "/axis: a zero vector is no direction; give three numbers that are not all zero"},
	    {R"({"path": "rotate", "through": [0, 0]})", "/through: an array of 2 where 3 numbers belong"},
	    {R"({"path": "revolve", "vanes": 0})", "/vanes: 0 is not a whole number from 1 to 64; give one"},
	    {R"({"path": "spin", "unit": "hours"})", "/unit: no unit of time; use \"frames\" or \"seconds\""},
	    {R"({"path": "spin", "length": 0})", "/length: 0 is not above 0 and up to 1000000; give a length that is"},
	    {R"({"path": "spin", "length": 1e7})",
	     "/length: 10000000 is not above 0 and up to 1000000; give a length that is"},
	    {R"({"path": "spin", "degrees": 1e999})", "/degrees: a number that is not finite; give one that is"},
	    {R"({"path": "keyframes"})", "the document: \"keys\" is missing; add it"},
	    {keyframes(R"({"at": 0, "to_probe": {}})"), "/keys: an array of 1 where 2 to 10000 keys belong"},
	    {keyframes(two + R"(, {"at": 5, "to_probe": {}})"),
	     "/keys/2/at: 5 does not come after 5; put the keys in order of time"},
	    {keyframes(two + R"(, {"to_probe": {}})"), "/keys/2: \"at\" is missing; add it"},
	    {keyframes(two + R"(, {"at": 2e6, "to_probe": {}})"),
	     "/keys/2/at: 2000000 is more than 1000000 after the first key; give an earlier time"},
	    {keyframes(R"({"at": 0, "to_probe": {"normal": [0, 0, 0]}}, {"at": 5, "to_probe": {}})"),
	     "/keys/0/to_probe/normal: a zero vector is no direction; give three numbers that are not all zero"},
	    {keyframes(two, R"(, "length": 9)"),
	     "/length: the keys say how long the path is; remove it, or add \"loop\": true"},
	    {keyframes(two, R"(, "loop": true)"), "the document: \"length\" is missing; add it"},
	    {keyframes(two, R"(, "loop": true, "length": 5)"),
	     "/length: 5 leaves no time to return to the first key; give more than the 5 the keys take"},
	    {keyframes(two, R"(, "loop": true, "there_and_back": true)"),
	     "/loop: there_and_back is a loop by itself; remove one of the two"}};
	for (const auto& [text, message] : table)
	{
		const auto read = probe::parsePath(text, "path.json");
		ASSERT_FALSE(read) << text;
		EXPECT_EQ(read.error().message, "path.json: " + message) << text;
		EXPECT_EQ(read.error().kind, ErrorKind::input);
	}
}

} // namespace vp::test
