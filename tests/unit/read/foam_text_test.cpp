// Files of OpenFOAM, as this program reads them beside VTK's reader.
#include "foam_text.h"
#include "refusal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace
{

std::string foamFile(const std::string& type, const std::string& body, const std::string& format = "ascii",
                     const std::string& arch = "LSB;label=32;scalar=64")
{
	return "/*--*\\ a banner \\*--*/\nFoamFile\n{\n    version 2.0; // a word\n    format " + format +
	       ";\n    arch \"" + arch + "\";\n    class " + type +
	       ";\n    location \"1\";\n    object grad(T);\n}\n// * * //\n" + body;
}

template <class Number>
std::string bytesOfNumbers(const std::vector<Number>& numbers)
{
	std::string bytes(numbers.size() * sizeof(Number), '\0');
	std::memcpy(bytes.data(), numbers.data(), bytes.size());
	return bytes;
}

using Numbers = std::vector<double>;
using Whole = std::vector<std::int64_t>;

} // namespace

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
	EXPECT_THROW(foamHead(foamFile("volScalarField", "", "binary", "MSB;label=32;scalar=64")), Refusal);
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
	EXPECT_EQ(foamLabels(foamFile("labelList", "3(7 8\n9)")), (Whole{7, 8, 9}));
	EXPECT_EQ(foamLabels(foamFile("labelList", "2(" + bytesOfNumbers(Whole{1, 5000000000}) + ")", "binary",
	                              "LSB;label=64;scalar=64")),
	          (Whole{1, 5000000000}));
	EXPECT_EQ(foamLabels(foamFile("labelList", "0()")), Whole{});
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
	const auto patches = foamPatches(foamFile("polyBoundaryMesh",
	                                          "2(\nin { type patch; inGroups 1(patch); nFaces 4; startFace 38; }\n"
	                                          "\"w.2\"\n{ type wall; nFaces 6; startFace 42; offset (0 0 1); }\n)\n"));
	ASSERT_EQ(patches.size(), 2u);
	EXPECT_EQ(patches[0].name, "in");
	EXPECT_EQ(patches[1].type, "wall");
	EXPECT_EQ(patches[1].first, 42);
	EXPECT_EQ(patches[1].faces, 6);
}

TEST(FoamText, FieldsWithWordsThatAreNotRead)
{
	const std::string bytes = bytesOfNumbers(Numbers{6700000.25, std::nan("")});
	const FoamField field = foamField(
	    foamFile("volScalarField",
	             "#include \"constants\"\nv 7;\ndimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar> 2(" +
	                 bytes + ");\nboundaryField\n{\n \"in.*\" { type fixedValue; value uniform 1; }\n" +
	                 " zero { type zeroGradient; }\n words { type fixedValue; value $v; }\n" +
	                 " macro { $zero; }\n table { type uniformFixedValue; uniformValue constant 4; }\n" +
	                 " mixed { type mixed; refValue nonuniform List<scalar> 1(" + bytesOfNumbers(Numbers{1e9}) +
	                 "); gradients { a (1 2); } value nonuniform List<scalar> 2(" + bytesOfNumbers(Numbers{8, 9}) +
	                 "); }\n none { value nonuniform 0(); }\n}\n",
	             "binary"));
	EXPECT_EQ(field.inside.numbers[0], 6700000.25);
	EXPECT_TRUE(std::isnan(field.inside.numbers[1]));
	ASSERT_EQ(field.patches.size(), 3u);
	EXPECT_FALSE(field.patches.at("zero"));
	EXPECT_EQ(field.patches.at("mixed")->numbers, (Numbers{8, 9}));
	EXPECT_EQ(field.patches.at("none")->size(), 0u);
}

TEST(FoamText, ElementsOfEachKind)
{
	const FoamList one = foamField(foamFile("volVectorField", "internalField uniform (1 2 3);\n")).inside;
	EXPECT_TRUE(one.is_uniform);
	EXPECT_EQ(one.numbers, (Numbers{1, 2, 3}));
	const FoamList alike =
	    foamField(foamFile("pointSymmTensorField", "internalField nonuniform List<symmTensor> 9{(1 2 3 4 5 6)};\n"))
	        .inside;
	EXPECT_TRUE(alike.is_uniform);
	EXPECT_EQ(alike.components, 6);
	EXPECT_EQ(
	    foamField(foamFile("volSphericalTensorField", "internalField nonuniform List<sphericalTensor> 2((4) (5));\n"))
	        .inside.numbers,
	    (Numbers{4, 5}));
}

TEST(FoamText, CountsThatAreNotThere)
{
	for (const char* body : {"99999999999 ((1 2 3))", "-1 ()", "2 ((1 2 3))", "1 ((1 2))", "1 ((1 2 x))", "1", ""})
		EXPECT_THROW(foamPoints(foamFile("vectorField", body)), Refusal) << body;
	EXPECT_THROW(foamPoints(foamFile("vectorField", "100(12345678)", "binary")), Refusal);
	EXPECT_THROW(foamField(foamFile("volScalarField", "internalField nonuniform List<vector> 1((1 2 3));")), Refusal);
	EXPECT_THROW(foamField(foamFile("volScalarField", "dimensions [0];")), Refusal);
	EXPECT_THROW(foamField(foamFile("surfaceScalarField", "internalField uniform 1;")), Refusal);
}
