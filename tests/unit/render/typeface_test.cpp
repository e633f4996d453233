#include "render/font/typeface.h"

#include "render/annotate/font_atlas.h"
#include "small_font.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace vp::render
{

namespace
{

std::string written(const std::string& name, const std::string& contents)
{
	const auto path = std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name);
	std::ofstream(path, std::ios::binary) << contents;
	return path;
}

} // namespace

TEST(Typeface, TheBuiltInFontHasGreekAndNoChinese)
{
	const Typeface& font = Typeface::builtIn();
	EXPECT_TRUE(font.has(U'A') && font.has(U'μ') && font.has(U'⁻'));
	EXPECT_FALSE(font.has(U'断'));
	EXPECT_NEAR(font.ascent() + font.descent(), kLetterHeight, 1e-12);
}

TEST(Typeface, AFileIsRead)
{
	const std::string file = written("small.ttf", test::smallFont("Small Boxes", {'A', 0x65ad}));
	const Result<const Typeface*> font = Typeface::find(file);
	ASSERT_TRUE(font) << font.error().message;
	EXPECT_TRUE((*font)->has(U'A') && (*font)->has(U'断'));
	EXPECT_FALSE((*font)->has(U'B'));
	EXPECT_EQ((*font)->ascent(), 1.0);
	EXPECT_EQ((*font)->descent(), 0.2);
	EXPECT_EQ(*Typeface::find(file), *font); // once in the program
	std::filesystem::remove(file);
}

TEST(Typeface, WhatIsNoFontIsRefused)
{
	const std::string text = written("text.ttf", "no font at all");
	const Result<const Typeface*> no_font = Typeface::find(text);
	ASSERT_FALSE(no_font);
	EXPECT_NE(no_font.error().message.find("no TrueType"), std::string::npos);
	std::filesystem::remove(text);
	EXPECT_FALSE(Typeface::find("./missing.otf"));
	const Result<const Typeface*> family = Typeface::find("No Such Family Anywhere");
	ASSERT_FALSE(family);
	EXPECT_NE(family.error().message.find("fc-list"), std::string::npos);
}

// A letter is as wide as the em, whatever the height of the font's lines.
TEST(Typeface, LettersComeFromTheFirstFontThatHasThem)
{
	const std::string file = written("first.ttf", test::smallFont("Small Boxes", {'A', 0x65ad}));
	const Typeface& small = **Typeface::find(file);
	const double size = 20.0;
	const FontAtlas lettering({size}, {"A断B"}, small);
	const auto runs = lettering.runs("A断B");
	ASSERT_EQ(runs.size(), 2u);
	EXPECT_EQ(runs[0].font, &small);
	EXPECT_EQ(runs[0].text, "A断");
	EXPECT_EQ(runs[1].font, &Typeface::builtIn());
	EXPECT_EQ(runs[1].text, "B");
	const double em = size / kLetterHeight;
	EXPECT_NEAR(lettering.width("A断", size), 2.0 * em, 1e-3 * em);
	EXPECT_NEAR(lettering.width("B", size), FontAtlas({size}, {}).width("B", size), 1e-3 * em);
	std::filesystem::remove(file);
}

} // namespace vp::render
