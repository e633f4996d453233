#include "format_samples.h"

#include "curved_samples.h"

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPImageDataWriter.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace
{

std::string besideIt(const std::string& path, const std::string& name)
{
	return (std::filesystem::path(path).parent_path() / name).string();
}

vtkSmartPointer<vtkImageData> boxImage(const std::array<int, 6>& extent, double spacing)
{
	auto image = vtkSmartPointer<vtkImageData>::New();
	image->SetExtent(const_cast<int*>(extent.data()));
	image->SetSpacing(spacing, spacing, spacing);
	vtkNew<vtkDoubleArray> f;
	f->SetName("f");
	for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
		f->InsertNextValue(image->GetPoint(p)[0]);
	image->GetPointData()->SetScalars(f);
	return image;
}

void writePieces(const std::string& path)
{
	vtkNew<vtkXMLPImageDataWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(boxImage({0, 4, 0, 3, 0, 5}, 0.5));
	writer->SetNumberOfPieces(2);
	writer->SetStartPiece(0);
	writer->SetEndPiece(1);
	writer->Write();
}

// A coarse box of 4 x 4 x 4 cells, and a fine one over its middle.
void writeAmr(const std::string& path)
{
	const auto writeBox = [&](const char* name, const std::array<int, 6>& extent, double spacing)
	{
		vtkNew<vtkXMLImageDataWriter> writer;
		writer->SetFileName(besideIt(path, name).c_str());
		writer->SetInputData(boxImage(extent, spacing));
		writer->Write();
	};
	writeBox("coarse.vti", {0, 4, 0, 4, 0, 4}, 1.0);
	writeBox("fine.vti", {2, 6, 2, 6, 2, 6}, 0.5);
	writeContents(path, R"(<?xml version="1.0"?>
<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian" header_type="UInt32">
<vtkOverlappingAMR origin="0 0 0" grid_description="XYZ">
<Block level="0" spacing="1 1 1"><DataSet index="0" amr_box="0 3 0 3 0 3" file="coarse.vti"/></Block>
<Block level="1" spacing="0.5 0.5 0.5"><DataSet index="0" amr_box="2 5 2 5 2 5" file="fine.vti"/></Block>
</vtkOverlappingAMR>
</VTKFile>
)");
}

constexpr std::array<std::array<int, 8>, 2> kCubes = {{{0, 1, 4, 3, 6, 7, 10, 9}, {1, 2, 5, 4, 7, 8, 11, 10}}};
constexpr std::array<std::array<int, 4>, 6> kCubeFaces = {
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

vtkSmartPointer<vtkUnstructuredGrid> twoCubes(int type)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	vtkNew<vtkDoubleArray> f;
	f->SetName("f");
	for (int p = 0; p < 12; ++p)
	{
		points->InsertNextPoint(p % 3, p / 3 % 2, p / 6);
		f->InsertNextValue(p);
	}
	grid->SetPoints(points);
	grid->GetPointData()->SetScalars(f);
	for (const auto& cube : kCubes)
	{
		std::array<vtkIdType, 8> ids;
		std::copy(cube.begin(), cube.end(), ids.begin());
		vtkNew<vtkIdList> faces;
		for (const auto& face : kCubeFaces)
		{
			faces->InsertNextId(4);
			for (const int corner : face)
				faces->InsertNextId(cube[static_cast<std::size_t>(corner)]);
		}
		if (type == VTK_POLYHEDRON)
			grid->InsertNextCell(type, 8, ids.data(), 6, faces->GetPointer(0));
		else
			grid->InsertNextCell(type, 8, ids.data());
	}
	return grid;
}

std::string record(std::string line)
{
	line.resize(80);
	return line;
}

template <class Number>
std::string bytesOf(const std::vector<Number>& numbers)
{
	return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

// By hand: VTK's writer leaks, and leaves its case file open.
void writeBinaryGold(const std::string& path)
{
	std::vector<float> xyz;
	for (const int divisor : {1, 3, 6})
		for (int p = 0; p < 12; ++p)
			xyz.push_back(static_cast<float>(p / divisor % (divisor == 1 ? 3 : 2)));
	std::vector<int> ids;
	for (const auto& cube : kCubes)
		for (const int corner : cube)
			ids.push_back(corner + 1);
	const std::string part = record("part") + bytesOf<int>({1});
	writeContents(besideIt(path, "gold.geo"), record("C Binary") + record("one") + record("two") +
	                                              record("node id off") + record("element id off") + part +
	                                              record("cubes") + record("coordinates") + bytesOf<int>({12}) +
	                                              bytesOf(xyz) + record("hexa8") + bytesOf<int>({2}) + bytesOf(ids));
	writeContents(besideIt(path, "gold.f"), record("f") + part + record("coordinates") +
	                                            bytesOf(std::vector<float>(xyz.begin(), xyz.begin() + 12)));
	writeContents(path, "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: gold.geo\n\nVARIABLE\n"
	                    "scalar per node: f gold.f\n");
}

// In text, with two times; one variable has both in one file.
void writeTextGold(const std::string& path)
{
	std::string places, cells, first, second, vectors;
	for (const int divisor : {1, 3, 6})
		for (int p = 0; p < 12; ++p)
		{
			places += fmt::format("{:12.5e}\n", p / divisor % (divisor == 1 ? 3 : 2) * 1.0);
			vectors += fmt::format("{:12.5e}\n", p * 0.5);
		}
	for (const auto& cube : kCubes)
	{
		for (const int corner : cube)
			cells += fmt::format("{:10}", corner + 1);
		cells += "\n";
	}
	for (int p = 0; p < 12; ++p)
	{
		first += fmt::format("{:12.5e}\n", p * 1.0);
		second += fmt::format("{:12.5e}\n", -p * 1.0);
	}
	const std::string part = "part\n         1\n";
	writeContents(besideIt(path, "text.geo"), "one\ntwo\nnode id off\nelement id off\n" + part +
	                                              "cubes\ncoordinates\n        12\n" + places + "hexa8\n         2\n" +
	                                              cells);
	const auto step = [&](const std::string& values)
	{ return "BEGIN TIME STEP\nf\n" + part + "coordinates\n" + values + "END TIME STEP\n"; };
	writeContents(besideIt(path, "text.f"), step(first) + step(second));
	for (const char* name : {"text.v0", "text.v1"})
		writeContents(besideIt(path, name), "v\n" + part + "coordinates\n" + vectors);
	writeContents(path, "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: text.geo\n\nVARIABLE\n"
	                    "scalar per node: 1 1 f text.f\nvector per node: 1 v text.v*\n\nTIME\ntime set: 1\n"
	                    "number of steps: 2\nfilename start number: 0\nfilename increment: 1\n"
	                    "time values: 0.5 1.5\n\nFILE\nfile set: 1\nnumber of steps: 2\n");
}

std::string foamHead(const std::string& type, const std::string& object)
{
	return "FoamFile\n{\n version 2.0;\n format ascii;\n class " + type + ";\n object " + object + ";\n}\n\n";
}

// Two cubes side by side: the face between them first, as OpenFOAM orders them.
void writeFoam(const std::string& path)
{
	writeContents(path, "");
	const std::string mesh = besideIt(path, "constant/polyMesh/");
	std::filesystem::create_directories(mesh);
	std::filesystem::create_directories(besideIt(path, "0"));
	std::filesystem::create_directories(besideIt(path, "system"));
	std::string points = foamHead("vectorField", "points") + "12\n(\n";
	for (int p = 0; p < 12; ++p)
		points += fmt::format("({} {} {})\n", p % 3, p / 3 % 2, p / 6);
	std::string faces = "4(1 4 10 7)\n";
	std::string owner = "0\n";
	for (std::size_t c = 0; c < 2; ++c)
		for (std::size_t f = 0; f < 6; ++f)
			if (f != (c == 0 ? 1u : 0u))
			{
				faces += "4(";
				for (const int corner : kCubeFaces[f])
					faces += std::to_string(kCubes[c][static_cast<std::size_t>(corner)]) + " ";
				faces += ")\n";
				owner += std::to_string(c) + "\n";
			}
	writeContents(mesh + "points", points + ")\n");
	writeContents(mesh + "faces", foamHead("faceList", "faces") + "11\n(\n" + faces + ")\n");
	writeContents(mesh + "owner", foamHead("labelList", "owner") + "11\n(\n" + owner + ")\n");
	writeContents(mesh + "neighbour", foamHead("labelList", "neighbour") + "1\n(\n1\n)\n");
	writeContents(mesh + "boundary", foamHead("polyBoundaryMesh", "boundary") +
	                                     "1\n(\nwalls\n{\n type wall;\n nFaces 10;\n startFace 1;\n}\n)\n");
	writeContents(besideIt(path, "0/T"),
	              foamHead("volScalarField", "T") +
	                  "dimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar>\n"
	                  "2\n(\n1.5\n2.5\n)\n;\nboundaryField\n{\n walls\n {\n  type zeroGradient;\n }\n}\n");
	writeContents(besideIt(path, "system/controlDict"),
	              foamHead("dictionary", "controlDict") + "startTime 0;\nendTime 1;\ndeltaT 1;\nwriteInterval 1;\n");
}

// A cube of each of two processors, which share a face.
void writeFoamParts(const std::string& path)
{
	writeContents(path, "");
	for (std::size_t part = 0; part < 2; ++part)
	{
		const std::string folder = besideIt(path, "processor" + std::to_string(part) + "/");
		const std::string mesh = folder + "constant/polyMesh/";
		std::filesystem::create_directories(mesh);
		std::filesystem::create_directories(folder + "0");
		std::string points = foamHead("vectorField", "points") + "8\n(\n", numbers;
		for (std::size_t p = 0; p < 8; ++p)
		{
			const std::size_t corner = part + p % 2 + 3 * (p / 2);
			points += fmt::format("({} {} {})\n", corner % 3, corner / 3 % 2, corner / 6);
			numbers += std::to_string(corner) + "\n";
		}
		// The face at the other cube last; both name its corners from the same one on.
		const std::string faces = part == 0
		                              ? "4(0 4 6 2)\n4(0 1 5 4)\n4(2 6 7 3)\n4(0 2 3 1)\n4(4 5 7 6)\n4(1 3 7 5)\n"
		                              : "4(1 3 7 5)\n4(0 1 5 4)\n4(2 6 7 3)\n4(0 2 3 1)\n4(4 5 7 6)\n4(0 4 6 2)\n";
		writeContents(mesh + "points", points + ")\n");
		writeContents(mesh + "faces", foamHead("faceList", "faces") + "6\n(\n" + faces + ")\n");
		writeContents(mesh + "owner", foamHead("labelList", "owner") + "6{0}\n");
		writeContents(mesh + "neighbour", foamHead("labelList", "neighbour") + "0()\n");
		writeContents(mesh + "pointProcAddressing",
		              foamHead("labelList", "pointProcAddressing") + "8\n(\n" + numbers + ")\n");
		writeContents(mesh + "cellProcAddressing",
		              foamHead("labelList", "cellProcAddressing") + fmt::format("1({})\n", part));
		writeContents(
		    mesh + "boundary",
		    foamHead("polyBoundaryMesh", "boundary") +
		        "2\n(\nwalls\n{\n type wall;\n nFaces 5;\n startFace 0;\n}\nbetween\n{\n type processor;\n" +
		        fmt::format(" nFaces 1;\n startFace 5;\n myProcNo {};\n neighbProcNo {};\n}}\n)\n", part, 1 - part));
		writeContents(folder + "0/T",
		              foamHead("volScalarField", "T") +
		                  fmt::format("dimensions [0 0 0 1 0 0 0];\ninternalField uniform {}.5;\n", part + 1) +
		                  "boundaryField\n{\n walls { type zeroGradient; }\n between { type processor; }\n}\n");
	}
}

SampleFile sample(const std::string& name, std::function<void(const std::string&)> write)
{
	return {name, std::move(write), "", 0, 0, false, ""};
}

} // namespace

std::vector<SampleFile> formatSamples()
{
	std::vector<SampleFile> files = {
	    sample("pieces.pvti", writePieces),
	    sample("levels.vthb", writeAmr),
	    sample("gold.case", writeBinaryGold),
	    sample("text.case", writeTextGold),
	    sample("case.foam", writeFoam),
	    sample("parts.foam", writeFoamParts),
	    sample("polyhedra.vtu", [](const std::string& p) { writeGrid(twoCubes(VTK_POLYHEDRON), p); }),
	};
	for (const CurvedKind& kind : curvedKinds())
		files.push_back(
		    sample(kind.name + std::string(".vtu"), [kind](const std::string& p) { writeGrid(curvedMesh(kind), p); }));
	return files;
}
