// An image of several resolutions whose values stay in their file: a coarser one is cut while the probe moves.

#include "desktop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace view
{

namespace
{

class Draft : public Desktop
{
protected:
	const Area middle_{240, 280, 80, 60}; // within the sheet

	// Every value of a level is its fill value, since no chunk of it was written.
	void writeLevel(const std::string& name, int side, double value) const
	{
		const nlohmann::json about = {{"zarr_format", 2}, {"shape", {side, side, side}}, {"chunks", {32, 32, 32}},
		                              {"dtype", "<f4"},   {"fill_value", value},         {"order", "C"},
		                              {"filters", {}},    {"compressor", nullptr}};
		put("image.zarr/" + name + "/.zarray", about);
	}

	void writeImage() const
	{
		nlohmann::json axes = nlohmann::json::array(), levels = nlohmann::json::array();
		for (const char* axis : {"z", "y", "x"})
			axes.push_back({{"name", axis}, {"type", "space"}});
		for (int level = 0; level < 2; ++level)
		{
			const double step = 1 << level;
			const double first = 0.5 * (step - 1.0);
			levels.push_back({{"path", std::to_string(level)},
			                  {"coordinateTransformations",
			                   {{{"type", "scale"}, {"scale", {step, step, step}}},
			                    {{"type", "translation"}, {"translation", {first, first, first}}}}}});
		}
		put("image.zarr/.zgroup", {{"zarr_format", 2}});
		put("image.zarr/.zattrs", {{"multiscales", {{{"version", "0.4"}, {"axes", axes}, {"datasets", levels}}}}});
		writeLevel("0", 256, 0.0);
		writeLevel("1", 128, 1000.0);
	}

private:
	void put(const std::string& name, const nlohmann::json& contents) const
	{
		std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
		write(name, contents.dump());
	}
};

} // namespace

// The coarser level has other values here, so a picture tells which one was cut.
TEST_F(Draft, ACoarserLevelIsCutUntilTheProbeRests)
{
	writeImage();
	open({path("image.zarr"), "--normal", "z", "--range", "0", "1000", "--memory", "40M"});
	act("handles");
	settle();
	const vp::render::Picture exact = rest(middle_);
	bool has_seen_draft = false;
	int moves = 0;
	EXPECT_TRUE(eventually(
	    [&]
	    {
		    act(++moves % 2 == 1 ? "push_forward" : "push_back");
		    for (int look = 0; look < 20 && !has_seen_draft; ++look)
			    has_seen_draft = difference(exact, seen(middle_)) > 0.9;
		    return has_seen_draft;
	    }));
	settle();
	EXPECT_EQ(difference(exact, rest(middle_)), 0.0);
	// A sheet that rests is not cut anew.
	act("mesh");
	settle();
	act("mesh");
	settle();
	EXPECT_EQ(difference(exact, rest(middle_)), 0.0);
	EXPECT_GE(close()["drafts"], 1);
}

TEST_F(Draft, WhatIsInMemoryNeedsNone)
{
	writeImage();
	open({path("image.zarr"), "--normal", "z", "--range", "0", "1000", "--memory", "400M"});
	for (int k = 0; k < 3; ++k)
	{
		act("push_forward");
		settle();
	}
	EXPECT_EQ(close()["drafts"], 0);
}

} // namespace view
