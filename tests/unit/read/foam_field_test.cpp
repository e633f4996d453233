// Fields of OpenFOAM: values, macros, included files, patterns and groups. The right values are worked out by hand.
#include "vprobe-read/formats/codes/foam_field.h"

#include "foam_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using vp::reader::Refusal;
using vp::reader::codes::FoamDocument;
using vp::reader::codes::FoamField;
using vp::reader::codes::foamField;
using vp::reader::codes::FoamFiles;
using vp::reader::codes::FoamPatch;
using vp::reader::codes::FoamPatchValues;
using vp::reader::codes::FoamSource;
using vp::reader::codes::FoamUnknown;
using vp::reader::codes::parseFoam;

namespace
{

using Numbers = std::vector<double>;

const std::vector<FoamPatch> kPatches = {{"inlet", "patch", {"open"}, 10, 1},
                                         {"outlet", "patch", {"open"}, 11, 1},
                                         {"walls", "wall", {"wall", "hot"}, 12, 2},
                                         {"front", "empty", {}, 14, 2}};

// A field of two cells; files that it may include, by their names.
class Field
{
public:
	explicit Field(std::string text, std::map<std::string, std::string> others = {})
	    : text_(std::move(text)), others_(std::move(others))
	{
		const FoamFiles files = {"/case/0/T", "/case", [&](const auto& path) { return open(path); }};
		document_ = parseFoam(text_, files);
		field_ = foamField(*document_, 2, kPatches);
	}

	const Numbers& inside() const { return field_.inside->numbers; }
	const FoamPatchValues& at(std::size_t patch) const { return field_.patches.at(patch); }
	// The first number at a patch; NaN if it takes the values of the cells.
	double first(std::size_t patch) const { return at(patch).values ? at(patch).values->numbers.at(0) : NAN; }

private:
	std::optional<FoamSource> open(const std::filesystem::path& path) const
	{
		const auto found = others_.find(path.lexically_normal().string());
		return found == others_.end() ? std::nullopt : std::optional(FoamSource{found->first, nullptr, found->second});
	}

	std::string text_;
	std::map<std::string, std::string> others_;
	std::unique_ptr<FoamDocument> document_;
	FoamField field_;
};

Field scalars(const std::string& body, std::map<std::string, std::string> others = {})
{
	return Field(foamFile("volScalarField", body), std::move(others));
}

std::string whyUnknown(const std::string& body)
{
	try
	{
		scalars(body);
	}
	catch (const FoamUnknown& unknown)
	{
		return unknown.what();
	}
	return {};
}

const std::string kTwo = "internalField nonuniform List<scalar> 2(3 5);\n";

} // namespace

TEST(FoamField, ElementsOfEachKind)
{
	EXPECT_EQ(Field(foamFile("volVectorField", "internalField uniform (1 2 3);")).inside(), (Numbers{1, 2, 3}));
	EXPECT_EQ(
	    Field(foamFile("volSymmTensorField", "internalField nonuniform List<symmTensor> 2{(1 2 3 4 5 6)};")).inside(),
	    (Numbers{1, 2, 3, 4, 5, 6}));
	EXPECT_EQ(Field(foamFile("volSphericalTensorField", "internalField nonuniform List<sphericalTensor> 2((4) (5));"))
	              .inside(),
	          (Numbers{4, 5}));
	EXPECT_EQ(Field(foamFile("volTensorField", "internalField uniform (1 2 3 4 5 6 7 8 9);")).inside().size(), 9u);
	EXPECT_EQ(scalars("internalField nonuniform 2 ( 3 5 );").inside(), (Numbers{3, 5}));
	EXPECT_EQ(scalars("internalField nonuniform (3 5);").inside(), (Numbers{3, 5}));
	EXPECT_EQ(scalars("internalField nonuniform List<scalar> (3 5);").inside(), (Numbers{3, 5}));
	EXPECT_EQ(scalars("internalField uniform [0 1 -1 0 0] 3;").inside(), Numbers{3});
	EXPECT_EQ(scalars("dimensions [0 0 0 0 0];\nvalue nonuniform List<scalar> 2(3 5);").inside(), (Numbers{3, 5}));
	EXPECT_EQ(scalars(kTwo + "referenceLevel 100;\nboundaryField { inlet { value uniform 1; } }").inside(),
	          (Numbers{103, 105}));
}

TEST(FoamField, NumbersOfADivergedRun)
{
	const Field field = scalars("internalField nonuniform List<scalar> 2(-nan 1.#IND);\n"
	                            "boundaryField { inlet { value uniform inf; } outlet { value uniform 1.0-100; } }");
	EXPECT_TRUE(std::isnan(field.inside()[0]));
	EXPECT_TRUE(std::isnan(field.inside()[1]));
	EXPECT_TRUE(std::isinf(field.first(0)));
	EXPECT_EQ(field.first(1), 1e-100);
}

TEST(FoamField, Macros)
{
	const Field field = scalars("v 7; $none; deep { w 8; x { y 9; up $..w; top $:v; } }\n"
	                            "T uniform 4; twice $T;\ninternalField $twice; // a comment\n"
	                            "calm { type zeroGradient; }\nboundaryField\n{\n"
	                            " inlet { type fixedValue; value uniform $v; }\n"
	                            " outlet { $inlet; value uniform ${:deep.x.up}; }\n"
	                            " walls { value $internalField; }\n}\n");
	EXPECT_EQ(field.inside(), Numbers{4});
	EXPECT_EQ(field.first(0), 7);
	EXPECT_EQ(field.first(1), 8);
	EXPECT_EQ(field.first(2), 4);
	EXPECT_EQ(scalars("a { b 3; }\ninternalField uniform $a/b;").inside(), Numbers{3});
	EXPECT_EQ(scalars("a { b 3; c { d uniform $../b; } }\ninternalField $!a/c/d;").inside(), Numbers{3});
	EXPECT_EQ(scalars("internalField uniform ${none:-5};").inside(), Numbers{5});
	EXPECT_EQ(Field(foamFile("volVectorField", "Ux 2;\ninternalField uniform ($Ux 0 ${Ux});")).inside(),
	          (Numbers{2, 0, 2}));
	EXPECT_EQ(
	    scalars(kTwo +
	            "v uniform 6;\nboundaryField { \".*\" { value uniform 1; } inlet { value $v; } outlet { $some; } }")
	        .first(0),
	    6);
	EXPECT_EQ(scalars(kTwo + "boundaryField { \".*\" { value uniform 1; } outlet { $some; } }").first(1), 1);
	EXPECT_EQ(scalars("a { $..b; } b { c 1; } a { c 2; $..b; } internalField uniform $a.c;").inside(), Numbers{1});
	EXPECT_EQ(scalars(kTwo + "boundaryField { inlet { value uniform 6; } outlet $inlet; }").first(1), 6);
}

TEST(FoamField, PatternsAndGroups)
{
	const Field field =
	    scalars(kTwo + "boundaryField\n{\n \".*\" { value uniform 1; }\n \"(inlet|outlet).*\" { value uniform 2; }\n"
	                   " hot { value nonuniform List<scalar> 2(3 4); }\n inlet { type zeroGradient; }\n}\n");
	EXPECT_FALSE(field.at(0).values);
	EXPECT_EQ(field.first(1), 2);
	EXPECT_EQ(field.first(2), 3);
	EXPECT_EQ(field.first(3), 1);
	// The last group wins, and a group wins over a pattern that follows.
	const Field groups = scalars(
	    kTwo + "boundaryField { wall { value uniform 1; } hot { value uniform 2; } \".*\" { value uniform 3; } }");
	EXPECT_EQ(groups.first(2), 2);
	EXPECT_EQ(groups.first(0), 3);
	EXPECT_THROW(scalars(kTwo + "boundaryField { \"a{1,200}\" { value uniform 1; } }"), Refusal);
	EXPECT_THROW(scalars(kTwo + "boundaryField { \"(\" { value uniform 1; } }"), Refusal);
}

TEST(FoamField, FilesThatItIncludes)
{
	const Field field =
	    scalars("#include \"../constant/values\"\n#includeIfPresent \"none\"\n#includeEtc \"caseDicts/a\"\n"
	            "internalField nonuniform #include \"list\";\nboundaryField\n{\n"
	            " #include \"$FOAM_CASE/system/patches\"\n outlet { value uniform $v; }\n}\n",
	            {{"/case/constant/values", "v 7; name \"deep\";\n#include \"more\"\n"},
	             {"/case/constant/more", "w 9;"},
	             {"/case/0/list", "List<scalar> 2(3 5)\n"},
	             {"/case/system/patches", "inlet { value uniform $w; }\nwalls { type noSlip; }"}});
	EXPECT_EQ(field.inside(), (Numbers{3, 5}));
	EXPECT_EQ(field.first(0), 9);
	EXPECT_EQ(field.first(1), 7);
	EXPECT_EQ(field.first(2), 0);
	EXPECT_THROW(scalars("#include \"T\"\ninternalField uniform 1;", {{"/case/0/T", "#include \"T\""}}), Refusal);
}

TEST(FoamField, ModesAndConditions)
{
	EXPECT_EQ(scalars("v 1; v 2; internalField uniform $v;").inside(), Numbers{2});
	EXPECT_EQ(scalars("v 1; #inputMode protect\nv 2; #inputMode merge\ninternalField uniform $v;").inside(),
	          Numbers{1});
	EXPECT_EQ(scalars("d { v 1; } d { w 2; } internalField uniform $d.v;").inside(), Numbers{1});
	EXPECT_NE(whyUnknown("d { v 1; } #inputMode overwrite\nd { w 2; } internalField uniform $d.v;"), "");
	EXPECT_EQ(scalars("#ifeq a b\nv 1;\n#else\nv 2;\n#endif\ninternalField uniform $v;").inside(), Numbers{2});
	EXPECT_EQ(scalars("on 1;\n#if $on\nv 1;\n#if false\nv 3;\n#endif\n#else\nv 2;\n#endif\ninternalField uniform $v;")
	              .inside(),
	          Numbers{1});
	EXPECT_EQ(scalars("v 1; w 2; #remove v\nv 3; internalField uniform $v;").inside(), Numbers{3});
}

TEST(FoamField, WhatIsNotKnownIsSaid)
{
	EXPECT_EQ(whyUnknown("internalField uniform $v;"), "$v is not defined");
	EXPECT_EQ(whyUnknown("#include \"none\"\ninternalField uniform $v;"),
	          "$v is not defined; a file of #include is not there");
	EXPECT_EQ(whyUnknown("internalField uniform #calc \"1 + 2\";"), "#calc is not run");
	EXPECT_EQ(
	    whyUnknown("internalField #codeStream { codeInclude #{ #include \"fvCFD.H\" #}; code #{ return; } #}; };"),
	    "#codeStream is not run");
	EXPECT_EQ(whyUnknown("internalField uniform [mm] 3;"), "its unit [mm] is not converted");
	EXPECT_EQ(whyUnknown("dimensions [0];"), "it has no internalField");
	const Field field = scalars(kTwo + "#calc \"int i = 1;\"\nboundaryField { inlet { value uniform $v; } outlet { "
	                                   "type uniformFixedValue; uniformValue "
	                                   "table ((0 1)(1 2)); } walls { value nonuniform List<scalar> 3(1 2 3); } }");
	EXPECT_EQ(field.at(0).unknown, "$v is not defined; #calc is not run");
	EXPECT_EQ(field.at(1).unknown, "its uniformValue is no constant; #calc is not run");
	EXPECT_EQ(field.at(2).unknown, "it has 3 values for 2 faces; #calc is not run");
	EXPECT_EQ(field.at(3).unknown, ""); // it follows from the geometry
	EXPECT_EQ(scalars(kTwo + "boundaryField { inlet { type uniformFixedValue; uniformValue constant 4; } }").first(0),
	          4);
}

TEST(FoamField, BytesBesideWords)
{
	const auto bytes = [](const Numbers& numbers) { return bytesOfNumbers(numbers); };
	const std::string body =
	    "internalField nonuniform List<scalar> 2(" + bytes({6700000.25, NAN}) +
	    ");\nboundaryField\n{\n inlet { refValue nonuniform List<vector> 1(" + bytes({1e9, 2, 3}) +
	    "); flags nonuniform List<bool> 2(}{); gradients { a (1 2); } value nonuniform List<scalar> 1(" + bytes({8}) +
	    "); }\n walls { names List<word> 2(a b); value nonuniform List<scalar> 2{4}; }\n}\n";
	const Field field(foamFile("volScalarField", body, "binary"));
	EXPECT_EQ(field.inside()[0], 6700000.25);
	EXPECT_TRUE(std::isnan(field.inside()[1]));
	EXPECT_EQ(field.first(0), 8);
	EXPECT_EQ(field.first(2), 4);
}

TEST(FoamField, DamageIsRefused)
{
	for (const char* body :
	     {"internalField nonuniform List<scalar> 3(1 2 3);", "internalField nonuniform List<scalar> 2(1 2 3);",
	      "internalField nonuniform List<scalar> 2(1);", "internalField nonuniform List<scalar> 0();",
	      "internalField nonuniform List<scalar> 3{1};", "internalField nonuniform List<vector> 2((1 2 3)(4 5 6));",
	      "internalField uniform 1 2;", "internalField uniform (1 2);", "internalField uniform one;",
	      "internalField uniform 1", "internalField uniform 1; }", "internalField uniform 1; boundaryField { inlet {",
	      "internalField nonuniform 3 (1 2);", "#if true\ninternalField uniform 1;",
	      "internalField nonuniform 1e99 (1 2);"})
		EXPECT_THROW(scalars(body), Refusal) << body;
	EXPECT_THROW(Field(foamFile("surfaceScalarField", "internalField uniform 1;")), Refusal);
	// Each line doubles what the one before it holds.
	std::string doubles = "a0 1 1 1 1;\n";
	for (int i = 1; i < 40; ++i)
		doubles += "a" + std::to_string(i) + " $a" + std::to_string(i - 1) + " $a" + std::to_string(i - 1) + ";\n";
	EXPECT_THROW(scalars(doubles + "internalField uniform 1;"), Refusal);
	std::string nested;
	for (int i = 0; i < 10000; ++i)
		nested += "a { ";
	EXPECT_THROW(scalars(nested), Refusal);
}
