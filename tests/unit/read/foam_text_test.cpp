// Files of OpenFOAM with lists of points, faces, labels and patches.
#include "vprobe-read/formats/codes/foam_text.h"

#include "foam_samples.h"
#include "vprobe-read/base/refusal.h"

#include <gtest/gtest.h>

using vp::reader::Refusal;
using vp::reader::codes::FoamFaces;
using vp::reader::codes::foamFaces;
using vp::reader::codes::FoamHead;
using vp::reader::codes::foamHead;
using vp::reader::codes::foamLabels;
using vp::reader::codes::FoamList;
using vp::reader::codes::foamPatches;
using vp::reader::codes::foamPoints;

using Numbers = std::vector<double>;
using Whole = std::vector<std::int64_t>;

TEST(FoamText, HeadsSayWhatFollows)
{
	const FoamHead head = foamHead(foamFile("volScalarField", "", "binary", "LSB;label=64;scalar=32"));
	EXPECT_EQ(head.type, "volScalarField");
	EXPECT_EQ(head.object, "grad(T)");
	EXPECT_TRUE(head.is_binary);
	EXPECT_EQ(head.label_bytes, 8);
	EXPECT_EQ(head.scalar_bytes, 4);
	EXPECT_FALSE(head.isDouble());
	EXPECT_TRUE(foamHead(foamFile("volScalarField", "", "ascii", "LSB;label=64;scalar=32")).isDouble());
	EXPECT_THROW(foamHead("a { }"), Refusal);
}

TEST(FoamText, ListsAsTextAndBytes)
{
	const FoamList text = foamPoints(foamFile("vectorField", "2\n(\n(6700000.123456789 -1 2e-3)\n( 4 5 +6 )\n)\n"));
	EXPECT_EQ(text.numbers, (Numbers{6700000.123456789, -1, 2e-3, 4, 5, 6}));
	const Numbers written = {6700000.123456789, 2, 3};
	EXPECT_EQ(foamPoints(foamFile("vectorField", "1(" + bytesOfNumbers(written) + ")", "binary")).numbers, written);
	EXPECT_EQ(foamPoints(foamFile("vectorField", "1(" + bytesOfNumbers(std::vector<float>{1.5f, 2, 3}) + ")", "binary",
	                              "LSB;label=32;scalar=32"))
	              .numbers,
	          (Numbers{1.5, 2, 3}));
	const auto labels = [](const std::string& body, const std::string& format = "ascii")
	{ return foamLabels(foamFile("labelList", body, format, "LSB;label=64;scalar=64"), 100); };
	EXPECT_EQ(labels("3(7 8/*a comment*/9//another\n)"), (Whole{7, 8, 9}));
	EXPECT_EQ(labels("2(" + bytesOfNumbers(Whole{1, 5000000000}) + ")", "binary"), (Whole{1, 5000000000}));
	EXPECT_EQ(labels("0()"), Whole{});
	EXPECT_EQ(labels("4{7}"), (Whole{7, 7, 7, 7}));
	EXPECT_THROW(labels("4000000000{7}"), Refusal);
}

TEST(FoamText, BytesInTheOtherOrder)
{
	const std::string one("\x3f\xf8\0\0\0\0\0\0", 8), two("\x40\0\0\0\0\0\0\0", 8), seven("\0\0\0\7", 4);
	EXPECT_EQ(
	    foamPoints(foamFile("vectorField", "1(" + one + two + one + ")", "binary", "MSB;label=32;scalar=64")).numbers,
	    (Numbers{1.5, 2, 1.5}));
	EXPECT_EQ(foamLabels(foamFile("labelList", "1(" + seven + ")", "binary", "MSB;label=32;scalar=64"), 1), Whole{7});
}

TEST(FoamText, FacesInBothWays)
{
	const FoamFaces plain = foamFaces(foamFile("faceList", "2\n(\n3(0 1 2)\n4(3 2 1 0)\n)\n"));
	EXPECT_EQ(plain.starts, (Whole{0, 3, 7}));
	EXPECT_EQ(plain.corners, (Whole{0, 1, 2, 3, 2, 1, 0}));
	const FoamFaces compact = foamFaces(foamFile("faceCompactList",
	                                             "2(" + bytesOfNumbers(std::vector<std::int32_t>{0, 3}) + ")\n3(" +
	                                                 bytesOfNumbers(std::vector<std::int32_t>{5, 6, 7}) + ")",
	                                             "binary"));
	EXPECT_EQ(compact.corners, (Whole{5, 6, 7}));
	EXPECT_THROW(foamFaces(foamFile("faceCompactList", "2(0 4)3(5 6 7)")), Refusal);
}

TEST(FoamText, PatchesOfTheBoundary)
{
	const auto patches =
	    foamPatches(foamFile("polyBoundaryMesh", "3\n(\nin { type patch; inGroups 1(patch); nFaces 4; startFace 38; }\n"
	                                             "\"w.2\"\n{ type wall; inGroups List<word> 2(wall hot);\n nFaces 6; "
	                                             "startFace 42; offset (0 0 1); }\n/* the last */ out { type patch; "
	                                             "inGroups (open); nFaces 0; startFace 48; }\n)\n"));
	ASSERT_EQ(patches.size(), 3u);
	EXPECT_EQ(patches[0].name, "in");
	EXPECT_EQ(patches[0].groups, (std::vector<std::string>{"patch"}));
	EXPECT_EQ(patches[1].name, "w.2");
	EXPECT_EQ(patches[1].type, "wall");
	EXPECT_EQ(patches[1].groups, (std::vector<std::string>{"wall", "hot"}));
	EXPECT_EQ(patches[1].first, 42);
	EXPECT_EQ(patches[1].faces, 6);
	EXPECT_EQ(patches[2].groups, (std::vector<std::string>{"open"}));
	EXPECT_THROW(foamPatches(foamFile("polyBoundaryMesh", "1 ( a { type wall; nFaces -1; startFace 0; } )")), Refusal);
	EXPECT_THROW(foamPatches(foamFile("polyBoundaryMesh", "1 ( a { type wall; startFace 0; } )")), Refusal);
}

TEST(FoamText, CountsThatAreNotThere)
{
	for (const char* body :
	     {"99999999999 ((1 2 3))", "-1 ()", "2 ((1 2 3))", "1 ((1 2 3) (4 5 6))", "1 ((1 2))", "1 ((1 2 x))", "1", ""})
		EXPECT_THROW(foamPoints(foamFile("vectorField", body)), Refusal) << body;
	EXPECT_THROW(foamPoints(foamFile("vectorField", "100(12345678)", "binary")), Refusal);
}
