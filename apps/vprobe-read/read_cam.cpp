// Results of the atmosphere model CAM on its cubed sphere: columns in one file, the quads between them in another.
#include "cf_values.h"
#include "complaints.h"
#include "file_head.h"
#include "formats.h"
#include "manifest_writer.h"
#include "netcdf_size.h"
#include "read_files.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNetCDFCAMReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>

namespace
{

// Of the files beside the results, the first that lists quads. Empty where there is none.
std::string quadsBeside(const std::string& file)
{
	namespace fs = std::filesystem;
	constexpr int most = 1000;
	const fs::path folder = fs::path(file).has_parent_path() ? fs::path(file).parent_path() : fs::path(".");
	int left = most;
	std::error_code error;
	const OnlyLooking looking;
	for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator() && left > 0;
	     entry.increment(error), --left)
		if (entry->is_regular_file(error) && entry->path().extension() == ".nc" &&
		    FileHead(entry->path().string()).holds("element_corners"))
			return entry->path().string();
	return {};
}

// VTK's reader knows of no missing values, and of no packed ones.
void takeMeant(const std::string& name, vtkDataSetAttributes* fields)
{
	const NetcdfFile file(name);
	for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
	{
		vtkDataArray* array = fields->GetArray(i);
		const int variable = array && array->GetName() ? file.variable(array->GetName()) : -1;
		if (variable < 0 || cfTypeOf(file, variable) != array->GetDataType())
			continue;
		const vtkSmartPointer<vtkDataArray> meant = cfMeant(file, variable, array);
		if (meant == array)
			continue;
		meant->SetName(array->GetName());
		fields->AddArray(meant); // in the place of the one of its name
	}
}

} // namespace

void readCam(const Request& request, ManifestWriter& manifest)
{
	const std::string quads = request.solution.empty() ? quadsBeside(request.file) : request.solution;
	if (quads.empty())
		throw Refusal(
		    "columns of CAM, whose quads are in another file (with element_corners); put it beside this one, or "
		    "name it with --solution");
	refuseShortNetcdf(request.file);
	refuseShortNetcdf(quads);
	vtkNew<vtkNetCDFCAMReader> reader;
	reader->SetFileName(request.file.c_str());
	reader->SetConnectivityFileName(quads.c_str());
	reader->SetVerticalDimension(vtkNetCDFCAMReader::VERTICAL_DIMENSION_MIDPOINT_LAYERS);
	updateAtTime(*reader, request, manifest);
	refuseOnComplaint();
	auto* grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0));
	if (!grid)
		throw damaged("no data set was found");
	grid->GetPointData()->RemoveArray("lev"); // VTK 9.1 has the longitudes in it
	takeMeant(request.file, grid->GetPointData());
	takeMeant(request.file, grid->GetCellData());
	manifest.add(grid);
}
