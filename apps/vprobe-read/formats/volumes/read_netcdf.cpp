// netCDF and Zarr of the climate and forecast conventions, and any such file with arrays of three axes.
#include "cf_grid.h"
#include "cf_parts.h"
#include "cf_values.h"
#include "cf_volumes.h"
#include "read_ome_zarr.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "wrf_file.h"
#include "zarr_file.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

// Which step of the file is asked for; its times are offered.
std::size_t chooseStepOf(const hdf5::NetcdfFile& file, const CfVolumes& volumes, const Request& request,
                         manifest::Writer& manifest)
{
	std::vector<double> times(volumes.time ? volumes.time->length : 0);
	std::iota(times.begin(), times.end(), 0.0); // where the dimension has no values of its own
	if (volumes.time && volumes.time->coordinate >= 0)
	{
		times = cfNumbers(file, volumes.time->coordinate);
		manifest.setTimeUnits(file.text(volumes.time->coordinate, "units"));
	}
	else if (const WrfTimes of_wrf = wrfTimes(file); !times.empty() && of_wrf.minutes.size() == times.size())
	{
		times = of_wrf.minutes;
		manifest.setTimeUnits("minutes since " + of_wrf.first);
	}
	return manifest::offerSteps(times, request, manifest).value_or(0);
}

// The means of neighbors along an axis: values on the sides of cells become those of their middles.
vtkSmartPointer<vtkDataArray> atMiddles(vtkDataArray* sides, std::array<std::size_t, 3> lengths, std::size_t axis)
{
	const std::array<std::size_t, 3> steps = {1, lengths[0], lengths[0] * lengths[1]};
	--lengths[axis];
	const bool is_float = sides->GetDataType() == VTK_FLOAT;
	const auto middles =
	    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(is_float ? VTK_FLOAT : VTK_DOUBLE));
	middles->SetNumberOfTuples(static_cast<vtkIdType>(lengths[0] * lengths[1] * lengths[2]));
	vtkIdType at = 0;
	for (std::size_t k = 0; k < lengths[2]; ++k)
		for (std::size_t j = 0; j < lengths[1]; ++j)
			for (std::size_t i = 0; i < lengths[0]; ++i)
			{
				const std::size_t low = i + steps[1] * j + steps[2] * k;
				middles->SetTuple1(at++, 0.5 * (sides->GetTuple1(static_cast<vtkIdType>(low)) +
				                                sides->GetTuple1(static_cast<vtkIdType>(low + steps[axis]))));
			}
	return middles;
}

// Returns an array whose values stay in the file, or null if they cannot.
vtkSmartPointer<vtkDataArray> arrayLeft(const hdf5::NetcdfFile& file, const CfVolume& volume, const CfSlab& slab,
                                        const std::array<std::size_t, 3>& lengths, const Request& request)
{
	const auto [x, y, z] = volume.sides;
	const std::size_t sides = slab.counts.size();
	const std::optional<NumberType> type = cfTypeMeant(file, volume.variable);
	if (!type || volume.staggered)
		return nullptr;
	arrays::ValueLayout layout{{}, 1, *type};
	for (std::size_t axis = 0; axis < 3; ++axis)
		layout.points[axis] = static_cast<std::uint32_t>(lengths[axis]);
	if (!request.leaves(layout.byteCount()))
		return nullptr;
	std::optional<arrays::StoredPlace> place;
	if (x + 1 == sides && y + 2 == sides && z + 3 == sides && cfIsPlain(file, volume.variable))
		place = file.storedPlace(volume.variable, {slab.starts.begin(), slab.starts.end() - 3});
	if (!place)
		place = cfStoredPlace(file, volume, slab, lengths);
	return place ? arrays::storedArray(layout, volume.name, std::move(*place)) : nullptr;
}

vtkSmartPointer<vtkDataArray> arrayOfVolume(const hdf5::NetcdfFile& file, const CfVolumes& volumes,
                                            const CfVolume& volume, std::size_t step, const Request& request)
{
	CfSlab slab = CfSlab::of(file, volume.variable);
	if (volume.time)
		slab.fix(*volume.time, step);
	std::array<std::size_t, 3> lengths = {volumes.axes[0].length, volumes.axes[1].length, volumes.axes[2].length};
	if (volume.staggered)
		++lengths[*volume.staggered];
	vtkSmartPointer<vtkDataArray> array = arrayLeft(file, volume, slab, lengths, request);
	if (!array)
		array = withXFastest(cfArray(file, volume.variable, slab), volume.sides, lengths);
	if (volume.staggered)
		array = atMiddles(array, lengths, *volume.staggered);
	array->SetName(volume.name.c_str());
	if (const std::string units = file.text(volume.variable, "units"); !units.empty())
		array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
	return array;
}

void readByConventions(const hdf5::NetcdfFile& file, const Request& request, manifest::Writer& manifest)
{
	const CfVolumes volumes = cfVolumes(file);
	for (const std::string& note : volumes.notes)
		manifest.warn(note);
	const std::size_t step = chooseStepOf(file, volumes, request, manifest);
	const CfGrid grid = cfGrid(file, volumes, step);
	for (const std::string& note : grid.notes)
		manifest.warn(note);
	manifest.setLengthUnits(grid.length_units);
	vtkDataSetAttributes* fields = grid.data->GetPointData();
	if (grid.has_cell_values)
		fields = grid.data->GetCellData();
	if (std::ranges::any_of(volumes.all, [](const CfVolume& volume) { return volume.staggered.has_value(); }))
		manifest.warn("of variables on the sides of cells, the means at their middles are shown");
	Request reading = request; // arrays of other grids are handed over
	const bool is_straight = grid.data->IsA("vtkImageData") || grid.data->IsA("vtkRectilinearGrid");
	if (!is_straight || grid.data->GetCellGhostArray() || grid.data->GetPointGhostArray())
		reading.stays_above = ~std::uint64_t(0);
	for (const CfVolume& volume : volumes.all)
		fields->AddArray(arrayOfVolume(file, volumes, volume, step, reading));
	manifest.add(grid.data);
}

} // namespace

void readNetcdf(const Request& request, manifest::Writer& manifest)
{
	checks::refuseShortNetcdf(request.file);
	hdf5::refuseMissingParts(request.file);
	readByConventions(hdf5::NetcdfFile(request.file), request, manifest);
}

void readZarr(const Request& request, manifest::Writer& manifest)
{
	const ZarrGroup group = ZarrGroup::of(request.file);
	if (const auto image = OmeZarr::of(group))
		return readOmeZarr(*image, request, manifest);
	const ZarrFile file(group, request.file);
	manifest.setImaging({.labels = file.hasLabels()});
	readByConventions(file, request, manifest);
}

} // namespace vp::reader::volumes
