// netCDF of the climate and forecast conventions, and any netCDF file with arrays of three axes.
#include "complaints.h"
#include "formats.h"
#include "manifest_writer.h"
#include "netcdf_size.h"
#include "netcdf_volumes.h"
#include "refusal.h"
#include "time_choice.h"
#include "zarr_check.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkNetCDFCFReader.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

namespace
{

// The dimensions of variables, as VTK writes them "(time, z, y, x)": the longest list has the volumes. Variables of
// other dimensions would be a second grid in the same place.
std::string mostDimensions(vtkNetCDFCFReader& reader, bool has_groups, ManifestWriter& manifest)
{
	std::string most;
	const auto lengthOf = [](const std::string& list) { return std::count(list.begin(), list.end(), ','); };
	vtkStringArray* lists = reader.GetAllDimensions();
	for (vtkIdType i = 0; i < lists->GetNumberOfValues(); ++i)
		if (const std::string list = lists->GetValue(i); most.empty() || lengthOf(list) > lengthOf(most))
			most = list;
	if (lengthOf(most) < 2)
		throw Refusal(has_groups
		                  ? "nothing to slice: no variable with three dimensions at its root; groups of netCDF-4 "
		                    "are not read, ncks -G : takes them there"
		                  : "nothing to slice: no variable with three dimensions");
	for (vtkIdType i = 0; i < lists->GetNumberOfValues(); ++i)
		if (const std::string list = lists->GetValue(i); list != most && lengthOf(list) == lengthOf(most))
			manifest.warn(fmt::format("variables over {} are left out; those over {} are read", list, most));
	return most;
}

std::set<std::string> variablesOver(vtkNetCDFCFReader& reader, const std::string& dimensions)
{
	std::set<std::string> names;
	vtkStringArray* lists = reader.GetVariableDimensions();
	vtkStringArray* all = reader.GetAllVariableArrayNames();
	for (vtkIdType i = 0; i < std::min(lists->GetNumberOfValues(), all->GetNumberOfValues()); ++i)
		if (lists->GetValue(i) == dimensions)
			names.insert(all->GetValue(i));
	return names;
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

// Leaves out variables that VTK's own would fail on; it loads all of the chosen dimensions, whatever their status.
class NumbersReader : public vtkNetCDFCFReader
{
public:
	static NumbersReader* New();
	vtkTypeMacro(NumbersReader, vtkNetCDFCFReader);

	void leaveOut(const std::vector<std::string>& variables) { left_out_.insert(variables.begin(), variables.end()); }

protected:
	int LoadVariable(int file, const char* name, double time, vtkDataSet* output) override
	{
		return left_out_.contains(name) ? 1 : vtkNetCDFCFReader::LoadVariable(file, name, time, output);
	}

private:
	std::set<std::string> left_out_;
};

vtkStandardNewMacro(NumbersReader);

// `name`: of a file, or an address that the netCDF library opens.
void readByConventions(const std::string& name, const Request& request, ManifestWriter& manifest)
{
	NetcdfVolumes volumes = netcdfVolumes(name);
	vtkNew<NumbersReader> reader;
	if (!reader->CanReadFile(name.c_str()))
		throw damaged("netCDF cannot open it");
	reader->SetFileName(name.c_str());
	reader->SphericalCoordinatesOff(); // longitude, latitude and height as they are, not on a globe
	reader->ReplaceFillValueWithNanOn();
	reader->UpdateMetaData();
	refuseOnComplaint();
	const std::string most = mostDimensions(*reader, volumes.has_groups, manifest);
	const std::set<std::string> chosen = variablesOver(*reader, most);
	const auto isElsewhere = [&](const std::string& variable) { return !chosen.contains(variable); };
	for (const auto& [variable, dimension] : volumes.empty)
		if (chosen.contains(variable))
			throw Refusal(
			    fmt::format("nothing to slice: {} has no values, since its dimension {} is 0", variable, dimension));
	std::erase_if(volumes.unread, isElsewhere);
	std::erase_if(volumes.whole, isElsewhere);
	reader->SetDimensions(most.c_str());
	for (const std::string& variable : volumes.unread)
		manifest.warn(fmt::format("{} holds no numbers and is left out", variable));
	reader->leaveOut(volumes.unread);
	reader->leaveOut(volumes.whole);
	std::optional<double> time;
	try
	{
		time = updateAtTime(*reader, request, manifest);
	}
	catch (const Refusal& refusal)
	{
		if (std::string_view(refusal.what()).find("More than 3 dims without time") != std::string_view::npos)
			throw Refusal(
			    "a variable of four dimensions whose first has no times (a variable of its name, with units such "
			    "as \"days since 2000-01-01\"); ncpdq -a puts another first");
		throw;
	}
	auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
	if (!data)
		throw damaged("no data set was found");
	markMissing(data->GetPointData());
	markMissing(data->GetCellData());
	addUnits(*reader, data->GetPointData());
	addUnits(*reader, data->GetCellData());
	addWholeNumbers(name, volumes.whole, time, data);
	manifest.add(data);
}

} // namespace

void readNetcdf(const Request& request, ManifestWriter& manifest)
{
	refuseShortNetcdf(request.file);
	readByConventions(request.file, request, manifest);
}

// Zarr version 2 through netCDF, where a group is what a file is elsewhere.
void readZarr(const Request& request, ManifestWriter& manifest)
{
	const std::string folder = std::filesystem::absolute(request.file).lexically_normal().string();
	if (folder.find_first_of("#?%[]&") != folder.npos)
		throw Refusal("its path has one of # ? % [ ] &, which netCDF takes for something else; rename it");
	refuseShortChunks(folder);
	readByConventions("file://" + folder + "#mode=zarr,file", request, manifest);
}
