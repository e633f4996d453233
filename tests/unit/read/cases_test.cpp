// Tests unusual contents of files: turned images, hidden and unknown cells, polyhedra, times, several inputs.
#include "base/messages.h"
#include "plot3d_samples.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDataSetWriter.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <cmath>
#include <filesystem>

using namespace vp;

namespace
{

struct Outcome
{
	Result<grid::BlockSet> set;
	std::string words; // on standard error
};

Outcome readSaying(const std::string& path, const read::ReadOptions& options = {})
{
	std::string words;
	const MessageListener listener([&](Severity, std::string_view line) { words.append(line).append("\n"); });
	auto set = read::readInputs({path}, options, nullptr);
	return {std::move(set), std::move(words)};
}

std::string refusal(const std::string& path, const read::ReadOptions& options = {})
{
	const auto set = readSaying(path, options).set;
	EXPECT_FALSE(set);
	if (set)
		return {};
	EXPECT_EQ(set.error().kind, ErrorKind::input);
	EXPECT_TRUE(set.error().message.starts_with(path + ": ")) << set.error().message;
	return set.error().message.substr(path.size() + 2);
}

std::string metaImage(const std::string& matrix)
{
	return "NDims = 3\nDimSize = 2 3 4\n" + matrix +
	       "Offset = 1 2 3\nElementSpacing = 1 2 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
	       std::string(24, 'x');
}

// A row of unit cubes along x, of the types given.
vtkSmartPointer<vtkUnstructuredGrid> rowOf(const std::vector<int>& types)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	for (std::size_t i = 0; i <= types.size(); ++i)
		for (int corner = 0; corner < 4; ++corner)
			points->InsertNextPoint(double(i), corner % 2, corner / 2);
	grid->SetPoints(points);
	for (std::size_t i = 0; i < types.size(); ++i)
	{
		const vtkIdType a = static_cast<vtkIdType>(4 * i);
		const std::vector<vtkIdType> corners = {a, a + 4, a + 5, a + 1, a + 2, a + 6, a + 7, a + 3};
		std::vector<vtkIdType> ids = corners;
		if (types[i] == VTK_VOXEL)
			ids = {a, a + 4, a + 1, a + 5, a + 2, a + 6, a + 3, a + 7};
		if (types[i] == VTK_POLYHEDRON)
		{
			vtkNew<vtkIdList> faces;
			for (const auto& face :
			     {std::array{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}})
			{
				faces->InsertNextId(4);
				for (const int corner : face)
					faces->InsertNextId(corners[corner]);
			}
			grid->InsertNextCell(VTK_POLYHEDRON, 8, ids.data(), 6, faces->GetPointer(0));
		}
		else
			grid->InsertNextCell(types[i], types[i] == VTK_QUAD ? 4 : static_cast<vtkIdType>(ids.size()), ids.data());
	}
	return grid;
}

void write(const std::string& path, vtkUnstructuredGrid* grid)
{
	vtkNew<vtkXMLUnstructuredGridWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(grid);
	writer->Write();
}

} // namespace

TEST(TurnedImage, KeepsItsPlace)
{
	const TemporaryFolder folder;
	writeContents(folder / "plain.mha", metaImage(""));
	writeContents(folder / "flipped.mha", metaImage("TransformMatrix = -1 0 0 0 1 0 0 0 -1\n"));
	writeContents(folder / "turned.mha", metaImage("TransformMatrix = 0 1 0 -1 0 0 0 0 1\n")); // i along y, j along -x

	const auto plain = read::readInputs({folder / "plain.mha"}, {}, nullptr);
	const auto flipped = read::readInputs({folder / "flipped.mha"}, {}, nullptr);
	const auto turned = read::readInputs({folder / "turned.mha"}, {}, nullptr);
	ASSERT_TRUE(plain && flipped && turned);
	EXPECT_STREQ(plain->kind(), "image");
	EXPECT_STREQ(flipped->kind(), "image");
	EXPECT_STREQ(turned->kind(), "curvilinear");
	const PointId last = 23; // i 1, j 2, k 3
	EXPECT_EQ(std::get<grid::UniformGrid>(plain->blocks[0].grid).point(last), Vec3(2, 6, 15));
	EXPECT_EQ(std::get<grid::UniformGrid>(flipped->blocks[0].grid).point(last), Vec3(0, 6, -9));
	EXPECT_EQ(std::get<grid::CurvilinearGrid>(turned->blocks[0].grid).point(last), Vec3(-3, 3, 15));
}

TEST(MetaImage, WithoutItsDataFileNamesIt)
{
	const TemporaryFolder folder;
	std::string header = metaImage("");
	header.replace(header.find("LOCAL"), 5, "gone.raw");
	writeContents(folder / "a.mhd", header);
	EXPECT_EQ(refusal(folder / "a.mhd"),
	          "its data file " + folder / "gone.raw" + " cannot be opened; keep both together");
}

TEST(Cells, OfEveryShapeAreTaken)
{
	const TemporaryFolder folder;
	write(folder / "a.vtu", rowOf({VTK_HEXAHEDRON, VTK_VOXEL, VTK_POLYHEDRON, VTK_QUAD}));
	const Outcome outcome = readSaying(folder / "a.vtu");
	ASSERT_TRUE(outcome.set) << outcome.set.error().message;
	EXPECT_EQ(outcome.set->cellCount(), 3u);
	EXPECT_EQ(outcome.set->left_out, 1u);
	EXPECT_EQ(outcome.words, "");
	EXPECT_NO_THROW(grid::validate(outcome.set->blocks[0]));
	// All but the two ends and the sides have a neighbor: the shapes share faces.
	EXPECT_EQ(outcome.set->blocks[0].boundary.faces.size(), 3u * 6 - 4);
}

TEST(Cells, ThatCannotBeSlicedAreCounted)
{
	const TemporaryFolder folder;
	// VTK 9.1 has a number for this type, but no such cell.
	write(folder / "some.vtu", rowOf({VTK_HEXAHEDRON, VTK_LAGRANGE_PYRAMID, VTK_HEXAHEDRON}));
	const Outcome some = readSaying(folder / "some.vtu");
	ASSERT_TRUE(some.set) << some.set.error().message;
	EXPECT_EQ(some.set->cellCount(), 2u);
	EXPECT_EQ(some.set->left_out, 0u);
	EXPECT_EQ(some.words, folder / "some.vtu" + ": 1 cells of type LagrangePyramid are not shown\n");
	// The cells that are shown keep their numbers in the file.
	const auto& grid = std::get<grid::UnstructuredGrid>(some.set->blocks[0].grid);
	EXPECT_EQ(grid.sourceCell(0) + grid.sourceCell(1), 2u);

	write(folder / "none.vtu", rowOf({VTK_LAGRANGE_PYRAMID}));
	EXPECT_EQ(refusal(folder / "none.vtu"),
	          "nothing to slice: cells of type LagrangePyramid cannot be sliced yet; convert them to linear cells");
	write(folder / "flat.vtu", rowOf({VTK_QUAD}));
	EXPECT_EQ(refusal(folder / "flat.vtu"), "nothing to slice: it holds no three-dimensional cells");
}

TEST(Cells, ThatAreHiddenAreLeftOut)
{
	const TemporaryFolder folder;
	const auto grid = rowOf({VTK_HEXAHEDRON, VTK_HEXAHEDRON, VTK_HEXAHEDRON, VTK_HEXAHEDRON});
	vtkNew<vtkUnsignedCharArray> marks;
	marks->SetName("vtkGhostType");
	for (const int mark : {0, 1, 32, 2}) // shown, duplicate, hidden, a bit without this meaning
		marks->InsertNextValue(static_cast<unsigned char>(mark));
	grid->GetCellData()->AddArray(marks);
	write(folder / "a.vtu", grid);
	const Outcome outcome = readSaying(folder / "a.vtu");
	ASSERT_TRUE(outcome.set) << outcome.set.error().message;
	EXPECT_EQ(outcome.set->cellCount(), 2u);
	EXPECT_EQ(outcome.words, folder / "a.vtu" + ": 2 ghost or hidden cells are left out\n");
}

TEST(Cells, WithTooManyPointsUseTheFirst)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.vtk",
	              "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n"
	              "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1 2 2 2\nCELLS 1 7\n6 0 1 2 3 4 5\nCELL_TYPES 1\n10\n");
	const Outcome outcome = readSaying(folder / "a.vtk");
	ASSERT_TRUE(outcome.set) << outcome.set.error().message;
	EXPECT_EQ(outcome.set->cellCount(), 1u);
	EXPECT_NE(outcome.words.find("1 cells list more points"), std::string::npos);

	writeContents(folder / "b.vtk", "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
	                                "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n");
	EXPECT_EQ(refusal(folder / "b.vtk"), "truncated or damaged: cell 0 of type 10 lists 3 points");
	writeContents(folder / "c.vtk", "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
	                                "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n");
	EXPECT_EQ(refusal(folder / "c.vtk"), "truncated or damaged: a cell lists point 4 of 4");
}

TEST(Cells, WithPointsThatAreNoNumbersAreRefused)
{
	const TemporaryFolder folder;
	const auto grid = rowOf({VTK_HEXAHEDRON});
	grid->GetPoints()->SetPoint(2, 0.0, std::nan(""), 0.0);
	write(folder / "a.vtu", grid);
	EXPECT_EQ(refusal(folder / "a.vtu"), "truncated or damaged: every cell has a point without a "
	                                     "place; the coordinates of point 2 are not finite numbers");
	const auto doubles = rowOf({VTK_HEXAHEDRON});
	doubles->GetPoints()->SetDataType(VTK_DOUBLE);
	doubles->GetPoints()->SetNumberOfPoints(8);
	for (vtkIdType p = 0; p < 8; ++p)
		doubles->GetPoints()->SetPoint(p, double(p / 4), double(p % 2), p == 3 ? -1e60 : double(p / 2 % 2));
	write(folder / "b.vtu", doubles);
	EXPECT_EQ(refusal(folder / "b.vtu"), "truncated or damaged: every cell has a point without a "
	                                     "place; the coordinates of point 3 are larger than 1e50");
}

TEST(Files, WhosePiecesGoInACircleAreRefused)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.vtu", "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\"><PUnstructuredGrid>"
	                                "<Piece Source=\"a.vtu\"/></PUnstructuredGrid></VTKFile>");
	EXPECT_EQ(refusal(folder / "a.vtu"), "truncated or damaged: one of its pieces is an index of pieces");
}

TEST(Files, WithoutVolumeAreRefused)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.vtk", "# vtk DataFile Version 2.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
	                                "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n");
	EXPECT_EQ(refusal(folder / "a.vtk"), "nothing to slice: it holds no three-dimensional cells");
	writeContents(folder / "b.vtk",
	              "# vtk DataFile Version 2.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 4 1\n"
	              "ORIGIN 0 0 0\nSPACING 1 1 1\n");
	EXPECT_EQ(refusal(folder / "b.vtk"), "nothing to slice: it holds no three-dimensional cells");
	writeContents(folder / "c.vtp", "<VTKFile type=\"PolyData\"><PolyData/></VTKFile>");
	EXPECT_EQ(refusal(folder / "c.vtp"), "nothing to slice: polygonal data hold no three-dimensional cells");
}

TEST(Files, ThatClaimMoreThanFitsAreRefused)
{
	const TemporaryFolder folder;
	const auto image = [](const std::string& extent)
	{
		return "<VTKFile type=\"ImageData\" version=\"1.0\"><ImageData WholeExtent=\"" + extent +
		       "\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"" + extent +
		       "\"><PointData><DataArray type=\"Float64\" Name=\"f\" format=\"ascii\">1 2 "
		       "3</DataArray></PointData></Piece>"
		       "</ImageData></VTKFile>";
	};
	for (const char* extent : {"0 100000 0 100000 0 100000", "0 2000000000 0 2000000000 0 2000000000",
	                           "0 1290 0 1290 0 1290", "0 5 0 5 0 5"})
	{
		writeContents(folder / "a.vti", image(extent));
		refusal(folder / "a.vti");
	}
	writeContents(folder / "a.vtk", "# vtk DataFile Version 2.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n"
	                                "DIMENSIONS 40000 40000 40000\nORIGIN 0 0 0\nSPACING 1 1 1\n");
	EXPECT_NE(refusal(folder / "a.vtk").find("too large"), std::string::npos);
}

TEST(Cells, ThatAreAllHiddenAreNothingToSlice)
{
	const TemporaryFolder folder;
	const auto grid = rowOf({VTK_HEXAHEDRON, VTK_HEXAHEDRON});
	vtkNew<vtkUnsignedCharArray> marks;
	marks->SetName("vtkGhostType");
	for (int cell = 0; cell < 2; ++cell)
		marks->InsertNextValue(32);
	grid->GetCellData()->AddArray(marks);
	write(folder / "a.vtu", grid);
	EXPECT_EQ(refusal(folder / "a.vtu"),
	          "nothing to slice: all its cells are marked as hidden or as ghosts (2); take the "
	          "marks away to see them");
}

// One line that helps: what it is, and what makes a file of it that is read.
TEST(Files, OfOtherProgramsNameTheRemedy)
{
	const TemporaryFolder folder;
	const auto says = [&](const std::string& name, const std::string& contents, const std::string& words)
	{
		const std::string file = folder / name;
		std::filesystem::create_directories(std::filesystem::path(file).parent_path());
		writeContents(file, contents);
		const std::string line = refusal(file);
		EXPECT_NE(line.find(words), std::string::npos) << name << ": " << line;
	};
	says("a.su2", "NDIME= 3\n", "meshio convert a.su2 a.vtu");
	says("a.bdf", "CEND\nBEGIN BULK\n", "meshio convert a.bdf a.vtu");
	says("a.mesh", "MeshVersionFormatted 2\n", "meshio convert a.mesh a.vtu");
	says("a.vol", "mesh3d\n", "meshio convert a.vol a.vtu");
	says("a.inp", "*HEADING\n", "meshio convert a.inp a.vtu");
	std::string nodes;
	for (int node = 1; node <= 20; ++node)
		nodes += std::to_string(node) + " 0 0 " + std::to_string(node) + "\n";
	says("a.msh",
	     "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n20\n" + nodes +
	         "$EndNodes\n$Elements\n1\n1 29 2 1 1 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20\n$EndElements\n",
	     "elements of Gmsh type 29 are of an order above 2");
	says("case/a.foam", "", "constant/ is missing or cannot be opened");
	std::filesystem::create_directories(folder / "case/processor0/1");
	std::filesystem::create_directories(folder / "case/processor2/1");
	says("case/a.foam", "", "its part of processor 1 is missing");
}

TEST(Folders, OfZarrThatCannotBeFollowedAreTold)
{
	const TemporaryFolder folder;
	for (const std::string name : {"three", "image", "array", "five"})
		std::filesystem::create_directories(folder / name);
	writeContents(folder / "three/zarr.json", "{\"zarr_format\": 3, \"node_type\": \"array\"}");
	writeContents(folder / "image/.zgroup", "{\"zarr_format\": 2}");
	writeContents(folder / "image/.zattrs", "{\"multiscales\": [{}]}");
	writeContents(folder / "array/.zarray", "{\"zarr_format\": 2}");
	writeContents(folder / "five/attributes.json", "{\"n5\": \"2.5.1\"}");
	EXPECT_NE(refusal(folder / "five").find("a group of N5"), std::string::npos);
	EXPECT_NE(refusal(folder / "three").find("the JSON of three"), std::string::npos);
	EXPECT_NE(refusal(folder / "image").find("no levels"), std::string::npos);
	EXPECT_NE(refusal(folder / "array").find("the JSON of array"), std::string::npos);
}

TEST(Xml, PiecesThatAreMissingAreNamed)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.pvtu",
	              "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\"><PUnstructuredGrid GhostLevel=\"0\">"
	              "<PPoints><PDataArray type=\"Float32\" NumberOfComponents=\"3\"/></PPoints>"
	              "<Piece Source=\"gone.vtu\"/></PUnstructuredGrid></VTKFile>");
	EXPECT_EQ(refusal(folder / "a.pvtu"), "its piece " + folder / "gone.vtu" + " cannot be opened; keep them together");
}

// Read as a whole, and listed for several processes.
TEST(Xml, PiecesWithoutAFileAreRefused)
{
	const TemporaryFolder folder;
	write(folder / "piece.vtu", rowOf({VTK_HEXAHEDRON}));
	writeContents(folder / "a.pvtu",
	              "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\"><PUnstructuredGrid GhostLevel=\"0\">"
	              "<PPoints><PDataArray type=\"Float32\" NumberOfComponents=\"3\"/></PPoints>"
	              "<Piece Source=\"piece.vtu\"/><Piece/></PUnstructuredGrid></VTKFile>");
	const std::string words = "one of its <Piece> elements names no file; give it the attribute Source";
	EXPECT_EQ(refusal(folder / "a.pvtu"), words);
	const auto listed = read::listParts({folder / "a.pvtu"}, {}, nullptr);
	ASSERT_FALSE(listed);
	EXPECT_NE(listed.error().message.find(words), std::string::npos) << listed.error().message;
}

TEST(Xml, PiecesMayHaveOtherNumberTypesThanTheirIndex)
{
	const TemporaryFolder folder;
	const auto grid = rowOf({VTK_HEXAHEDRON}); // points are floats
	vtkNew<vtkIntArray> numbers;
	numbers->SetName("n");
	for (int p = 0; p < 8; ++p)
		numbers->InsertNextValue(7 - p);
	grid->GetPointData()->AddArray(numbers);
	write(folder / "piece.vtu", grid);
	const auto index = [](const std::string& points, const std::string& array)
	{
		return "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\"><PUnstructuredGrid GhostLevel=\"0\">"
		       "<PPointData><PDataArray Name=\"n\" " +
		       array +
		       "/></PPointData>"
		       "<PPoints><PDataArray type=\"" +
		       points +
		       "\" NumberOfComponents=\"3\"/></PPoints>"
		       "<Piece Source=\"piece.vtu\"/></PUnstructuredGrid></VTKFile>";
	};
	writeContents(folder / "a.pvtu", index("Float64", "type=\"Float64\""));
	const Outcome outcome = readSaying(folder / "a.pvtu");
	ASSERT_TRUE(outcome.set) << outcome.set.error().message;
	const Outcome piece = readSaying(folder / "piece.vtu");
	ASSERT_TRUE(piece.set) << piece.set.error().message;
	EXPECT_EQ(outcome.set->bounds().lo, piece.set->bounds().lo);
	EXPECT_EQ(outcome.set->bounds().hi, piece.set->bounds().hi);
	ASSERT_EQ(outcome.set->blocks[0].fields.size(), 1u);
	const grid::ValueSpan span = grid::valueSpan(outcome.set->blocks[0].fields[0], 0);
	EXPECT_EQ(span.lo, 0.0);
	EXPECT_EQ(span.hi, 7.0);

	writeContents(folder / "b.pvtu", index("Float64", "type=\"Float64\" NumberOfComponents=\"3\""));
	EXPECT_NE(refusal(folder / "b.pvtu").find("than the index of the pieces"), std::string::npos);
}

TEST(Plot3d, FindsItsSolution)
{
	const TemporaryFolder folder;
	writePlot3d(folder / "wingxyz.bin", folder / "wingq.bin", {});
	const auto fields = [](const Outcome& outcome) { return outcome.set ? outcome.set->blocks[0].fields.size() : 99; };
	EXPECT_EQ(fields(readSaying(folder / "wingxyz.bin")), 6u);

	std::filesystem::rename(folder / "wingq.bin", folder / "elsewhere.sol");
	const Outcome alone = readSaying(folder / "wingxyz.bin");
	EXPECT_EQ(fields(alone), 0u);
	EXPECT_NE(alone.words.find("no solution lies beside"), std::string::npos);
	read::ReadOptions options;
	options.solution = folder / "elsewhere.sol";
	EXPECT_EQ(fields(readSaying(folder / "wingxyz.bin", options)), 6u);

	const std::string solution = contentsOf(options.solution);
	writeContents(options.solution, solution.substr(0, solution.size() - 4));
	EXPECT_NE(refusal(folder / "wingxyz.bin", options).find("elsewhere.sol"), std::string::npos);
	options.solution = folder / "missing.q";
	EXPECT_NE(refusal(folder / "wingxyz.bin", options).find("missing.q"), std::string::npos);
	EXPECT_EQ(refusal(folder / "elsewhere.sol").substr(0, 10), "not a form");
}

TEST(Inputs, SeveralMakeOneBlockSet)
{
	const TemporaryFolder folder;
	write(folder / "a.vtu", rowOf({VTK_HEXAHEDRON}));
	writeContents(folder / "b.mha", metaImage(""));
	const auto set = read::readInputs({folder / "a.vtu", "demo:blob:4", folder / "b.mha"}, {}, nullptr);
	ASSERT_TRUE(set) << set.error().message;
	ASSERT_EQ(set->blocks.size(), 3u);
	EXPECT_EQ(set->blocks[0].name, "a");
	EXPECT_EQ(set->blocks[2].name, "b");
	EXPECT_EQ(set->cellCount(), 1u + 64 + 6);
	EXPECT_STREQ(set->kind(), "hybrid");

	const auto with_missing = read::readInputs({folder / "a.vtu", folder / "c.vtu"}, {}, nullptr);
	ASSERT_FALSE(with_missing);
	EXPECT_TRUE(with_missing.error().message.starts_with(folder / "c.vtu"));
	EXPECT_FALSE(read::readInputs({"demo:nothing"}, {}, nullptr));
}

TEST(Time, IsLastFirstANumberOrAnIndex)
{
	using Kind = read::TimeChoice::Kind;
	EXPECT_EQ(read::parseTime("last")->kind, Kind::last);
	EXPECT_EQ(read::parseTime("first")->kind, Kind::first);
	EXPECT_EQ(read::parseTime("-2.5e-3")->value, -2.5e-3);
	EXPECT_EQ(read::parseTime("#3")->kind, Kind::index);
	EXPECT_EQ(read::parseTime("#3")->index, 3u);
	for (const char* text : {"", "now", "#", "#-1", "# 1", "#1.5", "1.5x", "nan", "inf", " 1"})
	{
		const auto time = read::parseTime(text);
		ASSERT_FALSE(time) << text;
		EXPECT_EQ(time.error().kind, ErrorKind::usage);
	}
}
