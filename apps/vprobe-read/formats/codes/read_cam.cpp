// Results of the atmosphere model CAM on its cubed sphere: columns in one file, the quads between them in another. By a
// reader of our own: VTK's does not look whether the netCDF library could read its ids and times.
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/file_head.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/formats/volumes/cf_values.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

namespace vp::reader::codes
{

namespace
{

using CamSides = std::vector<std::pair<std::string, std::size_t>>;

// Returns the first file beside the results that lists quads, or an empty text if there is none.
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
		    checks::FileHead(entry->path().string()).holds("element_corners"))
			return entry->path().string();
	return {};
}

// The columns of one layer, and the quads between them. A column on the other side of the longitude 0 is there twice.
struct CamLayer
{
	std::vector<double> x, y;
	std::vector<std::size_t> columns; // the column in the file, for each place
	std::vector<std::array<std::size_t, 4>> quads;
	std::size_t around_a_pole = 0; // quads that are left out
};

std::vector<double> camPlaces(const hdf5::NetcdfFile& file, const char* name)
{
	const int variable = file.variable(name);
	std::vector<double> places = variable < 0 ? std::vector<double>() : volumes::cfNumbers(file, variable);
	if (places.size() != file.length("ncol"))
		throw damaged(fmt::format("{} has not a place for each column", name));
	return places;
}

// Puts the corners of a quad on one side of the longitude 0: on that of the corner which is farthest from it.
class CamSeam
{
public:
	explicit CamSeam(CamLayer& layer) : layer_(layer) {}

	// False if they lie more than half a turn apart even so.
	bool close(std::array<std::size_t, 4>& quad)
	{
		if (!isTorn(quad))
			return true;
		double farthest = 0.0;
		bool is_left = false;
		for (const std::size_t corner : quad)
		{
			const double from_left = layer_.x[corner], from_right = 360.0 - layer_.x[corner];
			const double off = std::min(std::abs(from_left), std::abs(from_right));
			if (off > farthest)
			{
				farthest = off;
				is_left = from_left < from_right;
			}
		}
		for (std::size_t& corner : quad)
			if (is_left != (layer_.x[corner] < 180.0))
				corner = moved(corner, is_left ? -360.0 : 360.0);
		return !isTorn(quad);
	}

private:
	bool isTorn(const std::array<std::size_t, 4>& quad) const
	{
		double least = INFINITY, most = -INFINITY;
		for (const std::size_t corner : quad)
		{
			least = std::min(least, layer_.x[corner]);
			most = std::max(most, layer_.x[corner]);
		}
		return most - least > 180.0;
	}
	std::size_t moved(std::size_t corner, double by)
	{
		const auto [known, is_new] = moved_.try_emplace({corner, by > 0.0}, layer_.x.size());
		if (is_new)
		{
			layer_.columns.push_back(layer_.columns[corner]);
			layer_.y.push_back(layer_.y[corner]);
			layer_.x.push_back(layer_.x[corner] + by);
		}
		return known->second;
	}

	CamLayer& layer_;
	std::map<std::pair<std::size_t, bool>, std::size_t> moved_;
};

CamLayer camLayer(const hdf5::NetcdfFile& file, const std::string& quads)
{
	CamLayer layer{camPlaces(file, "lon"), camPlaces(file, "lat"), {}, {}};
	const std::size_t columns = layer.x.size();
	layer.columns.resize(columns);
	std::iota(layer.columns.begin(), layer.columns.end(), std::size_t(0));
	const hdf5::NetcdfFile of_quads(quads);
	const int variable = of_quads.variable("element_corners");
	const CamSides sides = variable < 0 ? CamSides() : of_quads.dimensions(variable);
	if (sides.size() != 2 || sides[0].second != 4)
		throw damaged(fmt::format("{} lists no quads (element_corners)", quads));
	const std::vector<double> corners = volumes::cfNumbers(of_quads, variable);
	const std::size_t count = sides[1].second;
	CamSeam seam(layer);
	for (std::size_t q = 0; q < count; ++q)
	{
		std::array<std::size_t, 4> quad;
		for (std::size_t i = 0; i < 4; ++i)
		{
			const double column = corners[i * count + q];
			if (!(column >= 1.0 && column <= static_cast<double>(columns)))
				throw Refusal(fmt::format("{} has a quad with the column {} of {}; name the file of this grid with "
				                          "--solution",
				                          quads, column, columns));
			quad[i] = static_cast<std::size_t>(column) - 1;
		}
		if (seam.close(quad))
			layer.quads.push_back(quad);
		else
			++layer.around_a_pole;
	}
	return layer;
}

// x and y are longitude and latitude, z counts the layers from the ground, which is the last one.
vtkSmartPointer<vtkUnstructuredGrid> camGrid(const CamLayer& layer, std::size_t layers)
{
	const std::size_t places = layer.x.size();
	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	for (std::size_t k = 0; k < layers; ++k)
		for (std::size_t i = 0; i < places; ++i)
			points->InsertNextPoint(layer.x[i], layer.y[i], static_cast<double>(layers - 1 - k));
	vtkNew<vtkCellArray> cells;
	for (const auto& quad : layer.quads)
		for (std::size_t k = 0; k + 1 < layers; ++k)
		{
			std::array<vtkIdType, 8> corners;
			for (std::size_t i = 0; i < 8; ++i)
				corners[i] = static_cast<vtkIdType>(quad[i % 4] + (k + i / 4) * places);
			cells->InsertNextCell(8, corners.data());
		}
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(points);
	grid->SetCells(VTK_HEXAHEDRON, cells);
	return grid;
}

// Variables of [time], lev and ncol.
void addCamArrays(const hdf5::NetcdfFile& file, const CamLayer& layer, std::size_t layers, std::size_t step,
                  vtkUnstructuredGrid* grid)
{
	for (const auto& [variable, name, type] : file.variables())
	{
		const CamSides sides = file.dimensions(variable);
		const std::size_t first = !sides.empty() && sides[0].first == "time" ? 1 : 0;
		if (volumes::cfTypeOf(file, variable) == 0 || sides.size() != first + 2 || sides[first].first != "lev" ||
		    sides[first + 1].first != "ncol")
			continue;
		volumes::CfSlab slab = volumes::CfSlab::of(file, variable);
		if (first == 1)
			slab.fix(0, step);
		const vtkSmartPointer<vtkDataArray> values = volumes::cfArray(file, variable, slab);
		const auto array = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
		array->SetName(name.c_str());
		array->SetNumberOfTuples(grid->GetNumberOfPoints());
		for (std::size_t k = 0, p = 0; k < layers; ++k)
			for (const std::size_t column : layer.columns)
				array->SetTuple(static_cast<vtkIdType>(p++),
				                static_cast<vtkIdType>(k * (values->GetNumberOfTuples() / layers) + column), values);
		grid->GetPointData()->AddArray(array);
	}
}

} // namespace

void readCam(const Request& request, manifest::Writer& manifest)
{
	const std::string quads = request.solution.empty() ? quadsBeside(request.file) : request.solution;
	if (quads.empty())
		throw Refusal(
		    "columns of CAM, whose quads are in another file (with element_corners); put it beside this one, or "
		    "name it with --solution");
	for (const std::string& name : {request.file, quads})
	{
		checks::refuseShortNetcdf(name);
		hdf5::refuseMissingParts(name);
	}
	const hdf5::NetcdfFile file(request.file);
	const std::size_t layers = file.length("lev");
	if (layers < 2)
		throw Refusal("nothing to slice: columns of CAM with fewer than two layers (lev)");
	std::vector<double> times(file.length("time"));
	std::iota(times.begin(), times.end(), 0.0);
	if (const int variable = file.variable("time"); variable >= 0 && file.dimensions(variable).size() == 1)
	{
		times = volumes::cfNumbers(file, variable);
		manifest.setTimeUnits(file.text(variable, "units"));
	}
	const std::optional<std::size_t> step = manifest::offerSteps(times, request, manifest);
	const CamLayer layer = camLayer(file, quads);
	if (layer.around_a_pole > 0)
		manifest.warn(fmt::format("{} quads around a pole are left out", layer.around_a_pole));
	const auto grid = camGrid(layer, layers);
	addCamArrays(file, layer, layers, step.value_or(0), grid);
	manifest.add(grid);
}

} // namespace vp::reader::codes
