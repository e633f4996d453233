#include "program.h"
#include "sample_files.h"

#include <sys/stat.h>

#include <cstdlib>
#include <random>

namespace cli
{

namespace
{

class Input : public Program
{
protected:
	// No command makes anything of such an input, and says so in one line with these words.
	void expectRefused(const std::string& input, const std::vector<std::string>& words,
	                   const Arguments& more = {}) const
	{
		const std::string output = path("out.vtp");
		const std::string picture = path("out.png");
		EXPECT_TRUE(isError(run(Arguments{"info", input}), 2, words)) << "info " << input;
		EXPECT_TRUE(isError(
		    run(Arguments{"slice", input, "--classify", "cpu", "-o", output, "--stats", path("out.json")} + more), 2,
		    words))
		    << "slice " << input;
		EXPECT_FALSE(std::filesystem::exists(output));
		EXPECT_FALSE(std::filesystem::exists(path("out.json")));
	}
};

std::string noise(std::size_t bytes)
{
	std::mt19937 random(1);
	std::string text(bytes, '\0');
	for (char& c : text)
		c = static_cast<char>(random());
	return text;
}

const Arguments kEndings{"vtk", "vti", "vtr", "vts", "vtu", "vtm", "mhd", "ex2", "xyz"};

} // namespace

TEST_F(Input, Missing)
{
	for (const std::string& ending : kEndings)
		expectRefused(path("absent." + ending), {"absent." + ending});
}

TEST_F(Input, Empty)
{
	for (const std::string& ending : kEndings)
		expectRefused(write("empty." + ending, ""), {"empty." + ending});
}

TEST_F(Input, Noise)
{
	for (const std::string& ending : kEndings)
		expectRefused(write("noise." + ending, noise(5000)), {"noise." + ending});
}

TEST_F(Input, Prose)
{
	for (const std::string& ending : kEndings)
		expectRefused(write("prose." + ending, "It was a dark and stormy night.\nThe rain fell in torrents.\n"),
		              {"prose." + ending});
}

TEST_F(Input, UnknownEnding)
{
	for (const std::string name : {"prose.txt", "prose"})
		expectRefused(write(name, "It was a dark and stormy night.\nThe rain fell in torrents.\n"),
		              {name, "vprobe info --formats"});
}

// The contents tell what a file is, its name only where they do not.
TEST_F(Input, WrongEnding)
{
	for (const auto& [name, whole] : {std::pair{"image.txt", legacyImage()}, std::pair{"image.vtu", xmlImage()},
	                                  std::pair{"cells.vti", xmlHexahedra()}})
	{
		const Outcome outcome = run({"info", write(name, whole)});
		EXPECT_TRUE(outcome.status == 0 ? isQuiet(outcome) : isError(outcome, 2, {name}));
	}
}

TEST_F(Input, Folder)
{
	std::filesystem::create_directory(path("folder.vtu"));
	expectRefused(path("folder.vtu"), {"folder.vtu"});
	expectRefused(path(""), {path("")});
}

TEST_F(Input, NotAFile)
{
	mkfifo(path("pipe.vtu").c_str(), 0666);
	expectRefused(path("pipe.vtu"), {"pipe.vtu"});
	expectRefused("/dev/null", {"/dev/null"});
}

TEST_F(Input, Truncated)
{
	const std::pair<std::string, std::string> samples[] = {
	    {"image.vtk", legacyImage()}, {"image.vti", xmlImage()}, {"cells.vtu", xmlHexahedra()}};
	for (const auto& [name, whole] : samples)
	{
		ASSERT_TRUE(isQuiet(run({"info", write(name, whole)}))) << name;
		for (int percent : {2, 20, 50, 70, 90})
			expectRefused(write(name, whole.substr(0, whole.size() * static_cast<std::size_t>(percent) / 100)), {name});
	}
}

TEST_F(Input, LiesAboutSizes)
{
	std::string image = legacyImage();
	image.replace(image.find("4 4 4"), 5, "4000000 4000000 4000000");
	expectRefused(write("huge.vtk", image), {"huge.vtk"});
	image = legacyImage();
	image.replace(image.find("4 4 4"), 5, "4 4 -4");
	expectRefused(write("negative.vtk", image), {"negative.vtk"});
	std::string cells = xmlHexahedra();
	cells.replace(cells.find("7 10 9 1"), 8, "7 99 9 1");
	expectRefused(write("outside.vtu", cells), {"outside.vtu"});
}

TEST_F(Input, OneBadFileAmongGoodOnes)
{
	EXPECT_TRUE(isError(run({"slice", "demo:shell:8", path("absent.vtu"), "--classify", "cpu", "-o", path("out.vtp")}),
	                    2, {"absent.vtu"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(Input, UnknownDemo)
{
	for (const std::string demo : {"demo:cheese", "demo:cheese:8"})
		expectRefused(demo, {"cheese", "shell", "hexes", "tets", "blob", "graded", "mixed", "layer"});
}

TEST_F(Input, DemoOfAnImpossibleSize)
{
	for (const std::string demo : {"demo:shell:0", "demo:shell:-3", "demo:shell:x", "demo:shell:", "demo:shell:8:8",
	                               "demo:shell:1000000", "demo:shell:99999999999999999999"})
		expectRefused(demo, {demo});
}

TEST_F(Input, UnknownArrayListsThoseThereAre)
{
	const std::string image = write("image.vtk", legacyImage());
	for (const std::string array : {"depth", "point:depth", "cell:depth", "cell:height", "point:mass"})
	{
		EXPECT_TRUE(isError(run({"slice", image, "--array", array, "--classify", "cpu", "-o", path("out.vtp")}), 2,
		                    {array, "height", "both", "wind", "mass"}))
		    << array;
		EXPECT_FALSE(std::filesystem::exists(path("out.vtp")));
	}
}

TEST_F(Input, ComponentTheArrayLacks)
{
	const Outcome outcome =
	    run({"slice", "demo:shell:8", "--array", "v", "--component", "3", "--classify", "cpu", "-o", path("out.vtp")});
	EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << outcome.status;
	EXPECT_TRUE(isError(outcome, outcome.status, {"--component", "v"}));
	EXPECT_TRUE(files().empty());
}

// Every input of the data folder, cut short.
TEST_F(Input, TruncatedRealData)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder";
	for (const std::string file :
	     {"voxel/ironProt/ironProt.vtk", "voxel/aneurism/aneurism.vti", "uniform/carotid/carotid.vtk",
	      "rectilinear/RectGrid2/RectGrid2.vtk", "structured/SampleStructGrid/SampleStructGrid.vtk",
	      "structured/office/office.binary.vtk", "unstructured/hexa/hexa.vtk", "unstructured/uGridEx/uGridEx.vtk",
	      "unstructured/disk_out_ref/disk_out_ref.ex2", "unstructured/post_tets/post.vtk",
	      "unstructured/box_hybrid/box_hybrid_mesh.vtu"})
	{
		const std::string whole = contents(std::string(data) + "/" + file);
		ASSERT_FALSE(whole.empty()) << file;
		const std::string name = std::filesystem::path(file).filename();
		for (int percent : {1, 30, 60})
		{
			const std::string part =
			    write(name, whole.substr(0, whole.size() * static_cast<std::size_t>(percent) / 100));
			EXPECT_TRUE(isError(run({"info", part}), 2, {name})) << percent << " % of " << file;
		}
	}
}

} // namespace cli
