// Meshes of SLAC's codes for accelerators (netCDF), with the modes that lie in a file of their own. By a parser of our
// own: VTK's takes ids as they come.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/formats/volumes/cf_values.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/hdf5/netcdf_file.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <filesystem>
#include <map>

namespace
{

// By the volume that they are in.
using SlacTetrahedra = std::map<std::int64_t, std::vector<std::array<vtkIdType, 4>>>;

constexpr std::size_t kMaxVolumes = 4096;
// What the files call a frequency is a time in seconds where it is less than any frequency that they are about.
constexpr double kMinFrequency = 100.0;

double volumeOf(const std::vector<double>& places, const std::array<vtkIdType, 4>& ids)
{
	std::array<std::array<double, 3>, 3> edge;
	for (std::size_t e = 0; e < 3; ++e)
		for (std::size_t axis = 0; axis < 3; ++axis)
			edge[e][axis] = places[3 * static_cast<std::size_t>(ids[e + 1]) + axis] -
			                places[3 * static_cast<std::size_t>(ids[0]) + axis];
	return edge[0][0] * (edge[1][1] * edge[2][2] - edge[1][2] * edge[2][1]) -
	       edge[0][1] * (edge[1][0] * edge[2][2] - edge[1][2] * edge[2][0]) +
	       edge[0][2] * (edge[1][0] * edge[2][1] - edge[1][1] * edge[2][0]);
}

// Rows of a volume, four points and, on the boundary, what bounds each of the faces.
void addSlacTetrahedra(const NetcdfFile& file, const char* name, std::size_t row, const std::vector<double>& places,
                       SlacTetrahedra& all)
{
	const int variable = file.variable(name);
	if (variable < 0)
		return;
	const auto sides = file.dimensions(variable);
	if (sides.size() != 2 || sides[1].second != row)
		throw damaged(fmt::format("{} has no rows of {}", name, row));
	const std::vector<double> numbers = file.values(variable);
	for (std::size_t at = 0; at < numbers.size(); at += row)
	{
		std::array<vtkIdType, 4> ids;
		for (std::size_t i = 0; i < 4; ++i)
		{
			const double id = numbers[at + 1 + i];
			if (!(id >= 0.0 && 3.0 * id < static_cast<double>(places.size())))
				throw damaged(fmt::format("{} has the point {} of {}", name, id, places.size() / 3));
			ids[i] = static_cast<vtkIdType>(id);
		}
		if (volumeOf(places, ids) < 0.0)
			std::swap(ids[0], ids[1]);
		if (!(std::abs(numbers[at]) < 1e9))
			throw damaged(fmt::format("{} has the volume {}", name, numbers[at]));
		all[static_cast<std::int64_t>(numbers[at])].push_back(ids);
		if (all.size() > kMaxVolumes)
			throw damaged("it has more volumes than it can");
	}
}

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
	refuseShortNetcdf(path);
	refuseMissingParts(path);
	const NetcdfFile file(path);
	for (const char* name : {"frequency", "frequencyreal"})
		if (const int variable = file.variable(name); variable >= 0)
			if (const std::vector<double> numbers = file.values(variable); numbers.size() == 1)
				time = numbers[0];
	std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
	for (const auto& [variable, name, type] : file.variables())
	{
		const auto sides = file.dimensions(variable);
		if (cfTypeOf(file, variable) == 0 || sides.empty() || sides.size() > 2 || sides[0].first != "ncoord" ||
		    name == "coords" || (sides.size() == 2 && sides[1].second > 64))
			continue;
		const std::vector<double> values = cfNumbers(file, variable);
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

// A volume's tetrahedra, with the points that they use.
vtkSmartPointer<vtkUnstructuredGrid> slacGrid(const std::vector<std::array<vtkIdType, 4>>& tetrahedra,
                                              const std::vector<double>& places,
                                              const std::vector<vtkSmartPointer<vtkDoubleArray>>& modes)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	vtkPointData* data = grid->GetPointData();
	for (const auto& mode : modes)
	{
		vtkNew<vtkDoubleArray> part;
		part->SetName(mode->GetName());
		part->SetNumberOfComponents(mode->GetNumberOfComponents());
		data->AddArray(part);
	}
	std::vector<vtkIdType> new_ids(places.size() / 3, -1);
	vtkNew<vtkCellArray> cells;
	for (std::array<vtkIdType, 4> ids : tetrahedra)
	{
		for (vtkIdType& id : ids)
		{
			vtkIdType& new_id = new_ids[static_cast<std::size_t>(id)];
			if (new_id < 0)
			{
				new_id = points->InsertNextPoint(places.data() + 3 * id);
				for (std::size_t m = 0; m < modes.size(); ++m)
					data->GetArray(static_cast<int>(m))->InsertNextTuple(id, modes[m]);
			}
			id = new_id;
		}
		cells->InsertNextCell(4, ids.data());
	}
	grid->SetPoints(points);
	grid->SetCells(VTK_TETRA, cells);
	return grid;
}

} // namespace

void readSlac(const Request& request, ManifestWriter& manifest)
{
	refuseShortNetcdf(request.file);
	refuseMissingParts(request.file);
	const NetcdfFile file(request.file);
	const int variable = file.variable("coords");
	const std::vector<double> places = variable < 0 ? std::vector<double>() : cfNumbers(file, variable);
	if (places.empty() || places.size() % 3 != 0)
		throw damaged("it has no places of points (coords)");
	SlacTetrahedra volumes;
	addSlacTetrahedra(file, "tetrahedron_interior", 5, places, volumes);
	addSlacTetrahedra(file, "tetrahedron_exterior", 9, places, volumes);

	const std::string path = request.solution.empty() ? slacModesBeside(request.file) : request.solution;
	std::vector<vtkSmartPointer<vtkDoubleArray>> modes;
	double time = kMinFrequency;
	if (path.empty())
		manifest.warn("no file of modes (.mod), or more than one, lies beside this mesh; --solution names one");
	else
		modes = slacModes(path, places.size() / 3, time);
	std::vector<double> times = inOrder({time});
	if (!(time < kMinFrequency))
		times.clear();
	chooseIfAny(times, request);
	manifest.offerTimes(std::move(times));
	for (const auto& [volume, tetrahedra] : volumes)
	{
		manifest.setPrefix(volumes.size() > 1 ? fmt::format("volume {}", volume) : "");
		manifest.add(slacGrid(tetrahedra, places, modes));
	}
}
