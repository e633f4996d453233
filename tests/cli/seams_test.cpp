#include "program.h"

#include <cstdlib>

namespace cli
{

namespace
{

// Real sets whose blocks abut, or whose points are not merged.
class Seams : public Program
{
protected:
	void SetUp() override
	{
		const char* data = std::getenv("VPROBE_DATA");
		if (!data)
			GTEST_SKIP() << "VPROBE_DATA does not name the data sets";
		data_ = data;
	}

	// One seed shows what all seeds show, in one piece.
	void expectCrossed(const std::string& file, const std::vector<Arguments>& planes) const
	{
		for (const Arguments& plane : planes)
		{
			const Arguments cut = Arguments{data_ + "/" + file} + plane + Arguments{"--outside", "nearest"};
			const nlohmann::json all = stats(cut)["sheets"][0];
			const Outcome one =
			    run(Arguments{"slice"} + cut + Arguments{"--classify", "cpu", "--seeds", "hotspot", "--stats", "-"});
			ASSERT_EQ(one.status, 0) << one.err;
			const nlohmann::json piece = one.json()["sheets"][0];
			EXPECT_GT(all["cut_cells"], 0) << file;
			EXPECT_EQ(piece["cut_cells"], all["cut_cells"]) << file;
			EXPECT_EQ(piece["seeds"], 1) << file;
			EXPECT_EQ(piece["components"], 1) << file;
			EXPECT_EQ(all["components"], 1) << file;
		}
	}

	std::string data_;
};

const std::vector<Arguments> kPlanes{
    {"--normal", "x"}, {"--normal", "y"}, {"--normal", "z"}, {"--normal", "0.3", "0.5", "0.81"}};

} // namespace

TEST_F(Seams, BlocksThatAbut)
{
	expectCrossed("multiblock/multi_bin/multi-bin-C.xyz", kPlanes);
	const nlohmann::json info = run({"info", data_ + "/multiblock/multi_bin/multi-bin-C.xyz", "--json"}).json();
	EXPECT_EQ(info["interfaces"].size(), 1u);
	EXPECT_EQ(info["interfaces"][0]["faces"], 121);
	EXPECT_EQ(info["seam_faces"], 242);
}

TEST_F(Seams, FiveZonesOfThreeShapes)
{
	const std::string file = "multiblock/5blocks_struc/5blocks-struc.cgns";
	if (run({"info", data_ + "/" + file}).status != 0)
		GTEST_SKIP() << "CGNS cannot be read";
	EXPECT_GE(run({"info", data_ + "/" + file, "--json"}).json()["interfaces"].size(), 4u);
	const nlohmann::json all = stats({data_ + "/" + file, "--normal", "z"})["sheets"][0];
	EXPECT_EQ(all["components"], 1);
}

TEST_F(Seams, PointsThatAreNotMerged)
{
	expectCrossed("unstructured/AngularSector/AngularSector.vtk", kPlanes);
}

TEST_F(Seams, CellBlocksOfOneFile)
{
	expectCrossed("time/mug/mug.e", {{"--normal", "z"}, {"--normal", "0.3", "0.5", "0.81"}});
}

} // namespace cli
