// netCDF of the climate and forecast conventions, and any netCDF file with arrays of three axes.
#include "cf_grid.h"
#include "cf_values.h"
#include "cf_volumes.h"
#include "formats.h"
#include "manifest_writer.h"
#include "netcdf_size.h"
#include "refusal.h"
#include "time_choice.h"
#include "zarr_check.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <numeric>

namespace
{

// Which step of the file is asked for; its times are offered.
std::size_t chooseStepOf(const NetcdfFile& file, const CfVolumes& volumes, const Request& request,
                         ManifestWriter& manifest)
{
	std::vector<double> times(volumes.time ? volumes.time->length : 0);
	std::iota(times.begin(), times.end(), 0.0); // where the dimension has no values of its own
	if (volumes.time && volumes.time->coordinate >= 0)
		times = cfNumbers(file, volumes.time->coordinate);
	StepsInTime in_order = stepsInTime(times, manifest);
	if (!chooseIfAny(in_order.times, request))
		return 0;
	const std::size_t step = in_order.steps[chooseStep(in_order.times, request)];
	manifest.offerTimes(std::move(in_order.times));
	return step;
}

template <std::size_t Width>
void turnAxes(const char* from, char* to, const std::array<std::size_t, 3>& counts,
              const std::array<std::size_t, 3>& strides)
{
	for (std::size_t a = 0; a < counts[0]; ++a)
		for (std::size_t b = 0; b < counts[1]; ++b)
			for (std::size_t c = 0; c < counts[2]; ++c, from += Width)
				std::memcpy(to + (a * strides[0] + b * strides[1] + c * strides[2]) * Width, from, Width);
}

// Values in the order of a file, with x running fastest, then y, then z.
vtkSmartPointer<vtkDataArray> withXFastest(vtkSmartPointer<vtkDataArray> array, const CfVolume& volume,
                                           const std::array<CfDimension, 3>& axes)
{
	const auto [x, y, z] = volume.sides;
	if (z < y && y < x)
		return array;
	const std::array<std::size_t, 3> of_axes = {1, axes[0].length, axes[0].length * axes[1].length};
	std::array<std::size_t, 3> order = {0, 1, 2}, counts, strides; // axes as the file has them
	std::ranges::sort(order, {}, [&](std::size_t axis) { return volume.sides[axis]; });
	for (std::size_t i = 0; i < 3; ++i)
	{
		counts[i] = axes[order[i]].length;
		strides[i] = of_axes[order[i]];
	}
	const auto turned = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
	turned->SetNumberOfTuples(array->GetNumberOfTuples());
	const auto* from = static_cast<const char*>(array->GetVoidPointer(0));
	auto* to = static_cast<char*>(turned->GetVoidPointer(0));
	switch (array->GetDataTypeSize())
	{
	case 1:
		turnAxes<1>(from, to, counts, strides);
		break;
	case 2:
		turnAxes<2>(from, to, counts, strides);
		break;
	case 4:
		turnAxes<4>(from, to, counts, strides);
		break;
	default:
		turnAxes<8>(from, to, counts, strides);
	}
	return turned;
}

vtkSmartPointer<vtkDataArray> arrayOfVolume(const NetcdfFile& file, const CfVolumes& volumes, const CfVolume& volume,
                                            std::size_t step)
{
	CfSlab slab = CfSlab::of(file, volume.variable);
	if (volume.time)
		slab.fix(*volume.time, step);
	const auto array = withXFastest(cfArray(file, volume.variable, slab), volume, volumes.axes);
	array->SetName(volume.name.c_str());
	if (const std::string units = file.text(volume.variable, "units"); !units.empty())
		array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
	return array;
}

// `name`: of a file, or an address that the netCDF library opens.
void readByConventions(const std::string& name, const Request& request, ManifestWriter& manifest)
{
	const NetcdfFile file(name);
	const CfVolumes volumes = cfVolumes(file);
	for (const std::string& note : volumes.notes)
		manifest.warn(note);
	const std::size_t step = chooseStepOf(file, volumes, request, manifest);
	const CfGrid grid = cfGrid(file, volumes, step);
	vtkDataSetAttributes* fields = grid.data->GetPointData();
	if (grid.has_cell_values)
		fields = grid.data->GetCellData();
	for (const CfVolume& volume : volumes.all)
		fields->AddArray(arrayOfVolume(file, volumes, volume, step));
	manifest.add(grid.data);
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
