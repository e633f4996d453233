#include "program.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>

namespace cli
{

namespace
{

class View : public Program
{
protected:
	// A machine without a display, and without a device either: what is refused is refused before both.
	static Surroundings nowhere()
	{
		Surroundings all = noDevice();
		all.environment["DISPLAY"] = "";
		all.environment["WAYLAND_DISPLAY"] = "";
		return all;
	}
};

// Programs are built beside this one.
std::filesystem::path builtProgram(const char* name)
{
	return std::filesystem::read_symlink("/proc/self/exe").replace_filename(name);
}

struct BindingRow
{
	std::string keys, name, words;
};

// Parses the rows of --list-bindings, which has at least two spaces between columns.
std::vector<BindingRow> bindingRows(const std::string& list)
{
	std::vector<BindingRow> rows;
	std::istringstream text(list);
	for (std::string line; std::getline(text, line);)
	{
		if (!line.starts_with("  "))
			continue;
		std::vector<std::string> cells;
		for (std::size_t at = 2; at < line.size();)
		{
			const std::size_t end = std::min(line.find("  ", at), line.size());
			cells.push_back(line.substr(at, end - at));
			at = std::min(line.find_first_not_of(' ', end), line.size());
		}
		EXPECT_EQ(cells.size(), 3u) << line;
		if (cells.size() == 3)
			rows.push_back({cells[0], cells[1], cells[2]});
	}
	return rows;
}

} // namespace

TEST_F(View, ListsItsKeysWithoutAWindow)
{
	const Outcome outcome = run({"view", "--list-bindings"}, nowhere());
	EXPECT_TRUE(isQuiet(outcome));
	EXPECT_GT(bindingRows(outcome.out).size(), 50u);
}

TEST_F(View, TheManualListsEveryKey)
{
	const std::string manual = contents(VPROBE_SOURCE_DIR "/docs/VIEWER.md");
	const std::vector<BindingRow> rows = bindingRows(run({"view", "--list-bindings"}).out);
	const std::regex row_of_keys("\n\\| [^|`]+ \\| `[a-z0-9_]+` \\| ");
	const std::sregex_iterator found(manual.begin(), manual.end(), row_of_keys);
	EXPECT_EQ(std::distance(found, std::sregex_iterator()), static_cast<std::ptrdiff_t>(rows.size()));
	for (const BindingRow& row : rows)
	{
		const std::string line = "| " + row.keys + " | `" + row.name + "` | " + row.words + " |\n";
		EXPECT_TRUE(contains(manual, line)) << "docs/VIEWER.md lacks: " << line;
	}
}

TEST_F(View, WithoutADisplayItSaysSo)
{
	EXPECT_TRUE(isError(run({"view", "demo:shell:8"}, nowhere()), 3, {"DISPLAY", "vprobe render"}));
	EXPECT_TRUE(isError(run({"view"}, nowhere()), 3, {"DISPLAY"}));
}

// As where the package of the window is not installed.
TEST_F(View, WhereTheWindowIsNotInstalledItSaysSo)
{
	std::filesystem::copy_file(builtProgram("vprobe"), path("vprobe"));
	Surroundings alone = nowhere();
	alone.environment["VPROBE_PROGRAM"] = path("vprobe");
	for (const Arguments& asked : {Arguments{"view"}, Arguments{"view", "demo:shell:8"}})
	{
		EXPECT_TRUE(isError(run(asked, alone), 3, {"install", "vprobe-view", "vprobe render"}));
	}
	Surroundings desktop = alone;
	desktop.environment["DISPLAY"] = ":7";
	EXPECT_TRUE(isError(run({"demo:shell:8"}, desktop), 3, {"vprobe-view"}));
	// All that needs no window is there, and so are errors of the command line.
	EXPECT_TRUE(contains(run({"view", "--help"}, alone).out, "--commands"));
	for (const char* asked : {"--help", "--list-bindings"})
	{
		EXPECT_TRUE(run({"view", asked}, alone).out == run({"view", asked}).out) << asked;
	}
	EXPECT_TRUE(isError(run({"view", "demo:shell:8", "--camera", "askew"}, alone), 1, {"--camera"}));
	EXPECT_TRUE(isQuiet(run({"slice", "demo:shell:8", "-o", path("cut.vtp")}, alone)));
}

// As packages install it.
TEST_F(View, TheWindowIsFoundInTheFolderOfPrivatePrograms)
{
	std::filesystem::create_directories(path("bin"));
	std::filesystem::create_directories(path("libexec/vprobe"));
	std::filesystem::copy_file(builtProgram("vprobe"), path("bin/vprobe"));
	std::filesystem::copy_file(builtProgram("vprobe-view"), path("libexec/vprobe/vprobe-view"));
	Surroundings installed = nowhere();
	installed.environment["VPROBE_PROGRAM"] = path("bin/vprobe");
	EXPECT_TRUE(isError(run({"view", "demo:shell:8"}, installed), 3, {"DISPLAY"}));
}

// The window's program takes the place of vprobe in the same process: what the caller set up stays as it is.
TEST_F(View, TheWindowHasTheStreamsOfItsCaller)
{
	Surroundings closed = nowhere();
	closed.closed = {0};
	EXPECT_TRUE(isError(run({"view", "demo:shell:8"}, closed), 3, {"vprobe: no window", "DISPLAY"}));
}

TEST_F(View, WrongOptionsAreToldBeforeAWindowOpens)
{
	EXPECT_TRUE(isError(run({"view", "demo:shell:8", "--camera", "askew"}, nowhere()), 1, {"--camera"}));
	EXPECT_TRUE(isError(run({"view", "demo:shell:8", "--colormap", "mud"}, nowhere()), 1, {"mud"}));
	EXPECT_TRUE(isError(run({"view", "demo:shell:8", "--normal", "0 0 0"}, nowhere()), 1, {"--normal"}));
	EXPECT_TRUE(isError(run({"view", "demo:shell:8", "--size", "none"}, nowhere()), 1, {"--size"}));
	EXPECT_TRUE(isError(run({"view", "demo:shell:8", "--unheard-of"}, nowhere()), 1, {"vprobe view --help"}));
	EXPECT_TRUE(isError(run({"view", "--state", path("none.json")}, nowhere()), 2, {"none.json"}));
	EXPECT_TRUE(isError(run({"view", "--commands", path("none")}, nowhere()), 2, {"--commands", "FIFO"}));
	EXPECT_TRUE(files().empty());
}

} // namespace cli
