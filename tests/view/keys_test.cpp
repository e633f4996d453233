#include "desktop.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

namespace view
{

namespace
{

// The window without a mouse.
class Keys : public Desktop
{
};

} // namespace

TEST_F(Keys, ASettingIsSetByItsName)
{
	open({"demo:blob:8"});
	searchFor("range 0.25 5");
	keepWindow("set_range");
	press("Return");
	EXPECT_TRUE(eventually([&] { return state()["look"]["range"] == nlohmann::json({0.25, 5.0}); })) << state();
	searchFor("mesh"); // a switch needs no value
	press("Return");
	EXPECT_TRUE(eventually([&] { return state()["look"]["mesh"] == true; })) << state();
	searchFor("range 5 0"); // a value that cannot be
	press("Return");
	settle();
	EXPECT_EQ(state()["look"]["range"], nlohmann::json({0.25, 5.0}));
	press("Escape");
	command("set lines 7");
	EXPECT_EQ(settle()["look"]["lines"], 7);
	EXPECT_EQ(err(), "");
	command("set refine 2");
	settle();
	EXPECT_TRUE(cli::contains(err(), "refine")) << err();
	close(err());
}

// The film cannot be saved before it is recorded: there is no question that would take the next key.
TEST_F(Keys, WhatIsNotPossibleHasNoKey)
{
	open({"demo:blob:8"});
	press("ctrl+m");
	press("l");
	EXPECT_TRUE(eventually([&] { return state()["look"]["lines"] > 0; })) << state();
	close();
}

TEST_F(Keys, MenusOpenAndEnterChooses)
{
	open({"demo:blob:8"});
	const nlohmann::json before = settle();
	press("F10");
	for (const char* key : {"Left", "Right", "Right", "Right", "Right", "Left"}) // Window, File, Film, Probe, Sheets
	{
		rest(scene());
		press(key);
	}
	rest(scene());
	keepWindow("menu_by_keys");
	settle();
	EXPECT_EQ(state(), before); // the arrow keys have turned nothing
	press("Down");              // from pushing forward to pushing back
	rest(scene());
	press("Return");
	EXPECT_TRUE(eventually([&] { return state()["probe"].contains("origin"); }));
	EXPECT_LT(state()["probe"]["origin"][2], 0.0);
	const nlohmann::json pushed = settle();
	press("F10");
	rest(scene());
	press("Right");
	rest(scene());
	press("Escape");
	rest(scene());
	EXPECT_EQ(settle(), pushed);
	// With no menu open, it turns the probe. A busy machine may take a while until the menu is closed.
	EXPECT_TRUE(eventually(
	    [&]
	    {
		    press("Right");
		    return settle() != pushed;
	    }));
	close();
}

// The next arrow key or Enter goes by what is highlighted.
TEST_F(Keys, AMenuOpensWithItsFirstItemHighlighted)
{
	open({"demo:blob:8"});
	const Area first{120, 29, 100, 12}; // beside the names of "Open files" and "Save the state"
	const Area second{120, 48, 100, 12};
	rest(scene());
	press("F10");
	const auto isApart = [&] { return difference(seen(first), seen(second)) > 0.9; };
	EXPECT_TRUE(eventually(isApart));
	const vp::render::Picture lit = rest(first);
	keepWindow("menu_opened");
	press("Down");
	EXPECT_TRUE(eventually([&] { return difference(lit, seen(second)) == 0.0 && isApart(); }));
	press("Right"); // the first item of Film, "Play or pause the sweep"
	EXPECT_TRUE(eventually([&] { return difference(part(lit, {0, 0, 40, 12}), seen({210, 29, 40, 12})) == 0.0; }));
	close();
}

TEST_F(Keys, ThePanelIsReachedAndLeft)
{
	open({"demo:blob:8"});
	const nlohmann::json before = settle();
	press("F6");
	press("Down");
	press("Down");
	settle();
	EXPECT_EQ(state(), before);
	keepWindow("panel_by_keys");
	press("Escape");
	press("Down"); // turns the probe again
	EXPECT_TRUE(eventually([&] { return state() != before; }));
	close();
}

TEST_F(Keys, EscapeClosesTheQuestion)
{
	open({"demo:blob:8"});
	for (const char* opens : {"ctrl+o", "ctrl+p", "F1", "ctrl+k"})
	{
		const vp::render::Picture plain = rest(scene());
		press(opens);
		EXPECT_TRUE(eventually([&] { return difference(plain, seen(scene())) > 0.01; })) << opens;
		press("Escape");
		EXPECT_TRUE(eventually([&] { return difference(plain, seen(scene())) < 0.001; })) << opens;
	}
	close();
}

TEST_F(Keys, ASignalIsNoCrash)
{
	open({"demo:blob:8"});
	act("turn_x_plus");
	settle();
	program().interrupt(SIGTERM);
	EXPECT_EQ(program().waitFor(kPatience), 143);
	for (const auto& entry : std::filesystem::recursive_directory_iterator(path("state")))
		EXPECT_TRUE(entry.is_directory()) << entry.path();
}

TEST_F(Keys, AWindowOfAnotherSizeFitsTheView)
{
	open({"demo:blob:8"});
	const nlohmann::json before = settle()["look"]["camera"];
	command("size 700 680");
	const nlohmann::json narrow = settle()["look"]["camera"];
	EXPECT_NE(narrow, before);
	act("undo"); // fitting is no step of the history
	EXPECT_EQ(settle()["look"]["camera"], narrow);
	command("set camera 9,-7,8,0,0,0,0,0,1");
	const nlohmann::json moved = settle()["look"]["camera"];
	EXPECT_NE(moved, narrow);
	command("size 1000 700");
	EXPECT_EQ(settle()["look"]["camera"], moved);
	close();
}

TEST_F(Keys, AProbeOutsideTheDataIsToldTheWayBack)
{
	open({"demo:blob:8"});
	const Area below{200, 620, 400, 50};
	const nlohmann::json before = settle();
	const vp::render::Picture plain = rest(below);
	command("set origin \"0 0 100\"");
	settle();
	EXPECT_TRUE(eventually([&] { return difference(plain, seen(below)) > 0.2; }));
	keepWindow("way_back");
	press("Home");
	EXPECT_TRUE(eventually([&] { return difference(plain, seen(below)) < 0.05; }));
	close();
}

} // namespace view
