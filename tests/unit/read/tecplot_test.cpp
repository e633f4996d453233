// Spellings of Tecplot text files. The right values are worked out by hand, after the Tecplot 360 Data Format Guide.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/meshes/tecplot_file.h"

#include <gtest/gtest.h>

#include <cmath>

using vp::reader::Refusal;
using vp::reader::meshes::parseTecplot;
using vp::reader::meshes::TecplotFile;

namespace
{

using Numbers = std::vector<double>;
using Names = std::vector<std::string>;

const std::string kFour = "VARIABLES = \"X\", \"Y\" \"Z\"\n \"V\"\n";
const std::string kPlaces = "0 1 1 0 0 1 1 0\n0 0 1 1 0 0 1 1\n0 0 0 0 1 1 1 1\n"; // corners of a cube

const Numbers& values(const TecplotFile& file, std::size_t zone, std::size_t variable)
{
	return *file.zones.at(zone).values.at(variable);
}

std::string whyRefused(const std::string& text)
{
	try
	{
		parseTecplot(text);
	}
	catch (const Refusal& refusal)
	{
		return refusal.what();
	}
	return {};
}

} // namespace

TEST(Tecplot, NamesOfVariables)
{
	const auto names = [](const std::string& variables)
	{ return parseTecplot(variables + "\nTEXT T=\"a\"").variables; };
	EXPECT_EQ(names("VARIABLES = X, Y Z"), (Names{"X", "Y", "Z"}));
	EXPECT_EQ(names("variables=\"X [m]\"\n\"p, static\",\n'it \"s\"' # more\n \"two\nlines\""),
	          (Names{"X [m]", "p, static", "it \"s\"", "two lines"}));
	EXPECT_EQ(names("VARIABLES = \"a \\\"b\\\"\""), (Names{"a \"b\""}));
	EXPECT_EQ(names("VARIABLES = V V V W"), (Names{"V", "V (2)", "V (3)", "W"}));
}

TEST(Tecplot, NumbersInEverySpelling)
{
	const TecplotFile file = parseTecplot(kFour + "ZONE I=2 J=2 F=POINT # a comment\n3*0.0 nan\n1D2,1.0-100, .5, -INF\n"
	                                              "+1.5E+1 -2 1.#QNAN 1d-3\n4*7\n");
	EXPECT_EQ(values(file, 0, 0), (Numbers{0, 100, 15, 7}));
	EXPECT_EQ(values(file, 0, 1), (Numbers{0, 1e-100, -2, 7}));
	EXPECT_TRUE(std::isnan(values(file, 0, 2)[2]));
	EXPECT_TRUE(std::isnan(values(file, 0, 3)[0]));
	EXPECT_EQ(values(file, 0, 3)[1], -INFINITY);
	EXPECT_EQ(values(file, 0, 3)[2], 1e-3);
	// The first value need not begin with a digit, and the number of points may be left to the values.
	EXPECT_EQ(values(parseTecplot(kFour + "ZONE\nnan 1 2 3\n-nan 4 5 6\n"), 0, 3), (Numbers{3, 6}));
}

TEST(Tecplot, PlacesOfVariables)
{
	const auto place = [](const std::string& list)
	{
		return parseTecplot(kFour + "ZONE NODES=8 ELEMENTS=1 ZONETYPE=FEBRICK DATAPACKING=BLOCK VARLOCATION=" + list +
		                    "\n" + kPlaces + "7\n1 2 3 4 5 6 7 8\n");
	};
	for (const char* list : {"([4]=CELLCENTERED)", "(NODAL,NODAL,NODAL,CELLCENTERED)", "(3*NODAL CellCentered)",
	                         "( [1-3] = NODAL, [4] = CELLCENTERED )", "(4=cellcentered)", "([4-4]=CELLCENTERED)"})
	{
		const TecplotFile file = place(list);
		EXPECT_EQ(file.zones[0].cell_variables, (std::set<std::size_t>{3})) << list;
		EXPECT_EQ(values(file, 0, 3), Numbers{7}) << list;
	}
	for (const char* list :
	     {"([5]=CELLCENTERED)", "([4]=MIDDLE)", "(NODAL,NODAL,NODAL,NODAL,NODAL)", "([4]=CELLCENTERED"})
		EXPECT_THROW(place(list), Refusal) << list;
}

TEST(Tecplot, VariablesThatAreSharedOrPassive)
{
	const std::string first =
	    kFour + "ZONE N=8 E=1 F=FEBLOCK ET=BRICK\n" + kPlaces + "1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7 8\n";
	for (const char* head :
	     {"ZONETYPE=FEBRICK NODES=8 ELEMENTS=1 DATAPACKING=BLOCK VARSHARELIST=([1-3]=1) CONNECTIVITYSHAREZONE=1",
	      "ZONETYPE=FEBRICK NODES=8 ELEMENTS=1 DATAPACKING=BLOCK VARSHARELIST=([1,2,3]) CONNECTIVITYSHAREZONE=1",
	      "N=8, E=1, F=FEPOINT, ET=BRICK, D=(1,2,3,FECONNECT)"})
	{
		const TecplotFile file = parseTecplot(first + "ZONE " + head + "\n11 12 13 14 15 16 17 18\n");
		EXPECT_EQ(values(file, 1, 0), values(file, 0, 0)) << head;
		EXPECT_EQ(values(file, 1, 3)[7], 18) << head;
		EXPECT_EQ(*file.zones[1].corners, *file.zones[0].corners) << head;
	}
	for (const char* list : {"[4]", "([4])", "[4-4]", "([4-5:2])"})
	{
		const TecplotFile file =
		    parseTecplot("VARIABLES = X Y Z V W\nZONE I=2 DATAPACKING=POINT PASSIVEVARLIST=" + std::string(list) +
		                 "\n1 2 3 9\n4 5 6 8\n");
		EXPECT_EQ(file.zones[0].values[3], nullptr) << list;
		EXPECT_EQ(values(file, 0, 4), (Numbers{9, 8})) << list;
	}
	EXPECT_THROW(parseTecplot(kFour + "ZONE I=1 VARSHARELIST=([1]=1)\n2 3 4"), Refusal);
}

TEST(Tecplot, RecordsBetweenZones)
{
	const TecplotFile file = parseTecplot("FILETYPE=FULL\nTITLE=\"ZONE\"\n" + kFour +
	                                      "DATASETAUXDATA Common.Run=\"ZONE 1\"\nVARAUXDATA 4 unit='K'\n"
	                                      "TEXT X=50, Y=50, CS=FRAME, HU=POINT\nT=\"line one\nZONE two\" "
	                                      "ZN=1\nGEOMETRY X=0 Y=0 T=LINE3D, C=RED, CS=GRID3D\n1\n2\n"
	                                      "0 0 0\n1 1 1\nCUSTOMLABELS \"ZONE\", 'TUE'\nZONE I=1, DT=(SINGLE SINGLE "
	                                      "DOUBLE DOUBLE), AUXDATA a.b=\"1, 2\", C=RED\n"
	                                      "T=\"it's\", PARENTZONE=0\n1 2 3 4\nTEXT T=\"end\"\n");
	ASSERT_EQ(file.zones.size(), 1u);
	EXPECT_EQ(file.zones[0].title, "it's");
	EXPECT_EQ(values(file, 0, 3), Numbers{4});
}

TEST(Tecplot, TimesAndStrands)
{
	const TecplotFile file =
	    parseTecplot(kFour + "ZONE I=1 SOLUTIONTIME=1.5D0 STRANDID=2\n1 2 3 4\nZONE I=1 SOLUTIONTIME=2 STRANDID=0\n"
	                         "1 2 3 4\nZONE I=1 SOLUTIONTIME=3\n1 2 3 4\nZONE I=1 SOLUTIONTIME=nan\n1 2 3 4\n");
	EXPECT_EQ(file.zones[0].time, 1.5);
	EXPECT_FALSE(file.zones[1].time); // without a strand: shown at all times
	EXPECT_EQ(file.zones[2].time, 3.0);
	EXPECT_FALSE(file.zones[3].time);
}

TEST(Tecplot, Polyhedra)
{
	const std::string head = kFour +
	                         "ZONE NODES=8 ELEMENTS=1 FACES=6 TOTALNUMFACENODES=24 NUMCONNECTEDBOUNDARYFACES=0\n"
	                         "TOTALNUMBOUNDARYCONNECTIONS=0 ZONETYPE=FEPOLYHEDRON VARLOCATION=([4]=CELLCENTERED)\n" +
	                         kPlaces + "7\n";
	const std::string nodes = "4 4 4 4 4 4\n1 4 3 2 5 6 7 8 1 2 6 5 2 3 7 6 3 4 8 7 4 1 5 8\n";
	const TecplotFile file = parseTecplot(head + nodes + "1 1 1 1 1 1\n0 0 0 0 0 0\n");
	ASSERT_TRUE(file.zones[0].faces);
	EXPECT_EQ(file.zones[0].faces->starts.back(), 24);
	EXPECT_EQ(file.zones[0].faces->corners[1], 3);
	EXPECT_EQ(file.zones[0].faces->left[5], 0);
	EXPECT_EQ(file.zones[0].faces->right[5], -1);
	for (const char* sides : {"1 1 1 1 1 2\n0 0 0 0 0 0\n", "1 1 1 1 1 1\n0 0 0 0 0\n", "1 1 1 1 1 1\n0 0 0 0 0 -1\n",
	                          "1 1 1 1 1 1\n0 0 0 0 0 0 0\n"})
		EXPECT_THROW(parseTecplot(head + nodes + sides), Refusal) << sides;
	EXPECT_THROW(parseTecplot(head + "4 4 4 4 4 3\n"), Refusal);
}

TEST(Tecplot, CountsThatDoNotFit)
{
	EXPECT_NE(whyRefused(kFour + "ZONE I=2 F=POINT\n1 2 3 4 5 6 7 8 9\n").find("more values"), std::string::npos);
	EXPECT_NE(whyRefused(kFour + "ZONE I=2 F=POINT\n1 2 3 4 5*6\n").find("more values"), std::string::npos);
	EXPECT_NE(whyRefused(kFour + "ZONE I=2 F=POINT\n1 2 3 4 5 6 7\n").find("ends before"), std::string::npos);
	EXPECT_NE(whyRefused(kFour + "ZONE I=2 F=POINT\n1 2 3 4 5 6 7\nZONE I=1\n1 2 3 4"), "");
	for (const char* zone :
	     {"I=0", "I=-1", "I=99999999999", "N=8 E=1", "N=8 E=1 ET=CUBE F=FEPOINT", "I=2 NV=4\n1 2 3 4 5 6 7 8",
	      "I=1 F=ROWS\n1 2 3 4", "I=1 X\n1 2 3 4", "NODES=8 ELEMENTS=1 FACES=999999999 ZONETYPE=FEPOLYGON"})
		EXPECT_THROW(parseTecplot(kFour + "ZONE " + zone + "\n"), Refusal) << zone;
	EXPECT_NE(whyRefused("FILETYPE=SOLUTION\nVARIABLES=V\nZONE I=1\n1\n").find("its grid"), std::string::npos);
	EXPECT_THROW(parseTecplot("1 2 3"), Refusal);
	EXPECT_THROW(parseTecplot("ZONE I=1\n1"), Refusal);
}
