// Probes and paths in docs/ can be read as the text says.

#include "probe/path_file.h"
#include "probe/probe_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace vp::test
{

namespace
{

using nlohmann::json;

std::string docs(const std::string& name)
{
	std::ostringstream text;
	text << std::ifstream(VPROBE_SOURCE_DIR "/docs/" + name).rdbuf();
	return text.str();
}

json schema(const std::string& name)
{
	return json::parse(docs(name));
}

std::vector<std::string> examples(const std::string& text)
{
	static const std::regex kBlock("```json\n([^`]*)```");
	std::vector<std::string> found;
	for (std::sregex_iterator i(text.begin(), text.end(), kBlock), end; i != end; ++i)
		found.push_back((*i)[1]);
	return found;
}

std::set<std::string> keysOf(const json& object)
{
	std::set<std::string> keys;
	for (const auto& [key, value] : object.at("properties").items())
		keys.insert(key);
	return keys;
}

// The keys that an error of an unknown one lists.
template <class Read>
std::set<std::string> keysRead(const std::string& text, Read&& read)
{
	const auto result = read(text, "file");
	if (result)
		return {};
	const std::string message = result.error().message;
	const std::string start = "the keys here are ";
	const std::size_t at = message.find(start);
	EXPECT_NE(at, std::string::npos) << message;
	std::set<std::string> keys;
	std::istringstream words(std::regex_replace(message.substr(at + start.size()), std::regex(", "), "\n"));
	for (std::string key; std::getline(words, key);)
		keys.insert(key);
	return keys;
}

} // namespace

TEST(ProbeDocs, TheirExamplesAreRead)
{
	int probes = 0;
	int paths = 0;
	for (const std::string& example : examples(docs("PROBES.md")))
		if (json::parse(example).contains("sheets"))
		{
			const auto probe = probe::parseProbe(example, "PROBES.md");
			EXPECT_TRUE(probe) << probe.error().message;
			++probes;
		}
		else
		{
			const auto path = probe::parsePath(example, "PROBES.md");
			EXPECT_TRUE(path) << path.error().message;
			++paths;
		}
	EXPECT_EQ(probes, 1);
	EXPECT_EQ(paths, 2);
}

TEST(ProbeDocs, TheProbesSchemaHasTheKeysThatAreRead)
{
	const json document = schema("probe.schema.json");
	const json& sheet = document.at("definitions").at("sheet");
	const auto read = [](const std::string& text, const char* source) { return probe::parseProbe(text, source); };
	EXPECT_EQ(keysOf(document), keysRead(R"({"?": 1})", read));
	EXPECT_EQ(keysOf(sheet), keysRead(R"({"sheets": [{"?": 1}]})", read));
	EXPECT_EQ(keysOf(sheet.at("properties").at("fx")), keysRead(R"({"sheets": [{"fx": {"?": 1}}]})", read));
	EXPECT_EQ(keysOf(sheet.at("properties").at("window").at("oneOf").at(1)),
	          keysRead(R"({"sheets": [{"window": {"?": 1}}]})", read));
	std::set<std::string> frame = keysOf(document.at("definitions").at("frame").at("oneOf").at(0));
	frame.insert("matrix");
	EXPECT_EQ(frame, keysRead(R"({"to_probe": {"?": 1}})", read));
	EXPECT_EQ(document.at("properties").at("sheets").at("maxItems"), probe::kMaxSheets);
	EXPECT_EQ(sheet.at("properties").at("lines").at("maximum"), probe::kMaxLines);
	EXPECT_EQ(sheet.at("properties").at("fx").at("properties").at("magnification").at("minimum"),
	          probe::kMinMagnification);
	EXPECT_EQ(sheet.at("properties").at("fx").at("properties").at("magnification").at("maximum"),
	          probe::kMaxMagnification);
}

TEST(ProbeDocs, ThePathsSchemaHasTheKeysThatAreRead)
{
	const json document = schema("path.schema.json");
	const auto read = [](const std::string& text, const char* source) { return probe::parsePath(text, source); };
	std::set<std::string> kinds;
	for (const json& kind : document.at("oneOf"))
	{
		const std::string name = kind.at("properties").at("path").at("const");
		kinds.insert(name);
		EXPECT_EQ(keysOf(kind), keysRead(R"({"path": ")" + name + R"(", "?": 1})", read)) << name;
		if (name == "keyframes")
		{
			const json& keys = kind.at("properties").at("keys");
			EXPECT_EQ(keysOf(keys.at("items")), keysRead(R"({"path": "keyframes", "keys": [{"?": 1}, {}]})", read));
			EXPECT_EQ(keys.at("maxItems"), probe::kMaxKeys);
		}
	}
	EXPECT_EQ(kinds.size(), 6u);
	for (const std::string& kind : kinds)
		EXPECT_TRUE(probe::pathKind(kind)) << kind;
	EXPECT_EQ(document.at("definitions").at("length").at("maximum"), probe::kMaxFrames);
}

} // namespace vp::test
