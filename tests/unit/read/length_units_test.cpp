#include "vprobe-read/text/length_units.h"

#include <gtest/gtest.h>

using vp::reader::text::lengthSign;
using vp::reader::text::metersOf;
using vp::reader::text::OneLengthUnit;
using vp::reader::text::oneLengthUnit;

namespace
{

TEST(LengthUnits, AreKnownByEveryNameThatProgramsWrite)
{
	for (const char* micron : {"um", "\xC2\xB5m", "\xCE\xBCm", "\xB5m", "\\u00B5m", "micron", "Microns", "micrometers",
	                           "micrometre", " \xC2\xB5m "})
	{
		EXPECT_EQ(metersOf(micron), 1e-6) << micron;
		EXPECT_EQ(lengthSign(micron), "\xC2\xB5m") << micron;
	}
	for (const char* angstrom : {"\xC3\x85", "\xE2\x84\xAB", "A", "angstrom", "Angstroms", "\xC3\xA5ngstr\xC3\xB6m"})
		EXPECT_EQ(metersOf(angstrom), 1e-10) << angstrom;
	EXPECT_EQ(metersOf("mm"), 1e-3);
	EXPECT_EQ(metersOf("MM"), 1e-3);
	EXPECT_EQ(metersOf("Mm"), 1e6);
	EXPECT_EQ(metersOf("centimeters"), 1e-2);
	EXPECT_EQ(metersOf("inches"), 0.0254);
	EXPECT_EQ(metersOf("m"), 1.0);
	EXPECT_EQ(metersOf("meters"), 1.0);
	for (const char* none : {"pixel", "", "ms", "s", "degrees", "reference frame"})
		EXPECT_FALSE(metersOf(none)) << none;
	EXPECT_EQ(lengthSign("pixel"), "");
	EXPECT_EQ(lengthSign("degrees"), "degrees");
}

TEST(LengthUnits, OfAxesBecomeThatOfTheFirst)
{
	const OneLengthUnit one = oneLengthUnit({"nm", "nm", "um"});
	EXPECT_EQ(one.sign, "nm");
	EXPECT_DOUBLE_EQ(one.factors[1], 1.0);
	EXPECT_NEAR(one.factors[2], 1000.0, 1e-9);
	EXPECT_FALSE(one.differ);
	EXPECT_TRUE(oneLengthUnit({"nm", "nm", "pixel"}).differ);
	EXPECT_EQ(oneLengthUnit({"furlong", "furlong", "furlong"}).sign, "furlong");
}

} // namespace
