// A driver that tells figures of pipelines: the layer's, which are known.
#include "faulty_device.h"
#include "program.h"

namespace cli
{

namespace
{

class GivenDevice : public Drawing
{
};

} // namespace

TEST_F(GivenDevice, ProfileTellsEachPipeline)
{
	const Arguments options{"profile", "demo:shell:12", "--draw", "--classify", "gpu", "--planes",
	                        "2",       "--size",        "96x64"};
	const auto environment = vp::layer::givenExecutables();
	const Outcome outcome = run(options + Arguments{"--json", "-"}, {.environment = environment});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = outcome.json();
	EXPECT_FALSE(told.at("not_counted").contains("pipelines"));
	std::map<std::string, int> pipelines;
	for (const auto& shader : told.at("pipelines"))
	{
		++pipelines[shader.at("pipeline")];
		EXPECT_EQ(shader.at("executable"), "given shader");
		EXPECT_EQ(shader.at("subgroup_size"), 16);
		EXPECT_EQ(shader.at("figures"), nlohmann::json::parse(R"({"registers": 42.0, "spills": 1.0, "balance": -3.0,
			"occupancy": 0.75, "bytes": 1024.0})"));
	}
	for (const char* name : {"classify", "compose", "layer", "overlay"})
		EXPECT_GE(pipelines[name], 1) << name;
	const Outcome table = run(options, {.environment = environment});
	ASSERT_TRUE(isQuiet(table));
	EXPECT_TRUE(contains(table.out, "pipeline compose, given shader: subgroups of 16, balance -3, bytes 1024, "
	                                "occupancy 0.75, registers 42\n"))
	    << table.out;
	EXPECT_FALSE(contains(table.out, "pipelines are not told"));
	// Nobody asks then.
	const Outcome without = run(options + Arguments{"--no-floor", "--json", "-"}, {.environment = environment});
	ASSERT_TRUE(isQuiet(without));
	EXPECT_FALSE(without.json().contains("pipelines"));
}

} // namespace cli
