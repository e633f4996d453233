#include "program.h"

#include <regex>

namespace cli
{

namespace
{

class Export : public Program
{
protected:
	Outcome slice(const std::string& output) const
	{
		return run({"slice", "demo:shell:8", "--probe", "trihedral", "--classify", "cpu", "-o", output});
	}
	Outcome sweep(const Arguments& options) const
	{
		return run(Arguments{"sweep", "demo:shell:8", "--classify", "cpu", "--frames", "3"} + options, noDevice());
	}
	Arguments filesIn(const std::string& folder) const
	{
		Arguments names;
		for (const auto& entry : std::filesystem::directory_iterator(path(folder)))
			names.push_back(entry.path().filename());
		std::ranges::sort(names);
		return names;
	}
};

} // namespace

TEST_F(Export, MultiblockOfAProbe)
{
	ASSERT_TRUE(isQuiet(slice(path("out.vtm"))));
	EXPECT_EQ(files(), (Arguments{"out", "out.vtm"}));
	EXPECT_EQ(filesIn("out"), (Arguments{"sheet_0.vtp", "sheet_1.vtp", "sheet_2.vtp"}));
	const std::string text = contents(path("out.vtm"));
	for (const char* part : {"out/sheet_0.vtp", "out/sheet_1.vtp", "out/sheet_2.vtp"})
		EXPECT_TRUE(contains(text, part)) << text;
}

// Neither draws nor asks for a device.
TEST_F(Export, CollectionOfASweep)
{
	ASSERT_TRUE(isQuiet(sweep({"-o", path("out.pvd")})));
	EXPECT_EQ(files(), (Arguments{"out", "out.pvd"}));
	EXPECT_EQ(filesIn("out"), (Arguments{"frame_0000.vtp", "frame_0001.vtp", "frame_0002.vtp"}));
	const std::string text = contents(path("out.pvd"));
	const std::regex entry("timestep=\"([0-9]+)\"[^>]*file=\"out/frame_000([0-9]).vtp\"");
	int entries = 0;
	for (std::sregex_iterator i(text.begin(), text.end(), entry), end; i != end; ++i, ++entries)
		EXPECT_EQ((*i)[1], (*i)[2]);
	EXPECT_EQ(entries, 3);
	// The reader follows the collection to its parts: they are polygons, and so nothing to slice.
	EXPECT_TRUE(isError(run({"info", path("out.pvd")}), 2, {"out.pvd", "polygonal"}));
}

TEST_F(Export, AFrameIsTheSliceAlone)
{
	ASSERT_TRUE(isQuiet(sweep({"-o", path("out.pvd"), "--path", "spin", "--normal", "x"})));
	ASSERT_TRUE(isQuiet(run({"slice", "demo:shell:8", "--classify", "cpu", "--normal", "x", "-o", path("one.vtp")})));
	EXPECT_EQ(contents(path("out/frame_0000.vtp")), contents(path("one.vtp")));
}

TEST_F(Export, WhatElseIsInTheFolderStays)
{
	std::filesystem::create_directory(path("out"));
	write("out/notes.txt", "mine");
	write("out/sheet_1.vtp", "old");
	ASSERT_TRUE(isQuiet(slice(path("out.vtm"))));
	EXPECT_EQ(contents(path("out/notes.txt")), "mine");
	EXPECT_NE(contents(path("out/sheet_1.vtp")), "old");
}

// The pieces of the set before go, and nothing else. The reader finds those of the new one.
TEST_F(Export, ASetTakesThePlaceOfAnother)
{
	ASSERT_TRUE(isQuiet(sweep({"-o", path("out.pvd")})));
	write("out/notes.txt", "mine");
	ASSERT_TRUE(isQuiet(run(
	    Arguments{"sweep", "demo:shell:8", "--classify", "cpu", "--frames", "2", "-o", path("out.pvd")}, noDevice())));
	EXPECT_EQ(filesIn("out"), (Arguments{"frame_0000-2.vtp", "frame_0001-2.vtp", "notes.txt"}));
	EXPECT_TRUE(contains(contents(path("out.pvd")), "out/frame_0001-2.vtp"));

	ASSERT_TRUE(isQuiet(run({"convert", "demo:shell:4", "-o", path("set.vtm")})));
	const std::string before = run({"info", path("set.vtm")}).out;
	const Arguments pieces = filesIn("set");
	ASSERT_EQ(pieces.size(), 1u);
	ASSERT_TRUE(isQuiet(run({"convert", "demo:shell:5", "-o", path("set.vtm")})));
	EXPECT_EQ(filesIn("set").size(), 1u);
	EXPECT_NE(filesIn("set"), pieces);
	EXPECT_NE(run({"info", path("set.vtm")}).out, before);
	EXPECT_TRUE(isQuiet(run({"info", path("set.vtm")})));
	ASSERT_TRUE(isQuiet(run({"convert", "demo:shell:4", "-o", path("set.vtm")})));
	EXPECT_EQ(filesIn("set"), pieces);
	EXPECT_EQ(run({"info", path("set.vtm")}).out, before);
}

TEST_F(Export, ErrorsLeaveNothing)
{
	EXPECT_TRUE(files().empty());
	write("out", "a file where the folder would be");
	EXPECT_TRUE(isError(slice(path("out.vtm")), 4, {"out.vtm", "out, and that is a file"}));
	EXPECT_TRUE(isError(sweep({"-o", path("out.pvd")}), 4, {"out.pvd", "out, and that is a file"}));
	EXPECT_EQ(files(), Arguments{"out"});
}

TEST_F(Export, AFullDiskLeavesNothing)
{
	const Surroundings full{.file_size_limit = 3000};
	EXPECT_TRUE(
	    isError(run({"slice", "demo:shell:8", "--probe", "trihedral", "--classify", "cpu", "-o", path("a.vtm")}, full),
	            4, {"a.vtm", "sheet_0.vtp", "make room"}));
	EXPECT_TRUE(isError(run({"sweep", "demo:shell:8", "--classify", "cpu", "--frames", "3", "-o", path("a.pvd")}, full),
	                    4, {"a.pvd", "frame_0000.vtp", "make room"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(Export, InterruptedItLeavesNothing)
{
	const auto ripe = [&]
	{
		try
		{
			for (const std::string& name : files())
				if (std::filesystem::is_directory(path(name)) && filesIn(name).size() > 3)
					return true;
		}
		catch (const std::filesystem::filesystem_error&) // a file got its name meanwhile
		{
		}
		return false;
	};
	const Outcome outcome =
	    interrupted({"sweep", "demo:shell:8", "--classify", "cpu", "--frames", "100000", "-o", path("a.pvd")}, ripe);
	EXPECT_TRUE(isError(outcome, 130, {"interrupted"}));
	EXPECT_TRUE(files().empty());
}

} // namespace cli
