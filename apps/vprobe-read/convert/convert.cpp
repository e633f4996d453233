#include "convert.h"

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/base/request.h"
#include "vprobe-read/checks/complaints.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataSetWriter.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace vp::reader::convert
{

namespace fs = std::filesystem;

namespace
{

std::string endingOf(vtkDataSet* data)
{
	return vtkImageData::SafeDownCast(data)         ? ".vti"
	       : vtkRectilinearGrid::SafeDownCast(data) ? ".vtr"
	       : vtkStructuredGrid::SafeDownCast(data)  ? ".vts"
	                                                : ".vtu";
}

std::string escaped(const std::string& text)
{
	std::string words;
	for (const char c : text)
		words += c == '&' ? "&amp;" : c == '"' ? "&quot;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
	return words;
}

// VTK's writers do not escape names in their files.
void escapeNames(vtkFieldData* fields)
{
	static std::set<vtkAbstractArray*> done; // blocks may share arrays
	for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
		if (vtkAbstractArray* array = fields->GetAbstractArray(i); array->GetName() && done.insert(array).second)
			array->SetName(escaped(array->GetName()).c_str());
}

void writeXml(vtkDataSet* data, const std::string& file)
{
	for (vtkFieldData* fields : {static_cast<vtkFieldData*>(data->GetPointData()),
	                             static_cast<vtkFieldData*>(data->GetCellData()), data->GetFieldData()})
		if (fields)
			escapeNames(fields);
	vtkNew<vtkXMLDataSetWriter> writer;
	writer->SetFileName(file.c_str());
	writer->SetInputData(data);
	writer->SetHeaderTypeToUInt64();
	writer->EncodeAppendedDataOff();
	// A complaint of the writer is about the place, not about the input, which was read without a complaint.
	if (!writer->Write() || writer->GetErrorCode() != 0 || checks::hasComplaint() || !fs::exists(file))
		throw NoRoom(kNoRoom);
}

// The points and cells of a lattice, one by one.
vtkSmartPointer<vtkUnstructuredGrid> cellsOf(vtkDataSet* data)
{
	const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	if (auto* structured = vtkStructuredGrid::SafeDownCast(data); structured && structured->GetPoints())
		points->SetDataType(structured->GetPoints()->GetDataType());
	points->SetNumberOfPoints(data->GetNumberOfPoints());
	for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
		points->SetPoint(p, data->GetPoint(p));
	grid->SetPoints(points);
	grid->AllocateEstimate(data->GetNumberOfCells(), 8);
	vtkNew<vtkIdList> ids;
	for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
	{
		data->GetCellPoints(c, ids);
		grid->InsertNextCell(data->GetCellType(c), ids);
	}
	grid->GetPointData()->ShallowCopy(data->GetPointData());
	grid->GetCellData()->ShallowCopy(data->GetCellData());
	grid->GetFieldData()->ShallowCopy(data->GetFieldData());
	return grid;
}

// Pieces lie in a folder with the name of the index, once the parent has given them their places.
void writeBlocks(const std::vector<KeptBlock>& blocks, const Request& request)
{
	const fs::path target = request.convert_to;
	const std::string stem = target.stem().string();
	const fs::path folder = request.convert_folder;
	std::string index = "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\">\n"
	                    "<vtkMultiBlockDataSet>\n";
	for (std::size_t b = 0; b < blocks.size(); ++b)
	{
		const std::string piece = fmt::format("{}_{}{}", stem, b, endingOf(blocks[b].data));
		writeXml(blocks[b].data, (folder / piece).string());
		index += fmt::format("<DataSet index=\"{}\" name=\"{}\" file=\"{}\"/>\n", b,
		                     escaped(blocks[b].name.empty() ? fmt::format("block {}", b) : blocks[b].name),
		                     escaped(stem + "/" + piece));
	}
	std::ofstream file(folder / target.filename(), std::ios::binary);
	file << index << "</vtkMultiBlockDataSet>\n</VTKFile>\n";
	file.close();
	if (!file)
		throw NoRoom(kNoRoom);
}

} // namespace

std::vector<std::string> writeConverted(const std::vector<KeptBlock>& blocks, const TimesToPack& times,
                                        const Request& request)
{
	const std::string ending = fs::path(request.convert_to).extension().string();
	if (ending == ".vtm")
	{
		writeBlocks(blocks, request);
		return {};
	}
	const std::string file = (fs::path(request.convert_folder) / fs::path(request.convert_to).filename()).string();
	const auto isUnstructured = [](const KeptBlock& block) { return endingOf(block.data) == ".vtu"; };
	if (request.cells_of_part > 0 && std::ranges::all_of(blocks, isUnstructured))
		return writePack(blocks, times, file, request);
	if (request.writesIndex())
		throw Refusal("is no unstructured grid, and nothing else needs an index or gets one yet; see docs/LARGE.md");
	if (blocks.size() != 1 && request.cells_of_part > 0)
		throw Refusal(fmt::format(
		    "has {} blocks, and some are not unstructured, which are not packed yet; use it as it is", blocks.size()));
	if (blocks.size() != 1)
		throw Refusal(fmt::format("has {} blocks, and a {} file holds one; write a .vtm", blocks.size(), ending));
	vtkDataSet* data = blocks[0].data;
	if (request.cells_of_part > 0 && endingOf(data) != ".vti")
		throw Refusal(
		    "is neither image data nor unstructured, and nothing else is packed yet; convert it to .vtu first");
	if (times.times.size() > 1)
		throw Refusal(
		    fmt::format("has {} times, and an image is packed at one time; choose it with --time", times.times.size()));
	if (ending != ".vtkhdf" && ending != ".vtu" && ending != endingOf(data))
		throw Refusal(fmt::format("is written as {}{} or .vtm, not as {}", endingOf(data),
		                          endingOf(data) == ".vtu" ? "" : ", .vtu", ending));
	if (ending == ".vtkhdf")
		writeVtkHdf(data, file, request.threads);
	else
		writeXml(ending == endingOf(data) ? data : cellsOf(data).Get(), file);
	return {};
}

} // namespace vp::reader::convert
