#include "program.h"

namespace cli
{

namespace
{

class Scan : public Program
{
};

class ScannedSweep : public Drawing
{
};

std::size_t count(const nlohmann::json& sheet, const char* key)
{
	return sheet.at(key).get<std::size_t>();
}

} // namespace

TEST_F(Scan, IsTheOnlyCutOfAnUnstructuredGrid)
{
	const nlohmann::json scanned = stats({"demo:tets:8"});
	EXPECT_EQ(scanned["plan"][0]["strategy"], "scan");
	const nlohmann::json& sheet = scanned["sheets"][0];
	EXPECT_EQ(count(sheet, "cells_scanned"), 5 * 8 * 8 * 8);
	for (const char* key :
	     {"cells_touched", "seeds", "hops", "boundary_tests", "tree_tests", "generations", "front_max"})
		EXPECT_EQ(count(sheet, key), 0u) << key;
	EXPECT_EQ(scanned["ms"]["adjacency"], 0.0);

	const nlohmann::json searched = stats({"demo:tets:8", "--strategy", "cells"});
	EXPECT_EQ(count(searched["sheets"][0], "cells_scanned"), 0u);
	EXPECT_GT(count(searched["sheets"][0], "seeds"), 0u);
	EXPECT_GT(searched["ms"]["adjacency"], 0.0);
	for (const char* key : {"cut_cells", "polygons", "vertices", "components", "boundary_faces"})
		EXPECT_EQ(sheet[key], searched["sheets"][0][key]) << key;
	EXPECT_EQ(count(stats({"demo:shell:8"})["sheets"][0], "cells_scanned"), 0u);
}

TEST_F(Scan, ShowsWholeCellsAsASearchDoes)
{
	for (const Arguments& sheet :
	     {Arguments{"--normal", "1", "2", "3"}, Arguments{"--normal", "z", "--origin", "0", "0", "0"},
	      Arguments{"--surface", "sphere:0.6"}, Arguments{"--window", "0.9", "0.7"}})
	{
		const Arguments cut = Arguments{"demo:tets:8", "--crinkle"} + sheet;
		const nlohmann::json scanned = stats(cut);
		EXPECT_EQ(scanned["plan"][0]["strategy"], "scan");
		EXPECT_EQ(scanned["ms"]["adjacency"], 0.0);
		const nlohmann::json searched = stats(cut + Arguments{"--strategy", "generations"});
		const nlohmann::json &faces = scanned["sheets"][0]["crinkle"], &wanted = searched["sheets"][0]["crinkle"];
		EXPECT_GT(count(faces, "faces"), 0u);
		EXPECT_EQ(faces["faces"], wanted["faces"]);
		EXPECT_EQ(faces["vertices"], wanted["vertices"]);
		EXPECT_NEAR(faces["area"], wanted["area"], 1e-12 * wanted["area"].get<double>());
	}
}

TEST_F(Scan, GivesWayToWhatNeedsNeighbors)
{
	const auto strategy = [&](const Arguments& more)
	{ return stats(Arguments{"demo:tets:8"} + more)["plan"][0]["strategy"].get<std::string>(); };
	EXPECT_EQ(strategy({"--seeds", "boundary"}), "cells");
	EXPECT_EQ(strategy({"--outside", "report"}), "cells");
	EXPECT_EQ(strategy({"--visited", "stamps"}), "generations");
	EXPECT_EQ(strategy({"--threshold", "-1", "0.5"}), "generations");
	EXPECT_EQ(strategy({"--contour", "0.2", "--window", "0.5", "0.5"}), "cells");
	EXPECT_EQ(strategy({"--vectors", "tufts"}), "cells");
	EXPECT_EQ(strategy({"--crinkle"}), "scan");
	EXPECT_EQ(strategy({"--surface", "sphere:2"}), "scan");
	EXPECT_EQ(strategy({"--window", "1", "1"}), "scan");
}

// Polygons come in the order of the file's cells.
TEST_F(Scan, ExportsInTheOrderOfTheFile)
{
	ASSERT_EQ(run({"slice", "demo:tets:6", "--normal", "1", "2", "3", "-o", path("scan.csv")}).status, 0);
	ASSERT_EQ(run({"slice", "demo:tets:6", "--normal", "1", "2", "3", "-o", path("again.csv")}).status, 0);
	EXPECT_EQ(contents(path("scan.csv")), contents(path("again.csv")));
}

// The first frame is scanned, the others are searched for: twice the same bytes.
TEST_F(ScannedSweep, IsTheSameWheneverItIsMade)
{
	const auto sweep = [&](const std::string& pattern, const Arguments& more)
	{
		return run(Arguments{"sweep", "demo:tets:6", "--size", "96x64", "--samples", "1", "--frames", "3", "-o",
		                     path(pattern)} +
		           more)
		    .status;
	};
	ASSERT_EQ(sweep("a{frame}.png", {}), 0);
	ASSERT_EQ(sweep("b{frame}.png", {"--threads", "1"}), 0);
	for (const char* frame : {"0.png", "1.png", "2.png"})
		EXPECT_EQ(contents(path(std::string("a") + frame)), contents(path(std::string("b") + frame))) << frame;
	// Gone on with from the second frame.
	std::remove(path("b1.png").c_str());
	std::remove(path("b2.png").c_str());
	ASSERT_EQ(sweep("b{frame}.png", {"--resume"}), 0);
	for (const char* frame : {"1.png", "2.png"})
		EXPECT_EQ(contents(path(std::string("a") + frame)), contents(path(std::string("b") + frame))) << frame;
}

TEST_F(ScannedSweep, FiguresTellWhichFrameWasScanned)
{
	ASSERT_EQ(run({"sweep", "demo:tets:6", "--frames", "3", "-o", path("out.pvd"), "--stats", path("s.json")}).status,
	          0);
	const nlohmann::json frames = nlohmann::json::parse(contents(path("s.json")))["frames"];
	ASSERT_EQ(frames.size(), 3u);
	for (std::size_t f = 0; f < 3; ++f)
	{
		EXPECT_EQ(count(frames[f]["sheets"][0], "cells_scanned") > 0, f == 0) << f;
		EXPECT_EQ(count(frames[f]["sheets"][0], "cells_touched") > 0, f > 0) << f;
	}
}

} // namespace cli
