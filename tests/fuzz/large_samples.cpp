// Sets of 2 to 12 MiB, which readers take in many blocks, chunks and threads.
#include "format_samples.h"

#include "sample_hdf5.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkExodusIIWriter.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace
{

double waveAt(int i, int j, int k)
{
	return std::sin(0.1 * i) + std::cos(0.07 * j) * k;
}

// Values of the points of a lattice of so many along each axis.
vtkSmartPointer<vtkDoubleArray> waveOf(int side)
{
	auto values = vtkSmartPointer<vtkDoubleArray>::New();
	values->SetName("f");
	for (int k = 0; k < side; ++k)
		for (int j = 0; j < side; ++j)
			for (int i = 0; i < side; ++i)
				values->InsertNextValue(waveAt(i, j, k));
	return values;
}

vtkSmartPointer<vtkImageData> largeImage()
{
	constexpr int side = 72;
	auto image = vtkSmartPointer<vtkImageData>::New();
	image->SetDimensions(side, side, side);
	image->GetPointData()->SetScalars(waveOf(side));
	return image;
}

vtkSmartPointer<vtkUnstructuredGrid> largeMesh()
{
	constexpr int side = 36;
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	vtkNew<vtkCellArray> cells;
	vtkNew<vtkDoubleArray> g;
	g->SetName("g");
	for (int k = 0; k < side; ++k)
		for (int j = 0; j < side; ++j)
			for (int i = 0; i < side; ++i)
			{
				points->InsertNextPoint(i, j, k);
				if (i + 1 == side || j + 1 == side || k + 1 == side)
					continue;
				std::array<vtkIdType, 8> ids = {0, 1, side + 1, side};
				for (std::size_t c = 0; c < 4; ++c)
					ids[c + 4] = ids[c] + side * side;
				for (vtkIdType& id : ids)
					id += i + side * (j + side * k);
				cells->InsertNextCell(8, ids.data());
				g->InsertNextValue(waveAt(i, j, k));
			}
	grid->SetPoints(points);
	grid->SetCells(VTK_HEXAHEDRON, cells);
	grid->GetPointData()->SetScalars(waveOf(side));
	grid->GetCellData()->AddArray(g);
	return grid;
}

template <class Writer>
void writeLargeXml(vtkDataObject* data, const std::string& path, bool is_packed)
{
	vtkNew<Writer> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(data);
	writer->EncodeAppendedDataOff();
	if (!is_packed)
		writer->SetCompressorTypeToNone();
	writer->Write();
}

void writeLargeLegacy(const std::string& path)
{
	vtkNew<vtkUnstructuredGridWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetFileTypeToBinary();
	writer->SetInputData(largeMesh());
	writer->Write();
}

void writeLargeExodus(const std::string& path)
{
	vtkNew<vtkExodusIIWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(largeMesh());
	writer->Write();
}

// 512 leaves of 8 x 8 x 8 cells.
void writeLargeFlash(const std::string& path)
{
	constexpr int blocks = 512, side = 8;
	SampleHdf5 file(path);
	file.texts("/unknown names", {2, 1}, 4, {"dens", "temp"});
	const std::vector<int> tree(15 * blocks, -1), ones(blocks, 1);
	file.set("/gid", {blocks, 15}, H5T_NATIVE_INT, tree.data());
	file.set("/node type", {blocks}, H5T_NATIVE_INT, ones.data());
	file.set("/refine level", {blocks}, H5T_NATIVE_INT, ones.data());
	std::vector<double> bounds, values;
	for (int block = 0; block < blocks; ++block)
	{
		for (const int place : {block % 8, block / 8 % 8, block / 64})
		{
			bounds.push_back(place);
			bounds.push_back(place + 1);
		}
		for (int cell = 0; cell < side * side * side; ++cell)
			values.push_back(waveAt(block, cell, 1));
	}
	file.set("/bounding box", {blocks, 3, 2}, H5T_NATIVE_DOUBLE, bounds.data());
	for (const char* name : {"/dens", "/temp"})
		file.set(name, {blocks, side, side, side}, H5T_NATIVE_DOUBLE, values.data());
}

} // namespace

std::vector<SampleFile> largeSamples()
{
	const auto sample = [](const std::string& name, std::function<void(const std::string&)> write) -> SampleFile
	{ return {name, std::move(write), "", 0, 0, false, ""}; };
	return {
	    sample("large.vti", [](const std::string& p) { writeLargeXml<vtkXMLImageDataWriter>(largeImage(), p, false); }),
	    sample("large_packed.vtu",
	           [](const std::string& p) { writeLargeXml<vtkXMLUnstructuredGridWriter>(largeMesh(), p, true); }),
	    sample("large.vtu",
	           [](const std::string& p) { writeLargeXml<vtkXMLUnstructuredGridWriter>(largeMesh(), p, false); }),
	    sample("large.vtk", writeLargeLegacy),
	    sample("large.ex2", writeLargeExodus),
	    sample("large_hdf5_chk_0001", writeLargeFlash),
	};
}
