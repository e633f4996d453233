#include "base/control_letters.h"

#include <gtest/gtest.h>

using namespace vp;

TEST(ControlLetters, AreEscapedAndOthersStay)
{
	EXPECT_EQ(withEscapes("a b.vtu"), "a b.vtu");
	EXPECT_EQ(withEscapes("\x1b[2J\n"), "\\x1b[2J\\x0a");
	EXPECT_EQ(withEscapes("a\u009bb\u202ec\u2066"), "a\\u009bb\\u202ec\\u2066");
	EXPECT_EQ(withEscapes("Größe \u03c3 \u65e5\u672c \u2212\u00a0"), "Größe \u03c3 \u65e5\u672c \u2212\u00a0");
	// Bytes that are no UTF-8 stay as they are.
	EXPECT_EQ(withEscapes("\xff\xc2"), "\xff\xc2");
}
