// Results of CONVERGE CFD (HDF5), by a parser of our own: VTK's writes past its memory where numbers have more bytes
// than float and int, and shows what lies in memory where ids are wrong or lists too short.
#include "fluent_case.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/cell_boxes.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace vp::reader::codes
{

namespace
{

std::vector<double> convergePlaces(const hdf5::File& file, const std::string& stream)
{
	std::array<std::vector<double>, 3> along;
	for (std::size_t axis = 0; axis < 3; ++axis)
		along[axis] = file.reals(stream + "/VERTEX_COORDINATES/" + "XYZ"[axis]);
	const std::size_t count = along[0].size();
	if (along[1].size() != count || along[2].size() != count)
		throw damaged("its points have not as many coordinates along each axis");
	std::vector<double> places;
	for (std::size_t p = 0; p < count; ++p)
		places.insert(places.end(), {along[0][p], along[1][p], along[2][p]});
	return places;
}

// Six times the volume that the boundary's faces enclose, if they are seen counterclockwise from outside where their
// first cell is the one that exists.
double enclosedVolume(const FluentCase& mesh)
{
	double sum = 0.0;
	for (std::size_t f = 0; f < mesh.sides.size(); ++f)
	{
		if ((mesh.sides[f][0] < 0) == (mesh.sides[f][1] < 0))
			continue;
		const double sign = mesh.sides[f][0] < 0 ? -1.0 : 1.0;
		const auto at = [&](std::size_t corner)
		{ return mesh.coordinates.data() + 3 * static_cast<std::size_t>(mesh.corners[corner]); };
		const std::size_t first = mesh.face_starts[f];
		for (std::size_t c = first + 1; c + 1 < mesh.face_starts[f + 1]; ++c)
		{
			const double *a = at(first), *b = at(c), *d = at(c + 1);
			sum += sign * (a[0] * (b[1] * d[2] - b[2] * d[1]) - a[1] * (b[0] * d[2] - b[2] * d[0]) +
			               a[2] * (b[0] * d[1] - b[1] * d[0]));
		}
	}
	return sum;
}

// Polygons, and the cells on both sides of each: a number below 0 is that of a boundary.
FluentCase convergeMesh(const hdf5::File& file, const std::string& stream)
{
	FluentCase mesh;
	mesh.coordinates = convergePlaces(file, stream);
	const auto points = static_cast<std::int64_t>(mesh.coordinates.size() / 3);
	const std::vector<std::int64_t> starts = file.integers(stream + "/CONNECTIVITY/POLYGON_OFFSET");
	const std::vector<std::int64_t> corners = file.integers(stream + "/CONNECTIVITY/POLYGON_TO_VERTEX");
	const std::vector<std::int64_t> sides = file.integers(stream + "/CONNECTIVITY/CONNECTED_CELLS");
	constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
	if (starts.size() < 2 || sides.size() != 2 * (starts.size() - 1) || starts[0] != 0 ||
	    starts.back() != static_cast<std::int64_t>(corners.size()) || points > most)
		throw damaged("its polygons, their corners and their cells do not match each other");
	for (const std::int64_t corner : corners)
	{
		if (corner < 0 || corner >= points)
			throw damaged(fmt::format("a polygon has the point {} of {}", corner, points));
		mesh.corners.push_back(static_cast<std::int32_t>(corner));
	}
	mesh.face_starts.clear();
	for (std::size_t f = 0; f < starts.size(); ++f)
	{
		if (f > 0 && starts[f] < starts[f - 1] + 3)
			throw damaged(fmt::format("a polygon of {} corners", starts[f] - starts[f - 1]));
		mesh.face_starts.push_back(static_cast<std::size_t>(starts[f]));
	}
	for (std::size_t f = 0; f < sides.size(); f += 2)
	{
		if (sides[f] >= most || sides[f + 1] >= most)
			throw damaged("a polygon has a cell that is not there");
		mesh.sides.push_back({static_cast<std::int32_t>(std::max<std::int64_t>(sides[f], -1)),
		                      static_cast<std::int32_t>(std::max<std::int64_t>(sides[f + 1], -1))});
		mesh.cells = std::max({mesh.cells, sides[f] + 1, sides[f + 1] + 1});
	}
	// No cell has fewer than four faces.
	if (mesh.cells > static_cast<std::int64_t>(sides.size()) / 4)
		throw damaged(fmt::format("{} cells between {} polygons", mesh.cells, mesh.sides.size()));
	// As Fluent has them, faces turn the other way.
	if (enclosedVolume(mesh) > 0.0)
		for (auto& pair : mesh.sides)
			std::swap(pair[0], pair[1]);
	mesh.zones.push_back({0, stream.substr(1), 0, mesh.cells - 1});
	return mesh;
}

// A variable that lies in three data sets by its components, or in one.
struct ConvergeVariable
{
	std::string name;
	std::vector<std::string> paths;
};

std::vector<ConvergeVariable> convergeVariables(const hdf5::File& file, const std::string& group)
{
	const std::vector<std::string> names = file.namesIn(group);
	const auto is = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
	std::vector<ConvergeVariable> variables;
	for (const std::string& name : names)
	{
		const std::string base = name.size() > 2 && name[name.size() - 2] == '_' ? name.substr(0, name.size() - 2) : "";
		const bool is_vector = !base.empty() && is(base + "_X") && is(base + "_Y") && is(base + "_Z");
		if (is_vector && name.ends_with("_X"))
			variables.push_back({base, {group + base + "_X", group + base + "_Y", group + base + "_Z"}});
		else if (!(is_vector && (name.ends_with("_Y") || name.ends_with("_Z"))) && file.isSet(group + name))
			variables.push_back({name, {group + name}});
	}
	return variables;
}

void addConvergeStream(const hdf5::File& file, const std::string& stream, const Request& request,
                       manifest::Writer& manifest)
{
	const FluentCase mesh = convergeMesh(file, stream);
	const auto cells = static_cast<std::size_t>(mesh.cells);
	const auto grid = fluentGrid(mesh, mesh.zones[0]);
	const std::vector<ConvergeVariable> variables = convergeVariables(file, stream + "/CELL_CENTER_DATA/");
	std::vector<boxes::CellArrayName> names;
	for (const ConvergeVariable& variable : variables)
		names.push_back({variable.name, static_cast<int>(variable.paths.size())});
	const boxes::CellArrayChoice choice(request, names);
	for (const ConvergeVariable& variable : variables)
	{
		if (std::ranges::find(choice.wanted(), variable.name) == choice.wanted().end())
			continue;
		const std::size_t components = variable.paths.size();
		std::vector<double> values(cells * components);
		for (std::size_t i = 0; i < components; ++i)
		{
			const std::vector<double> along = file.reals(variable.paths[i]);
			if (along.size() != cells)
				throw damaged(fmt::format("{} has {} values for {} cells", variable.paths[i], along.size(), cells));
			for (std::size_t c = 0; c < cells; ++c)
				values[c * components + i] = along[c];
		}
		boxes::addCellArray(grid, variable.name, values);
	}
	choice.noteLeftOut(manifest);
	manifest.setPrefix(mesh.zones[0].name);
	manifest.add(grid);
}

} // namespace

void readConverge(const Request& request, manifest::Writer& manifest)
{
	const hdf5::File file(request.file);
	boxes::offerOnlyTime(file.realOr("/", "OUTPUT_TIME", std::numeric_limits<double>::quiet_NaN()), request, manifest);
	for (const std::string& name : file.namesIn("/"))
		if (name.starts_with("STREAM_"))
			addConvergeStream(file, "/" + name, request, manifest);
}

} // namespace vp::reader::codes
