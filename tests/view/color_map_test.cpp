#include "desktop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace view
{

namespace
{

using cli::operator+;
using nlohmann::json;

// The color map in the panel of a small window. T brings its heading to the top.
class ColorMapInThePanel : public Desktop
{
protected:
	void openPanel()
	{
		open({"demo:shell:16", "--normal", "z", "--size", "640x480"});
		command("size 640 480"); // a window manager may have made it smaller
		press("t");
		settle();
		rest(kPanel);
	}

	// Returns the points as the state has them.
	json points() { return settle()["look"].value("opacity_points", json()); }
	bool comesTo(const json& wanted)
	{
		return eventually(
		    [&]
		    {
			    const json now = points();
			    if (now.size() != wanted.size())
				    return false;
			    for (std::size_t i = 0; i < wanted.size(); ++i)
				    if (std::abs(now[i].get<double>() - wanted[i].get<double>()) > 0.02)
					    return false;
			    return true;
		    });
	}

	// Returns where the graph has a place and an opacity.
	static glm::ivec2 inGraph(double place, double opacity)
	{
		return {std::lround(kGraph.x + place * kGraph.width), std::lround(kGraph.y + (1.0 - opacity) * kGraph.height)};
	}
	// A frame of the window passes between two steps, as it does for a hand.
	void dragSlowly(const glm::ivec2& from, const glm::ivec2& to, int button = 1) const
	{
		const auto move = [](const glm::ivec2& at)
		{ return "mousemove " + std::to_string(at.x) + " " + std::to_string(at.y) + "\nsleep 0.3\n"; };
		const std::string number = std::to_string(button) + "\nsleep 0.3\n";
		xdotool(move(from) + "mousedown " + number + move((from + to) / 2) + move(to) + "mouseup " + number);
	}
	void pressEach(const std::vector<std::string>& keys)
	{
		for (const std::string& key : keys)
		{
			press(key);
			rest(kPanel);
		}
	}

	static constexpr Area kPanel{384, 24, 250, 340};
	static constexpr Area kScene{0, 24, 380, 400};
	static constexpr Area kGraph{401, 110, 210, 83}; // from clear to opaque
};

} // namespace

TEST_F(ColorMapInThePanel, IsEditedByTheMouse)
{
	openPanel();
	const vp::render::Picture opaque = rest(kScene);
	EXPECT_TRUE(points().is_null());
	const glm::ivec2 middle = inGraph(0.5, 0.5);
	dragSlowly(middle, middle); // a click adds a point
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.5, 0.5, 1.0, 1.0})) << points();
	EXPECT_TRUE(eventually([&] { return difference(opaque, seen(kScene)) > 0.02; }));
	dragSlowly(middle, inGraph(0.25, 0.0));
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.25, 0.0, 1.0, 1.0})) << points();
	dragSlowly(inGraph(1.0, 1.0), inGraph(0.1, 0.6)); // not past its neighbor
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.25, 0.0, 0.25, 0.6})) << points();
	press("ctrl+z"); // a drag is one step
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.25, 0.0, 1.0, 1.0})) << points();
	press("ctrl+z");
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.5, 0.5, 1.0, 1.0})) << points();
	dragSlowly(middle, middle, 3); // the right button removes it
	EXPECT_TRUE(comesTo({0.0, 1.0, 1.0, 1.0})) << points();
	pressEach({"ctrl+z", "ctrl+z"});
	EXPECT_TRUE(points().is_null());
	press("ctrl+y");
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.5, 0.5, 1.0, 1.0})) << points();
	dragSlowly(inGraph(0.8, 0.2), inGraph(0.8, 0.2));
	dragSlowly(inGraph(0.8, 0.2), inGraph(0.8, 0.2), 3);
	dragSlowly(middle, middle, 3); // two steps
	EXPECT_TRUE(comesTo({0.0, 1.0, 1.0, 1.0})) << points();
	press("ctrl+z");
	EXPECT_TRUE(comesTo({0.0, 1.0, 0.5, 0.5, 1.0, 1.0})) << points();
	close();
}

TEST_F(ColorMapInThePanel, IsEditedByKeys)
{
	openPanel();
	pressEach({"Down", "Down", "Down", "Down", "Down", "space"}); // to the opacity of the first point
	pressEach({"Left", "Left", "Left", "space"});
	EXPECT_TRUE(comesTo({0.0, 0.97, 1.0, 1.0})) << points();
	pressEach({"Down", "Return"}); // a point between the two
	EXPECT_TRUE(comesTo({0.0, 0.97, 0.5, 0.985, 1.0, 1.0})) << points();
	pressEach({"Up", "Up", "Return"}); // a value is typed: 0.75 of the way from -2.4683 to 2.4683
	xdotool("type --delay 60 '1.2341'\nkeydown Return\nsleep 0.3\nkeyup Return\n");
	rest(kPanel);
	EXPECT_TRUE(comesTo({0.0, 0.97, 0.75, 0.985, 1.0, 1.0})) << points();
	pressEach({"Down", "Down", "Right", "Return"}); // Remove
	EXPECT_TRUE(comesTo({0.0, 0.97, 1.0, 1.0})) << points();
	pressEach({"Down", "Left", "Return"}); // Set back
	EXPECT_TRUE(eventually([&] { return points().is_null(); })) << points();
	pressEach({"Escape", "Down"}); // the probe has the keys again
	EXPECT_TRUE(eventually([&] { return settle()["probe"].contains("normal"); }));
	close();
}

TEST_F(ColorMapInThePanel, IsFoundByItsName)
{
	open({"demo:shell:64", "--normal", "0.3", "0.5", "0.8", "--size", "1280x800"});
	moveTo({5, 700});
	const vp::render::Picture before = rest({1000, 30, 260, 700});
	searchFor("color map: op");
	press("Return");
	EXPECT_TRUE(eventually([&] { return difference(before, seen({1000, 30, 260, 700})) > 0.05; }));
	command("set opacity_points \"0 0 0.3 0.1 0.6 0.9 1 0.4\"");
	settle();
	keepWindow("color_map");
	close();
}

// The window, the program with the state, and the program with the map as a file draw the same.
TEST_F(ColorMapInThePanel, DrawsTheSameElsewhere)
{
	open({"demo:shell:16", "--normal", "z", "--colormap", "cool-warm"});
	command("set opacity_points \"0.1 0.2 0.5 1 0.5 0.3 0.9 0.8\"");
	settle();
	command("save-state " + path("edited.json"));
	command("save-color-map " + path("map.json"));
	command("save-picture 240 160 " + path("window.png"));
	settle();
	act("undo");
	settle();
	command("save-state " + path("plain.json"));
	settle();
	const auto drawn = [&](const cli::Arguments& options)
	{
		EXPECT_TRUE(
		    cli::isQuiet(run(cli::Arguments{"render", "--size", "240x160", "-o", path("render.png")} + options)));
		return cli::contents(path("render.png"));
	};
	const std::string of_state = drawn({"--state", path("edited.json")});
	EXPECT_EQ(cli::sizeOf(of_state), (cli::PictureSize{240, 160}));
	EXPECT_EQ(of_state, cli::contents(path("window.png")));
	EXPECT_EQ(of_state, drawn({"--state", path("plain.json"), "--colormap", path("map.json")}));
	EXPECT_NE(of_state, drawn({"--state", path("plain.json")}));
	close();
}

// The key for saving a map asks nothing.
TEST_F(ColorMapInThePanel, LabelsHaveNone)
{
	std::string text = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 3 3\nencoding: ascii\nspace dimension: 3\n"
	                   "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n\n";
	for (int i = 0; i < 27; ++i)
		text += std::to_string(i % 3) + "\n";
	open({write("a.seg.nrrd", text), "--size", "640x480"});
	press("t");
	settle();
	press("ctrl+shift+m"); // asks nothing, so the next key is heard
	press("Escape");
	press("l");
	EXPECT_TRUE(eventually([&] { return settle()["look"].value("lines", 0) > 0; }));
	close();
}

} // namespace view
