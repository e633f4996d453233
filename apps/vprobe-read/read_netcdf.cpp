// netCDF of the climate and forecast conventions, and any netCDF file with arrays of three axes.
#include "complaints.h"
#include "file_head.h"
#include "formats.h"
#include "manifest_writer.h"
#include "netcdf_size.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkNetCDFCFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace
{

// The dimensions of variables, as VTK writes them "(time, z, y, x)": the longest list has the volumes. Variables of
// other dimensions would be a second grid in the same place.
std::string mostDimensions(vtkNetCDFCFReader& reader, ManifestWriter& manifest)
{
	std::string most;
	const auto lengthOf = [](const std::string& list) { return std::count(list.begin(), list.end(), ','); };
	vtkStringArray* lists = reader.GetAllDimensions();
	for (vtkIdType i = 0; i < lists->GetNumberOfValues(); ++i)
		if (const std::string list = lists->GetValue(i); most.empty() || lengthOf(list) > lengthOf(most))
			most = list;
	if (lengthOf(most) < 2)
		throw Refusal("nothing to slice: no variable with three dimensions");
	for (vtkIdType i = 0; i < lists->GetNumberOfValues(); ++i)
		if (const std::string list = lists->GetValue(i); list != most && lengthOf(list) == lengthOf(most))
			manifest.warn(fmt::format("variables over {} are left out; those over {} are read", list, most));
	return most;
}

// What the netCDF library fills variables with that nobody wrote: VTK knows only the value that a file declares.
template <class Number>
void replaceDefaultFill(vtkDataArray* array)
{
	constexpr double fill = 9.9692099683868690e+36; // NC_FILL_FLOAT and NC_FILL_DOUBLE
	auto* values = static_cast<Number*>(array->GetVoidPointer(0));
	std::replace(values, values + array->GetNumberOfValues(), static_cast<Number>(fill),
	             std::numeric_limits<Number>::quiet_NaN());
}

void markMissing(vtkFieldData* fields)
{
	for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
	{
		vtkDataArray* array = fields->GetArray(i);
		if (array && array->GetDataType() == VTK_FLOAT)
			replaceDefaultFill<float>(array);
		else if (array && array->GetDataType() == VTK_DOUBLE)
			replaceDefaultFill<double>(array);
	}
}

void addUnits(vtkNetCDFCFReader& reader, vtkFieldData* fields)
{
	for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
		if (vtkDataArray* array = fields->GetArray(i); array && array->GetName())
			if (const std::string units = reader.QueryArrayUnits(array->GetName()); !units.empty())
				array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
}

} // namespace

void readNetcdf(const Request& request, ManifestWriter& manifest)
{
	const FileHead head(request.file);
	if (head.holds("zspace") && head.holds("image"))
		throw Refusal("a MINC file, whose places and ranges are not read; convert it to NIfTI with mnc2nii");
	refuseShortNetcdf(request.file);
	vtkNew<vtkNetCDFCFReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw damaged("not a netCDF file that can be opened");
	reader->SetFileName(request.file.c_str());
	reader->SphericalCoordinatesOff(); // longitude, latitude and height as they are, not on a globe
	reader->ReplaceFillValueWithNanOn();
	reader->UpdateMetaData();
	refuseOnComplaint();
	reader->SetDimensions(mostDimensions(*reader, manifest).c_str());
	updateAtTime(*reader, request, manifest);
	auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
	if (!data)
		throw damaged("no data set was found");
	markMissing(data->GetPointData());
	markMissing(data->GetCellData());
	addUnits(*reader, data->GetPointData());
	addUnits(*reader, data->GetCellData());
	manifest.add(data);
}
