#include "vtk_samples.h"

#include <vtkCellData.h>
#include <vtkDataSetWriter.h>
#include <vtkDoubleArray.h>
#include <vtkExodusIIWriter.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkMetaImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLRectilinearGridWriter.h>
#include <vtkXMLStructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>

namespace
{

double sampleAt(const std::array<double, 3>& at)
{
	return sampleValue({at[0], at[1], at[2]});
}

template <class Data>
vtkSmartPointer<Data> withArrays(vtkSmartPointer<Data> data)
{
	vtkNew<vtkDoubleArray> f;
	f->SetName("f");
	for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
	{
		std::array<double, 3> at;
		data->GetPoint(p, at.data());
		f->InsertNextValue(sampleAt(at));
	}
	vtkNew<vtkDoubleArray> g;
	g->SetName("g");
	vtkNew<vtkIdList> ids;
	for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
	{
		data->GetCellPoints(c, ids);
		double sum = 0.0;
		for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
			sum += f->GetValue(ids->GetId(i));
		g->InsertNextValue(sum / static_cast<double>(ids->GetNumberOfIds()));
	}
	data->GetPointData()->SetScalars(f);
	data->GetCellData()->SetScalars(g);
	return data;
}

vtkSmartPointer<vtkImageData> makeImage()
{
	auto image = vtkSmartPointer<vtkImageData>::New();
	// An extent that does not start at zero, as pieces have.
	image->SetExtent(2, kSamplePoints[0] + 1, 0, kSamplePoints[1] - 1, -1, kSamplePoints[2] - 2);
	image->SetOrigin(1.0, -2.0, 0.5);
	image->SetSpacing(0.5, 0.25, 2.0);
	return withArrays(image);
}

vtkSmartPointer<vtkRectilinearGrid> makeRectilinear()
{
	auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
	grid->SetDimensions(kSamplePoints.data());
	std::array<vtkNew<vtkDoubleArray>, 3> axes;
	for (int axis = 0; axis < 3; ++axis)
		for (int i = 0; i < kSamplePoints[axis]; ++i)
			axes[axis]->InsertNextValue(0.1 * i * i + axis);
	grid->SetXCoordinates(axes[0]);
	grid->SetYCoordinates(axes[1]);
	grid->SetZCoordinates(axes[2]);
	return withArrays(grid);
}

vtkSmartPointer<vtkPoints> makePoints(int type)
{
	auto points = vtkSmartPointer<vtkPoints>::New();
	points->SetDataType(type);
	for (int k = 0; k < kSamplePoints[2]; ++k)
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				points->InsertNextPoint(i + 0.25 * j, j + 0.125 * k, k);
	return points;
}

vtkSmartPointer<vtkStructuredGrid> makeStructured()
{
	auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
	grid->SetDimensions(kSamplePoints.data());
	grid->SetPoints(makePoints(VTK_DOUBLE));
	return withArrays(grid);
}

vtkIdType pointId(int i, int j, int k)
{
	return (vtkIdType(k) * kSamplePoints[1] + j) * kSamplePoints[0] + i;
}

// Hexahedra, or each of them cut into two wedges where i is odd.
vtkSmartPointer<vtkUnstructuredGrid> makeUnstructured(bool wedges)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(makePoints(VTK_FLOAT));
	for (int k = 0; k + 1 < kSamplePoints[2]; ++k)
		for (int j = 0; j + 1 < kSamplePoints[1]; ++j)
			for (int i = 0; i + 1 < kSamplePoints[0]; ++i)
			{
				std::array<vtkIdType, 8> p;
				for (int corner = 0; corner < 8; ++corner)
					p[corner] = pointId(i + (corner % 4 == 1 || corner % 4 == 2), j + corner % 4 / 2, k + corner / 4);
				if (!wedges || i % 2 == 0)
					grid->InsertNextCell(VTK_HEXAHEDRON, 8, p.data());
				else
				{
					const std::array<vtkIdType, 6> low = {p[0], p[2], p[1], p[4], p[6], p[5]};
					const std::array<vtkIdType, 6> high = {p[0], p[3], p[2], p[4], p[7], p[6]};
					grid->InsertNextCell(VTK_WEDGE, 6, low.data());
					grid->InsertNextCell(VTK_WEDGE, 6, high.data());
				}
			}
	return withArrays(grid);
}

enum class Form
{
	ascii,
	binary,
	appended,
	compressed
};

template <class Writer, class Data>
void writeXml(const std::string& path, Data data, Form form)
{
	vtkNew<Writer> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(data);
	if (form == Form::ascii)
		writer->SetDataModeToAscii();
	else if (form == Form::binary)
		writer->SetDataModeToBinary();
	else
		writer->SetDataModeToAppended();
	writer->SetEncodeAppendedData(form == Form::compressed);
	if (form != Form::compressed)
		writer->SetCompressorTypeToNone();
	writer->Write();
}

void writeLegacy(const std::string& path, vtkDataSet* data, bool ascii)
{
	vtkNew<vtkDataSetWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(data);
	ascii ? writer->SetFileTypeToASCII() : writer->SetFileTypeToBinary();
	writer->Write();
}

// Two pieces that hold all cells twice over.
void writePieces(const std::string& path)
{
	const std::string stem = std::filesystem::path(path).replace_extension().string();
	writeXml<vtkXMLUnstructuredGridWriter>(stem + "_0.vtu", makeUnstructured(false), Form::binary);
	writeXml<vtkXMLUnstructuredGridWriter>(stem + "_1.vtu", makeUnstructured(true), Form::ascii);
	const std::string name = std::filesystem::path(stem).filename().string();
	writeContents(path, R"(<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian">
<PUnstructuredGrid GhostLevel="0">
<PPointData Scalars="f"><PDataArray type="Float64" Name="f"/></PPointData>
<PCellData Scalars="g"><PDataArray type="Float64" Name="g"/></PCellData>
<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>
<Piece Source=")" + name + R"(_0.vtu"/><Piece Source=")" +
	                        name + R"(_1.vtu"/>
</PUnstructuredGrid>
</VTKFile>
)");
}

void writeMeta(const std::string& path, bool compressed)
{
	vtkSmartPointer<vtkImageData> image = makeImage();
	image->GetPointData()->GetScalars()->SetName("MetaImage");
	image->SetOrigin(image->GetPoint(0));
	image->SetExtent(0, kSamplePoints[0] - 1, 0, kSamplePoints[1] - 1, 0, kSamplePoints[2] - 1);
	vtkNew<vtkMetaImageWriter> writer;
	writer->SetFileName(path.c_str());
	if (path.ends_with(".mhd"))
		writer->SetRAWFileName((path.substr(0, path.size() - 4) + (compressed ? ".zraw" : ".raw")).c_str());
	writer->SetInputData(image);
	writer->SetCompression(compressed);
	writer->Write();
}

void writeExodus(const std::string& path)
{
	vtkNew<vtkExodusIIWriter> writer;
	writer->SetFileName(path.c_str());
	writer->SetInputData(makeUnstructured(false));
	writer->WriteOutBlockIdArrayOff();
	writer->WriteOutGlobalElementIdArrayOff();
	writer->WriteOutGlobalNodeIdArrayOff();
	writer->Write();
}

} // namespace

std::vector<SampleFile> vtkSamples()
{
	vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
	std::vector<SampleFile> files;
	const std::size_t points = 5 * 4 * 6;
	const std::size_t cells = 4 * 3 * 5;
	const std::size_t mixed_cells = 2 * 3 * 5 + 2 * 3 * 5 * 2;
	const std::array<const char*, 4> forms = {"ascii", "binary", "appended", "compressed"};
	for (int i = 0; i < 4; ++i)
	{
		const Form form = static_cast<Form>(i);
		const std::string name = forms[i];
		files.push_back({name + ".vti",
		                 [form](const std::string& p) { writeXml<vtkXMLImageDataWriter>(p, makeImage(), form); },
		                 "image", cells, points, true, ""});
		files.push_back({name + ".vtr",
		                 [form](const std::string& p)
		                 { writeXml<vtkXMLRectilinearGridWriter>(p, makeRectilinear(), form); },
		                 "rectilinear", cells, points, true, ""});
		files.push_back({name + ".vts",
		                 [form](const std::string& p)
		                 { writeXml<vtkXMLStructuredGridWriter>(p, makeStructured(), form); },
		                 "curvilinear", cells, points, true, ""});
		files.push_back({name + ".vtu",
		                 [form](const std::string& p)
		                 { writeXml<vtkXMLUnstructuredGridWriter>(p, makeUnstructured(true), form); },
		                 "unstructured", mixed_cells, points, true, ""});
	}
	files.push_back(
	    {"pieces.pvtu", writePieces, "unstructured", cells + mixed_cells, 2 * points, true, "pieces_0.vtu"});
	for (const bool ascii : {true, false})
	{
		const std::string form = ascii ? "ascii_" : "binary_";
		files.push_back({form + "image.vtk", [ascii](const std::string& p) { writeLegacy(p, makeImage(), ascii); },
		                 "image", cells, points, true, ""});
		files.push_back({form + "rectilinear.vtk",
		                 [ascii](const std::string& p) { writeLegacy(p, makeRectilinear(), ascii); }, "rectilinear",
		                 cells, points, true, ""});
		files.push_back({form + "structured.vtk",
		                 [ascii](const std::string& p) { writeLegacy(p, makeStructured(), ascii); }, "curvilinear",
		                 cells, points, true, ""});
		files.push_back({form + "unstructured.vtk",
		                 [ascii](const std::string& p) { writeLegacy(p, makeUnstructured(true), ascii); },
		                 "unstructured", mixed_cells, points, true, ""});
	}
	files.push_back(
	    {"raw.mhd", [](const std::string& p) { writeMeta(p, false); }, "image", cells, points, false, "raw.raw"});
	files.push_back(
	    {"zipped.mhd", [](const std::string& p) { writeMeta(p, true); }, "image", cells, points, false, "zipped.zraw"});
	files.push_back(
	    {"local.mha", [](const std::string& p) { writeMeta(p, false); }, "image", cells, points, false, ""});
	files.push_back({"elements.ex2", writeExodus, "unstructured", cells, points, true, ""});
	return files;
}
