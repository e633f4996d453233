// Fluent's case and data files in HDF5 ("common fluids format"), by a parser of our own: VTK 9.1 has none. The layout
// is that which VTK 9.2's reader takes.
#include "fluent_case.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/cell_boxes.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace vp::reader::codes
{

namespace
{

const std::string kFluentMesh = "/meshes/1";
constexpr std::int64_t kMaxFluentItems = std::numeric_limits<std::int32_t>::max();

// Items whose numbers follow each other, from 1: those of an object with the attributes minId and maxId.
struct FluentRange
{
	std::int64_t first = 0; // from 0
	std::size_t count = 0;
};

FluentRange fluentRange(const hdf5::File& file, const std::string& object, std::int64_t items)
{
	const double first = file.realOr(object, "minId", 0.0), last = file.realOr(object, "maxId", -1.0);
	if (!(first >= 1.0 && last >= first && last <= static_cast<double>(items)))
		throw damaged(fmt::format("{} holds the numbers {} to {} of {}", object, first, last, items));
	return {static_cast<std::int64_t>(first) - 1, static_cast<std::size_t>(last - first) + 1};
}

std::int64_t fluentCount(const hdf5::File& file, const char* attribute)
{
	const double count = file.realOr(kFluentMesh, attribute, -1.0);
	if (!(count >= 1.0 && count <= static_cast<double>(kMaxFluentItems)))
		throw damaged(fmt::format("it has {} {}", count, attribute));
	return static_cast<std::int64_t>(count);
}

// "1", "2" and so on, in their order.
std::vector<std::string> fluentParts(const hdf5::File& file, const std::string& group)
{
	std::vector<std::string> paths;
	for (std::size_t part = 1; file.has(fmt::format("{}/{}", group, part)); ++part)
		paths.push_back(fmt::format("{}/{}", group, part));
	return paths;
}

void readFluentNodes(const hdf5::File& file, FluentCase& mesh)
{
	const std::int64_t nodes = fluentCount(file, "nodeCount");
	for (const std::string& name : file.namesIn(kFluentMesh + "/nodes/coords"))
	{
		const std::string path = kFluentMesh + "/nodes/coords/" + name;
		const FluentRange range = fluentRange(file, path, nodes);
		const std::vector<double> places = file.reals(path);
		if (places.size() != 3 * range.count)
			throw damaged(fmt::format("{} has {} coordinates for {} nodes", path, places.size(), range.count));
		const std::size_t end = 3 * (static_cast<std::size_t>(range.first) + range.count);
		mesh.coordinates.resize(std::max(mesh.coordinates.size(), end), std::numeric_limits<double>::quiet_NaN());
		std::copy(places.begin(), places.end(), mesh.coordinates.begin() + 3 * range.first);
	}
	if (mesh.coordinates.size() != 3 * static_cast<std::size_t>(nodes))
		throw damaged(fmt::format("{} of {} nodes have a place", mesh.coordinates.size() / 3, nodes));
}

void readFluentCells(const hdf5::File& file, FluentCase& mesh)
{
	mesh.cells = fluentCount(file, "cellCount");
	const std::string zones = kFluentMesh + "/cells/zoneTopology";
	const std::vector<std::int64_t> ids = file.integers(zones + "/id");
	const std::vector<std::int64_t> first = file.integers(zones + "/minId");
	const std::vector<std::int64_t> last = file.integers(zones + "/maxId");
	if (first.size() != ids.size() || last.size() != ids.size())
		throw damaged("its zones of cells do not match each other");
	std::vector<std::string> names; // "fluid;solid"
	for (const std::string& text : file.texts(zones + "/name"))
		for (std::size_t at = 0; at < text.size();)
		{
			const std::size_t end = std::min(text.find(';', at), text.size());
			names.push_back(text.substr(at, end - at));
			at = end + 1;
		}
	for (std::size_t z = 0; z < ids.size(); ++z)
	{
		if (first[z] < 1 || last[z] < first[z] || last[z] > mesh.cells)
			throw damaged("a zone of cells that cannot be");
		const bool is_named = names.size() == ids.size() && !names[z].empty();
		mesh.zones.push_back({ids[z], is_named ? names[z] : fmt::format("zone {}", ids[z]), first[z] - 1, last[z] - 1});
	}
}

// The corners of faces one after the other, as each must have its own.
void readFluentFaces(const hdf5::File& file, FluentCase& mesh)
{
	const std::int64_t faces = fluentCount(file, "faceCount");
	const auto nodes = static_cast<std::int64_t>(mesh.coordinates.size() / 3);
	for (const std::string& part : fluentParts(file, kFluentMesh + "/faces/nodes"))
	{
		const FluentRange range = fluentRange(file, part, faces);
		const std::vector<std::int64_t> counts = file.integers(part + "/nnodes");
		const std::vector<std::int64_t> corners = file.integers(part + "/nodes");
		if (range.first != static_cast<std::int64_t>(mesh.face_starts.size()) - 1 || counts.size() != range.count)
			throw damaged("its lists of faces do not follow each other");
		std::size_t at = 0;
		for (const std::int64_t count : counts)
		{
			if (count < 3 || static_cast<std::uint64_t>(count) > corners.size() - at)
				throw damaged(fmt::format("a face of {} corners", count));
			for (const std::size_t end = at + static_cast<std::size_t>(count); at < end; ++at)
			{
				if (corners[at] < 1 || corners[at] > nodes)
					throw damaged(fmt::format("a face has the node {} of {}", corners[at], nodes));
				mesh.corners.push_back(static_cast<std::int32_t>(corners[at] - 1));
			}
			mesh.face_starts.push_back(mesh.corners.size());
		}
	}
	if (static_cast<std::int64_t>(mesh.face_starts.size()) - 1 != faces)
		throw damaged(fmt::format("{} of {} faces have corners", mesh.face_starts.size() - 1, faces));
	mesh.sides.assign(static_cast<std::size_t>(faces), {-1, -1});
	for (std::size_t side = 0; side < 2; ++side)
		for (const std::string& part : fluentParts(file, kFluentMesh + (side == 0 ? "/faces/c0" : "/faces/c1")))
		{
			const FluentRange range = fluentRange(file, part, faces);
			const std::vector<std::int64_t> cells = file.integers(part);
			if (cells.size() != range.count)
				throw damaged(fmt::format("{} has {} cells for {} faces", part, cells.size(), range.count));
			for (std::size_t f = 0; f < range.count; ++f)
			{
				if (cells[f] < 0 || cells[f] > mesh.cells)
					throw damaged(fmt::format("a face has the cell {} of {}", cells[f], mesh.cells));
				mesh.sides[static_cast<std::size_t>(range.first) + f][side] = static_cast<std::int32_t>(cells[f] - 1);
			}
		}
}

FluentCase fluentMesh(const hdf5::File& file)
{
	if (file.realOr(kFluentMesh, "dimension", 3.0) != 3.0)
		throw Refusal("nothing to slice: a Fluent case of two dimensions");
	if (file.has(kFluentMesh + "/cells/tree") || file.has(kFluentMesh + "/faces/tree"))
		throw Refusal(
		    "a refined mesh of Fluent in HDF5, whose tree of cells is not read; write it as .cas without HDF5");
	FluentCase mesh;
	readFluentNodes(file, mesh);
	readFluentCells(file, mesh);
	readFluentFaces(file, mesh);
	return mesh;
}

// A field of a phase: data sets "1", "2" and so on, for cells from minId to maxId.
struct FluentField
{
	std::string name;
	std::vector<std::string> parts;
	std::size_t components;
};

std::vector<FluentField> fluentFields(const hdf5::File& file)
{
	std::vector<FluentField> fields;
	for (std::size_t phase = 1; file.has(fmt::format("/results/1/phase-{}/cells", phase)); ++phase)
	{
		const std::string group = fmt::format("/results/1/phase-{}/cells", phase);
		for (const std::string& name : file.namesIn(group))
		{
			if (file.isSet(group + "/" + name)) // "fields", which lists the names
				continue;
			FluentField field = {phase == 1 ? name : fmt::format("phase_{}-{}", phase - 1, name),
			                     fluentParts(file, group + "/" + name), 0};
			for (const std::string& part : field.parts)
			{
				const std::vector<std::uint64_t> sides = file.sidesOf(part);
				const std::size_t components = sides.size() == 2 ? sides[1] : 1;
				if (sides.empty() || sides.size() > 2 || components < 1 || components > 64 ||
				    (field.components != 0 && components != field.components))
					throw damaged(fmt::format("{} has a number of components that cannot be", part));
				field.components = components;
			}
			if (!field.parts.empty())
				fields.push_back(std::move(field));
		}
	}
	return fields;
}

// Returns the values of all cells of the mesh; NaN if the file says nothing about a cell.
std::vector<double> fluentValues(const std::string& path, const FluentField& field, std::int64_t cells)
{
	const hdf5::File file(path);
	std::vector<double> values(static_cast<std::size_t>(cells) * field.components,
	                           std::numeric_limits<double>::quiet_NaN());
	for (const std::string& part : field.parts)
	{
		if (const double last = file.realOr(part, "maxId", 0.0); last > static_cast<double>(cells))
			throw Refusal(fmt::format("{} holds values of {} cells where the case has {}; name the right one with "
			                          "--solution",
			                          path, last, cells));
		const FluentRange range = fluentRange(file, part, cells);
		const std::vector<double> read = file.reals(part);
		if (read.size() != range.count * field.components)
			throw damaged(fmt::format("{} has {} values for {} cells", part, read.size(), range.count));
		std::copy(read.begin(), read.end(),
		          values.begin() + range.first * static_cast<std::ptrdiff_t>(field.components));
	}
	return values;
}

// run.cas.h5 has run.dat.h5 beside it. Empty where there is none.
std::string fluentHdf5DataBeside(const std::string& file)
{
	const std::size_t ending = file.rfind(".cas");
	const std::string data = ending == file.npos ? "" : file.substr(0, ending) + ".dat" + file.substr(ending + 4);
	std::error_code ignored;
	return !data.empty() && std::filesystem::is_regular_file(data, ignored) ? data : std::string();
}

} // namespace

void readFluentHdf5(const Request& request, manifest::Writer& manifest)
{
	const FluentCase mesh = fluentMesh(hdf5::File(request.file));
	const std::string path = request.solution.empty() ? fluentHdf5DataBeside(request.file) : request.solution;
	std::vector<boxes::CellArrayName> names;
	std::vector<std::vector<double>> values;
	std::vector<FluentField> fields;
	if (path.empty())
		manifest.warn("no data file (.dat.h5) lies beside this Fluent case; --solution names one");
	else
		fields = fluentFields(hdf5::File(path));
	for (const FluentField& field : fields)
		names.push_back({field.name, static_cast<int>(field.components)});
	const boxes::CellArrayChoice choice(request, names);
	std::erase_if(fields, [&](const FluentField& field)
	              { return std::ranges::find(choice.wanted(), field.name) == choice.wanted().end(); });
	for (const FluentField& field : fields)
		values.push_back(fluentValues(path, field, mesh.cells));
	for (const FluentZone& zone : mesh.zones)
	{
		const auto grid = fluentGrid(mesh, zone);
		for (std::size_t f = 0; f < fields.size(); ++f)
			boxes::addCellArray(grid, fields[f].name,
			                    std::span(values[f]).subspan(
			                        static_cast<std::size_t>(zone.first) * fields[f].components,
			                        static_cast<std::size_t>(zone.last - zone.first + 1) * fields[f].components));
		choice.noteLeftOut(manifest);
		manifest.setPrefix(zone.name);
		manifest.add(grid);
	}
}

} // namespace vp::reader::codes
