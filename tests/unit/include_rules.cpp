// The rules of the house that a compiler does not check: which folder may include which, who may include Vulkan and
// VTK.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

// A folder may use only folders before it.
const std::vector<std::string> kFolders{"base",    "parts",  "grid",    "cases",   "read",   "surface", "refine",
                                        "probe",   "locate", "seed",    "find",    "mesh",   "gpu",     "classify",
                                        "measure", "cut",    "contour", "vectors", "render", "write",   "interact",
                                        "view",    "ranks",  "session", "picture", "api"};

// Rooms inside a folder, in the order in which they may use each other; "" are the files of the folder itself.
struct Rooms
{
	std::string top; // from where its headers are included
	std::string folder;
	std::vector<std::string> order;
};
const std::vector<Rooms> kInnerRooms{
    {"engine", "grid", {"", "curved", "link", "check", "demo"}},
    {"engine", "ranks", {"", "data", "join", "search", "particles", "picture", "write"}},
    {"engine", "render", {"font", "color", "scene", "annotate", "passes", "flat", ""}},
    {"apps/vprobe", "viewer", {"screen", "cutting", "document", "pointer", "panels", ""}},
    {"apps",
     "vprobe-read",
     {"base", "door", "text", "checks", "arrays", "quick", "hdf5", "cells", "convert", "manifest", "boxes", "formats",
      "formats/vtk", "formats/wrapped", "formats/volumes", "formats/meshes", "formats/codes", ""}}};

const fs::path kRoot = VPROBE_SOURCE_DIR;

struct Include
{
	fs::path file; // from the root
	std::string header;

	std::string folder() const { return std::next(file.begin())->string(); } // a folder of engine/
	std::string where() const { return file.string() + " includes " + header; }
};

std::string textOf(const fs::path& file)
{
	std::ostringstream text;
	text << std::ifstream(file, std::ios::binary).rdbuf();
	return text.str();
}

std::vector<fs::path> filesUnder(const std::string& room)
{
	std::vector<fs::path> files;
	for (const auto& entry : fs::recursive_directory_iterator(kRoot / room))
		if (entry.is_regular_file())
			files.push_back(fs::relative(entry.path(), kRoot));
	return files;
}

std::vector<Include> includesUnder(const std::string& room)
{
	static const std::regex kInclude(R"re((?:^|\n)[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">])re");
	static const std::set<std::string> kEndings{".cpp", ".h", ".inl"};
	std::vector<Include> includes;
	for (const fs::path& file : filesUnder(room))
	{
		if (!kEndings.contains(file.extension()))
			continue;
		const std::string text = textOf(kRoot / file);
		for (std::sregex_iterator i(text.begin(), text.end(), kInclude), end; i != end; ++i)
			includes.push_back({file, (*i)[1]});
	}
	return includes;
}

std::ptrdiff_t place(const std::string& folder)
{
	return std::find(kFolders.begin(), kFolders.end(), folder) - kFolders.begin();
}

bool isVulkan(const std::string& header)
{
	return header.starts_with("vulkan/") || header == "gpu/vulkan.h";
}

TEST(IncludeRules, EngineUsesOnlyFoldersAbove)
{
	const auto includes = includesUnder("engine");
	ASSERT_FALSE(includes.empty());
	for (const Include& include : includes)
	{
		ASSERT_LT(place(include.folder()), std::ssize(kFolders))
		    << include.file << ": a folder the design does not know";
		const std::string used = include.header.substr(0, include.header.find('/'));
		if (place(used) < std::ssize(kFolders))
		{
			EXPECT_LE(place(used), place(include.folder())) << include.where();
		}
		EXPECT_NE(used, "..") << include.where();
		EXPECT_NE(used, "apps") << include.where();
	}
}

TEST(IncludeRules, RoomsInsideAFolderUseOnlyRoomsBefore)
{
	for (const Rooms& inner : kInnerRooms)
	{
		const auto placeOf = [&](const fs::path& path)
		{
			const std::string room = path.parent_path().lexically_relative(inner.folder).string();
			return std::ranges::find(inner.order, room == "." ? "" : room) - inner.order.begin();
		};
		const auto includes = includesUnder(inner.top + "/" + inner.folder);
		ASSERT_FALSE(includes.empty());
		for (const Include& include : includes)
		{
			const auto place = placeOf(include.file.lexically_relative(inner.top));
			ASSERT_LT(place, std::ssize(inner.order)) << include.file << ": a room the design does not know";
			if (include.header.starts_with(inner.folder + "/"))
			{
				EXPECT_LE(placeOf(include.header), place) << include.where();
			}
		}
	}
}

TEST(IncludeRules, LibrariesStandInTheSameOrder)
{
	const std::string lists = textOf(kRoot / "engine/CMakeLists.txt");
	const std::regex library(R"((?:^|\n)engine_library\((\w+))");
	std::ptrdiff_t last = -1;
	for (std::sregex_iterator i(lists.begin(), lists.end(), library), end; i != end; ++i)
	{
		const std::string folder = (*i)[1];
		ASSERT_LT(place(folder), std::ssize(kFolders)) << folder << ": a folder the design does not know";
		EXPECT_LT(last, place(folder)) << folder << " stands too low";
		last = place(folder);
	}
	EXPECT_GE(last, 0);
}

// A library uses exactly the rooms that its files include, except for those that another included room brings along.
TEST(IncludeRules, LibrariesUseWhatTheirFilesInclude)
{
	const std::string lists = textOf(kRoot / "engine/CMakeLists.txt");
	const std::regex library(R"((?:^|\n)engine_library\((\w+)(?: USES((?: [a-z]+)+))?)");
	const std::vector<Include> includes = includesUnder("engine");
	std::map<std::string, std::set<std::string>> reached; // by each library: itself, and all that it can include
	for (std::sregex_iterator i(lists.begin(), lists.end(), library), end; i != end; ++i)
	{
		const std::string folder = (*i)[1];
		std::set<std::string> included;
		for (const Include& include : includes)
			if (const std::string used = include.header.substr(0, include.header.find('/'));
			    include.folder() == folder && reached.contains(used))
				included.insert(used);
		std::set<std::string> needed = included;
		for (const std::string& used : included)
			for (const std::string& brought : reached[used])
				if (brought != used)
					needed.erase(brought);
		std::istringstream words((*i)[2]);
		const std::set<std::string> uses(std::istream_iterator<std::string>(words), {});
		EXPECT_EQ(uses, needed) << folder;
		std::set<std::string>& all = reached[folder];
		for (const std::string& used : uses)
			all.insert(reached[used].begin(), reached[used].end());
		all.insert(folder);
	}
	EXPECT_FALSE(reached.empty());
}

TEST(IncludeRules, VulkanStaysInItsRooms)
{
	for (const char* room : {"engine", "apps"})
		for (const Include& include : includesUnder(room))
			if (isVulkan(include.header))
			{
				const bool at_home =
				    std::string(room) == "engine" && (include.folder() == "gpu" || include.folder() == "render");
				const std::string name = include.file.filename().string();
				const bool is_its_face = include.folder() == "api" && name == "vulkan.h";
				EXPECT_TRUE(at_home || is_its_face || name.starts_with("gpu_")) << include.where();
			}
}

// A reader that crashes must not take the program with it.
TEST(IncludeRules, ReadersStayInTheChildProcess)
{
	static const std::regex kReader("vtk\\w*Reader\\.h");
	for (const char* room : {"engine", "apps"})
		for (const Include& include : includesUnder(room))
			if (std::regex_match(include.header, kReader))
			{
				EXPECT_TRUE(include.file.string().starts_with("apps/vprobe-read/")) << include.where();
			}
}

// Each folder of the reader is a namespace. A source file that defines what another folder declares is in vp::reader,
// as are the names of base and the list of formats.
TEST(IncludeRules, EachFolderOfTheReaderIsANamespace)
{
	std::size_t files = 0;
	for (const fs::path& file : filesUnder("apps/vprobe-read"))
	{
		const bool is_header = file.extension() == ".h";
		const std::string folder = file.parent_path().filename().string();
		if ((!is_header && file.extension() != ".cpp") || folder == "vprobe-read")
			continue;
		++files;
		const std::string text = textOf(kRoot / file);
		const auto opens = [&](const std::string& name)
		{ return text.find("\nnamespace " + name + "\n{") != std::string::npos; };
		const bool may_be_outside = folder == "base" || !is_header || file.filename() == "formats.h";
		EXPECT_TRUE(opens("vp::reader::" + folder) || (may_be_outside && opens("vp::reader"))) << file;
		EXPECT_EQ(text.find("using namespace"), std::string::npos) << file;
	}
	EXPECT_GT(files, 300u);
}

// The engine is a library: its messages name settings by their keys, and it neither ends a program nor prints.
TEST(IncludeRules, TheEngineDoesNotKnowItsProgram)
{
	static const std::regex kOption("\"[^\"\n]*--[a-z][^\"\n]*\"");
	static const std::regex kProgram("std::(abort|exit|terminate|quick_exit|cout|cerr)\\b|\\bstderr\\b|\\bExitCode\\b");
	for (const fs::path& file : filesUnder("engine"))
	{
		if (file.extension() != ".cpp" && file.extension() != ".h" && file.extension() != ".inl")
			continue;
		std::istringstream lines(textOf(kRoot / file));
		for (std::string line; std::getline(lines, line);)
		{
			if (line.find_first_not_of(" \t") != std::string::npos &&
			    line.substr(line.find_first_not_of(" \t")).starts_with("//"))
				continue;
			EXPECT_FALSE(std::regex_search(line, kOption)) << file << " names an option: " << line;
			EXPECT_FALSE(std::regex_search(line, kProgram)) << file << " knows its program: " << line;
		}
	}
}

// A file must make sense to a reader who has nothing but the repository.
TEST(IncludeRules, FilesSpeakForThemselves)
{
	// In pieces, as this file is looked through too.
	const std::string words[] = {std::string("/wo") + "rk/", std::string("issue ") + "#",
	                             std::string("session of ") + "a developer"};
	for (const char* room : {".ci", "apps", "docs", "engine", "shaders", "tests"})
	{
		if (!fs::exists(kRoot / room))
			continue;
		for (const fs::path& file : filesUnder(room))
		{
			const std::string text = textOf(kRoot / file);
			if (text.find('\0') != std::string::npos)
				continue;
			for (const std::string& word : words)
				EXPECT_EQ(text.find(word), std::string::npos) << file << " mentions " << word;
		}
	}
	for (const char* name : {"README.md", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json"})
		for (const std::string& word : words)
			EXPECT_EQ(textOf(kRoot / name).find(word), std::string::npos) << name << " mentions " << word;
}

} // namespace
