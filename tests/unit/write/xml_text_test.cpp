#include "write/xml_text.h"

#include <gtest/gtest.h>

namespace vp::test
{

TEST(XmlText, LettersOfUtf8Stay)
{
	for (const char* name : {"p", "Druck µ", "温度", "\U0001F600"})
		EXPECT_EQ(write::xmlText(name), name);
	EXPECT_EQ(write::xmlText("a<b>&\"c\"\n"), "a&lt;b>&amp;&quot;c&quot;_");
}

// A name that is not UTF-8 throughout has _ for every byte past ASCII.
TEST(XmlText, WhatIsNoUtf8IsReplaced)
{
	EXPECT_EQ(write::xmlText("caf\xe9"), "caf_");
	EXPECT_EQ(write::xmlText("a\xEF\xBF\xBE\xEF\xBF\xBF z"), "a__ z"); // characters of no XML document
	EXPECT_EQ(write::xmlText("\xc0\xaf"), "__");                       // longer than need be
	EXPECT_EQ(write::xmlText("\xe0\x9f\xbf"), "___");                  // likewise
	EXPECT_EQ(write::xmlText("\xed\xa0\x80x"), "___x");                // half a pair
	EXPECT_EQ(write::xmlText("\xf4\x90\x80\x80"), "____");             // above U+10FFFF
	EXPECT_EQ(write::xmlText("\xc3"), "_");
}

} // namespace vp::test
