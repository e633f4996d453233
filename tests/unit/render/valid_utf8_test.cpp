#include "render/annotate/valid_utf8.h"

#include <gtest/gtest.h>

namespace vp::render
{

TEST(ValidUtf8, LettersStayAndOtherBytesAreReplaced)
{
	for (const char* letters : {"", "plain", "µm³", "−1.5×10⁶", "日本", "\U0001F600"})
		EXPECT_EQ(validUtf8(letters), letters);
	const std::string other = "\uFFFD";
	EXPECT_EQ(validUtf8("caf\xe9"), "caf" + other);
	EXPECT_EQ(validUtf8("\xc3"), other);
	EXPECT_EQ(validUtf8("\xc3(\x80"), other + "(" + other);
	EXPECT_EQ(validUtf8("\xc0\xaf"), other + other); // longer than need be
	EXPECT_EQ(validUtf8("\xe0\x9f\xbf"), other + other + other);
	EXPECT_EQ(validUtf8("\xed\xa0\x80"), other + other + other); // half a pair
	EXPECT_EQ(validUtf8("\xf4\x90\x80\x80x"), other + other + other + other + "x");
	EXPECT_EQ(validUtf8("\xf5\xff"), other + other);
}

} // namespace vp::render
