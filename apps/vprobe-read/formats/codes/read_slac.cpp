// Meshes of SLAC's codes for accelerators (netCDF), by VTK's reader. The modes, which lie in a file of their own, are
// read here: VTK's reader turns them by their frequency, and rounds them on the way.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/formats/volumes/cf_values.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/hdf5/netcdf_file.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDoubleArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSLACReader.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>

namespace vp::reader::codes
{

namespace
{

// A number that the files call a frequency is a time in seconds if it is less than any frequency that they are about.
constexpr double kMinFrequency = 100.0;

// The only file of modes beside the mesh; empty where there are several or none.
std::string slacModesBeside(const std::string& mesh)
{
	namespace fs = std::filesystem;
	const fs::path folder = fs::path(mesh).has_parent_path() ? fs::path(mesh).parent_path() : fs::path(".");
	std::string found;
	std::error_code error;
	int left = 1000;
	for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator() && left > 0;
	     entry.increment(error), --left)
		if (entry->is_regular_file(error) && entry->path().extension() == ".mod")
		{
			if (!found.empty())
				return {};
			found = entry->path().string();
		}
	return found;
}

// Variables of the mesh's points, and the time.
std::vector<vtkSmartPointer<vtkDoubleArray>> slacModes(const std::string& path, std::size_t points, double& time)
{
	checks::refuseShortNetcdf(path);
	hdf5::refuseMissingParts(path);
	const hdf5::NetcdfFile file(path);
	for (const char* name : {"frequency", "frequencyreal"})
		if (const int variable = file.variable(name); variable >= 0)
			if (const std::vector<double> numbers = file.values(variable); numbers.size() == 1)
				time = numbers[0];
	std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
	for (const auto& [variable, name, type] : file.variables())
	{
		const auto sides = file.dimensions(variable);
		if (volumes::cfTypeOf(file, variable) == 0 || sides.empty() || sides.size() > 2 || sides[0].first != "ncoord" ||
		    name == "coords" || (sides.size() == 2 && sides[1].second > 64))
			continue;
		const std::vector<double> values = volumes::cfNumbers(file, variable);
		if (sides[0].second != points || values.empty())
			throw Refusal(fmt::format("{} holds values of {} points where the mesh has {}; name the right one with "
			                          "--solution",
			                          path, sides[0].second, points));
		const auto array = vtkSmartPointer<vtkDoubleArray>::New();
		array->SetName(name.c_str());
		array->SetNumberOfComponents(static_cast<int>(values.size() / points));
		array->SetNumberOfTuples(static_cast<vtkIdType>(points));
		std::copy(values.begin(), values.end(), array->GetPointer(0));
		arrays.push_back(array);
	}
	return arrays;
}

// Tetrahedra by the volume that they are in. Each grid has all points of the mesh.
vtkSmartPointer<vtkMultiBlockDataSet> slacVolumes(const std::string& path)
{
	vtkNew<vtkSLACReader> reader;
	reader->SetMeshFileName(path.c_str());
	reader->ReadInternalVolumeOn();
	reader->ReadExternalSurfaceOff();
	reader->ReadMidpointsOff();
	reader->Update();
	checks::refuseOnComplaint();
	return vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(vtkSLACReader::VOLUME_OUTPUT));
}

} // namespace

void readSlac(const Request& request, manifest::Writer& manifest)
{
	checks::refuseShortNetcdf(request.file);
	hdf5::refuseMissingParts(request.file);
	const auto volumes = slacVolumes(request.file);
	std::vector<std::pair<unsigned, vtkUnstructuredGrid*>> grids;
	for (unsigned volume = 0; volume < volumes->GetNumberOfBlocks(); ++volume)
		if (auto* grid = vtkUnstructuredGrid::SafeDownCast(volumes->GetBlock(volume)))
			grids.emplace_back(volume, grid);
	if (grids.empty())
		throw Refusal("nothing to slice: it holds no tetrahedra");

	const std::string path = request.solution.empty() ? slacModesBeside(request.file) : request.solution;
	std::vector<vtkSmartPointer<vtkDoubleArray>> modes;
	double time = kMinFrequency;
	if (path.empty())
		manifest.warn("no file of modes (.mod), or more than one, lies beside this mesh; --solution names one");
	else
		modes = slacModes(path, static_cast<std::size_t>(grids[0].second->GetNumberOfPoints()), time);
	std::vector<double> times = manifest::inOrder({time});
	if (!(time < kMinFrequency))
		times.clear();
	manifest::chooseIfAny(times, request);
	manifest.offerTimes(std::move(times));
	for (const auto& [volume, grid] : grids)
	{
		for (const auto& mode : modes)
			grid->GetPointData()->AddArray(mode);
		manifest.setPrefix(grids.size() > 1 ? fmt::format("volume {}", volume) : "");
		manifest.add(grid);
	}
}

} // namespace vp::reader::codes
