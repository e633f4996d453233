#include "program.h"

namespace cli
{

namespace
{

// A machine without a Vulkan device.
class NoDevice : public Program
{
};

} // namespace

TEST_F(NoDevice, SliceGoesOnWithTheCpu)
{
	const Outcome outcome = run({"slice", "demo:shell:16", "--stats", "-"}, noDevice());
	ASSERT_TRUE(isQuiet(outcome)); // the CPU is what --classify auto takes then
	EXPECT_EQ(outcome.json()["device"], "none");
	EXPECT_EQ(outcome.json()["classifier"], "cpu");
	EXPECT_GT(outcome.json()["sheets"][0]["cut_cells"], 0);
}

TEST_F(NoDevice, SliceOnTheCpuIsQuiet)
{
	EXPECT_TRUE(isQuiet(run({"slice", "demo:shell:16", "--classify", "cpu", "--stats", "-"}, noDevice())));
	EXPECT_TRUE(isQuiet(run({"info", "demo:shell:16"}, noDevice())));
}

TEST_F(NoDevice, SliceOnTheGpuIsRefused)
{
	EXPECT_TRUE(
	    isError(run({"slice", "demo:shell:16", "--classify", "gpu", "-o", path("out.vtp"), "--stats", path("out.json")},
	                noDevice()),
	            3, {"mesa-vulkan-drivers"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(NoDevice, RenderIsRefused)
{
	for (const Arguments& classify : {Arguments{}, Arguments{"--classify", "cpu"}, Arguments{"--classify", "gpu"}})
		EXPECT_TRUE(isError(run(Arguments{"render", "demo:shell:16", "-o", path("out.png")} + classify, noDevice()), 3,
		                    {"mesa-vulkan-drivers"}));
	EXPECT_TRUE(files().empty());
}

// The input is at fault as much as the machine: the input is told first, since nothing could be done with it anywhere.
TEST_F(NoDevice, BadUsageAndBadInputComeFirst)
{
	EXPECT_EQ(run({"render", "demo:shell:8", "--normal", "0", "0", "0", "-o", path("out.png")}, noDevice()).status, 1);
	EXPECT_EQ(run({"slice", "demo:shell:8", "--classify", "fpga"}, noDevice()).status, 1);
}

} // namespace cli
