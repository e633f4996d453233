#include "own_samples.h"
#include "sample_bytes.h"
#include "sample_hdf5.h"

#include <fmt/format.h>

#include <netcdf.h>

#include <algorithm>
#include <set>

namespace
{

using vp::Vec3;

// A mesh with its fields at an earlier and a later time. Cells are mirrored, as the description has them.
void writeMed(const std::string& path)
{
	SampleHdf5 file(path);
	const std::string mesh = "/ENS_MAA/box/-0000000000000000001-0000000000000000001";
	std::vector<double> places(3 * kSamplePointCount), f(kSamplePointCount), g(kSampleCellCount);
	std::vector<std::int64_t> nodes(8 * kSampleCellCount);
	eachSamplePoint(
	    [&](const Vec3& at, int p)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    places[static_cast<std::size_t>(axis) * kSamplePointCount + static_cast<std::size_t>(p)] = at[axis];
		    f[static_cast<std::size_t>(p)] = sampleValue(at);
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& c, int cell)
	    {
		    const std::array<int, 8> mirrored = {c[0], c[3], c[2], c[1], c[4], c[7], c[6], c[5]};
		    for (std::size_t i = 0; i < 8; ++i)
			    nodes[i * kSampleCellCount + static_cast<std::size_t>(cell)] = mirrored[i] + 1;
		    g[static_cast<std::size_t>(cell)] = sampleValue(middle);
	    });
	file.set(mesh + "/NOE/COO", {places.size()}, H5T_NATIVE_DOUBLE, places.data());
	file.set(mesh + "/MAI/HE8/NOD", {nodes.size()}, H5T_NATIVE_INT64, nodes.data());
	file.attribute("/ENS_MAA/box", "ESP", std::vector<double>{3.0});
	for (const double time : {0.0, 1.5})
	{
		if (time == 0.0)
			std::fill(f.begin(), f.end(), 0.0);
		else
			eachSamplePoint([&](const Vec3& at, int p) { f[static_cast<std::size_t>(p)] = sampleValue(at); });
		const std::string step = fmt::format("/{:020}{:020}", time == 0.0 ? 1 : 2, 0);
		const std::string all = "/MED_NO_PROFILE_INTERNAL/CO";
		file.set("/CHA/f" + step + "/NOE" + all, {f.size()}, H5T_NATIVE_DOUBLE, f.data());
		file.set("/CHA/g" + step + "/MAI.HE8" + all, {g.size()}, H5T_NATIVE_DOUBLE, g.data());
		for (const char* field : {"/CHA/f", "/CHA/g"})
			file.attribute(field + step, "PDT", std::vector<double>{time});
	}
	for (const char* field : {"/CHA/f", "/CHA/g"})
	{
		file.attribute(field, "NCO", std::vector<double>{1.0});
		file.attribute(field, "MAI", "box");
		file.attribute(field, "UNI", "K               ");
	}
}

// Two times of one mesh. The values of the first time are 0.
void writeVtkHdf(const std::string& path)
{
	SampleHdf5 file(path);
	std::vector<double> places, f(kSamplePointCount), g(kSampleCellCount);
	std::vector<std::int64_t> nodes, offsets = {0};
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    places.push_back(at[axis]);
		    f.push_back(sampleValue(at));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int)
	    {
		    nodes.insert(nodes.end(), corners.begin(), corners.end());
		    offsets.push_back(static_cast<std::int64_t>(nodes.size()));
		    g.push_back(sampleValue(middle));
	    });
	const auto list = [&](const std::string& name, const std::vector<std::int64_t>& numbers)
	{ file.set("/VTKHDF/" + name, {numbers.size()}, H5T_NATIVE_INT64, numbers.data()); };
	list("NumberOfPoints", {kSamplePointCount});
	list("NumberOfCells", {kSampleCellCount});
	list("NumberOfConnectivityIds", {8 * kSampleCellCount});
	list("Connectivity", nodes);
	list("Offsets", offsets);
	for (const char* name : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
		list(std::string("Steps/") + name, {0, 0});
	list("Steps/NumberOfParts", {1, 1});
	list("Steps/PointDataOffsets/f", {0, kSamplePointCount});
	list("Steps/CellDataOffsets/g", {0, kSampleCellCount});
	const std::vector<std::uint8_t> types(kSampleCellCount, 12);
	const std::vector<double> times = {0.5, 1.5};
	file.set("/VTKHDF/Types", {types.size()}, H5T_NATIVE_UINT8, types.data());
	file.set("/VTKHDF/Points", {kSamplePointCount, 3}, H5T_NATIVE_DOUBLE, places.data());
	file.set("/VTKHDF/PointData/f", {f.size()}, H5T_NATIVE_DOUBLE, f.data());
	file.set("/VTKHDF/CellData/g", {g.size()}, H5T_NATIVE_DOUBLE, g.data());
	file.set("/VTKHDF/Steps/Values", {times.size()}, H5T_NATIVE_DOUBLE, times.data());
	file.attribute("/VTKHDF", "Version", std::vector<double>{2.0, 0.0});
	file.attribute("/VTKHDF", "Type", "UnstructuredGrid");
	file.attribute("/VTKHDF/Steps", "NSteps", std::vector<double>{2.0});
}

// One part of a pack: its points ascending, as the whole numbers them, and its cells in runs of 16 with a box each.
struct SamplePart
{
	std::vector<std::uint32_t> points, cells;
	std::vector<std::int32_t> ids, ends = {0};
	std::vector<double> boxes;
	std::vector<std::uint32_t> ids_of_run;
};

SamplePart samplePart(const std::vector<std::array<int, 8>>& cells, const std::vector<Vec3>& places,
                      std::uint32_t first, std::uint32_t end)
{
	SamplePart part;
	std::set<int> used;
	for (std::uint32_t c = first; c < end; ++c)
		used.insert(cells[c].begin(), cells[c].end());
	part.points.assign(used.begin(), used.end());
	vp::Box box;
	for (std::uint32_t c = first; c < end; ++c)
	{
		part.cells.push_back(c);
		for (const int corner : cells[c])
		{
			part.ids.push_back(static_cast<std::int32_t>(std::distance(used.begin(), used.find(corner))));
			box.include(places[static_cast<std::size_t>(corner)]);
		}
		part.ends.push_back(static_cast<std::int32_t>(part.ids.size()));
		if (part.cells.size() % 16 != 0 && c + 1 < end)
			continue;
		for (const Vec3& corner : {box.lo, box.hi})
			part.boxes.insert(part.boxes.end(), {corner.x, corner.y, corner.z});
		part.ids_of_run.push_back(static_cast<std::uint32_t>(8 * ((part.cells.size() - 1) % 16 + 1)));
		box = {};
	}
	return part;
}

// A pack of two parts, after docs/FORMATS.md.
void writePack(const std::string& path)
{
	std::vector<Vec3> places;
	std::vector<std::array<int, 8>> cells;
	std::vector<double> middles;
	eachSamplePoint([&](const Vec3& at, int) { places.push_back(at); });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int)
	    {
		    cells.push_back(corners);
		    middles.push_back(sampleValue(middle));
	    });
	SampleHdf5 file(path);
	SamplePart all;
	std::vector<std::int64_t> point_counts, cell_counts, id_counts;
	all.ends.clear();
	const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
	for (const auto& [first, end] : {std::pair(0u, 24u), std::pair(24u, 60u)})
	{
		const SamplePart part = samplePart(cells, places, first, end);
		point_counts.push_back(static_cast<std::int64_t>(part.points.size()));
		cell_counts.push_back(static_cast<std::int64_t>(part.cells.size()));
		id_counts.push_back(static_cast<std::int64_t>(part.ids.size()));
		append(all.points, part.points);
		append(all.cells, part.cells);
		append(all.ids, part.ids);
		append(all.ends, part.ends);
		append(all.boxes, part.boxes);
		append(all.ids_of_run, part.ids_of_run);
	}
	std::vector<double> xyz, f, g;
	for (const std::uint32_t p : all.points)
	{
		xyz.insert(xyz.end(), {places[p].x, places[p].y, places[p].z});
		f.push_back(sampleValue(places[p]));
	}
	for (const std::uint32_t c : all.cells)
		g.push_back(middles[c]);
	const auto list = [&](const std::string& name, hid_t type, const auto& numbers)
	{ file.set(name, {numbers.size()}, type, numbers.data()); };
	list("/VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, point_counts);
	list("/VTKHDF/NumberOfCells", H5T_NATIVE_INT64, cell_counts);
	list("/VTKHDF/NumberOfConnectivityIds", H5T_NATIVE_INT64, id_counts);
	list("/VTKHDF/Connectivity", H5T_NATIVE_INT32, all.ids);
	list("/VTKHDF/Offsets", H5T_NATIVE_INT32, all.ends);
	list("/VTKHDF/Types", H5T_NATIVE_UINT8, std::vector<std::uint8_t>(all.cells.size(), 12));
	file.set("/VTKHDF/Points", {all.points.size(), 3}, H5T_NATIVE_DOUBLE, xyz.data());
	list("/VTKHDF/PointData/f", H5T_NATIVE_DOUBLE, f);
	list("/VTKHDF/CellData/g", H5T_NATIVE_DOUBLE, g);
	file.attribute("/VTKHDF", "Version", std::vector<double>{1.0, 0.0});
	file.attribute("/VTKHDF", "Type", "UnstructuredGrid");
	list("/vprobe/PointNumbers", H5T_NATIVE_UINT32, all.points);
	list("/vprobe/CellNumbers", H5T_NATIVE_UINT32, all.cells);
	list("/vprobe/NumberOfConnectivityIds", H5T_NATIVE_UINT32, all.ids_of_run);
	file.set("/vprobe/Boxes", {all.boxes.size() / 6, 6}, H5T_NATIVE_DOUBLE, all.boxes.data());
	for (const auto& [name, values] :
	     {std::pair("/vprobe/PointData/f/Spans", &f), std::pair("/vprobe/CellData/g/Spans", &g)})
	{
		const auto [lo, hi] = std::ranges::minmax(*values);
		const double longest = std::max(std::abs(lo), std::abs(hi)), shortest = std::min(std::abs(lo), std::abs(hi));
		const std::vector<double> spans = {lo, hi, 0.0, 0.0, shortest, longest, 0.0, 0.0};
		file.set(name, {2, 4}, H5T_NATIVE_DOUBLE, spans.data());
	}
	file.attribute("/vprobe", "NumberOfPoints", std::vector<double>{kSamplePointCount});
	file.attribute("/vprobe", "NumberOfCells", std::vector<double>{kSampleCellCount});
	file.attribute("/vprobe", "CellsOfRun", std::vector<double>{16});
	for (const char* none : {"FlatCells", "HiddenCells", "CellsWithoutPlace"})
		file.attribute("/vprobe", none, std::vector<double>{0});
}

// Returns the stored words of each plane of constant z: 0 to 65535 from its least to its greatest value.
std::vector<std::uint16_t> mincWords(std::vector<double>& least, std::vector<double>& greatest)
{
	std::vector<std::uint16_t> words;
	for (int k = 0; k < kSamplePoints[2]; ++k)
	{
		least.push_back(sampleValue(Vec3(0, 0, k)));
		greatest.push_back(sampleValue(Vec3(kSamplePoints[0] - 1, kSamplePoints[1] - 1, k)));
	}
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    const auto k = static_cast<std::size_t>(at.z);
		    words.push_back(static_cast<std::uint16_t>(
		        std::lround((sampleValue(at) - least[k]) / (greatest[k] - least[k]) * 65535.0)));
	    });
	return words;
}

void writeMinc2(const std::string& path)
{
	SampleHdf5 file(path);
	std::vector<double> least, greatest;
	const std::vector<std::uint16_t> words = mincWords(least, greatest);
	const std::string image = "/minc-2.0/image/0/image";
	file.set(image, {6, 4, 5}, H5T_NATIVE_UINT16, words.data());
	file.set(image + "-min", {6}, H5T_NATIVE_DOUBLE, least.data());
	file.set(image + "-max", {6}, H5T_NATIVE_DOUBLE, greatest.data());
	file.attribute(image, "dimorder", "zspace,yspace,xspace");
	file.attribute(image, "valid_range", std::vector<double>{0.0, 65535.0});
	for (const std::string name : {"xspace", "yspace", "zspace"})
	{
		file.group("/minc-2.0/dimensions/" + name);
		file.attribute("/minc-2.0/dimensions/" + name, "step", std::vector<double>{1.0});
		file.attribute("/minc-2.0/dimensions/" + name, "units", "mm");
	}
}

// Version 1, whose x goes down along the first axis.
void writeMinc1(const std::string& path)
{
	int file = 0;
	nc_create(path.c_str(), NC_CLOBBER, &file);
	std::array<int, 3> dimensions = {}, axes = {};
	const std::array<const char*, 3> names = {"zspace", "yspace", "xspace"};
	for (std::size_t d = 0; d < 3; ++d)
	{
		nc_def_dim(file, names[d], static_cast<std::size_t>(kSamplePoints[2 - d]), &dimensions[d]);
		nc_def_var(file, names[d], NC_INT, 0, nullptr, &axes[d]);
		const double step = d == 2 ? -1.0 : 1.0, start = d == 2 ? 4.0 : 0.0;
		nc_put_att_double(file, axes[d], "step", NC_DOUBLE, 1, &step);
		nc_put_att_double(file, axes[d], "start", NC_DOUBLE, 1, &start);
	}
	int image = 0, least_id = 0, greatest_id = 0;
	nc_def_var(file, "image", NC_SHORT, 3, dimensions.data(), &image);
	nc_def_var(file, "image-min", NC_DOUBLE, 1, dimensions.data(), &least_id);
	nc_def_var(file, "image-max", NC_DOUBLE, 1, dimensions.data(), &greatest_id);
	const std::array<double, 2> valid = {0.0, 65535.0};
	nc_put_att_double(file, image, "valid_range", NC_DOUBLE, 2, valid.data());
	nc_put_att_text(file, image, "signtype", 8, "unsigned");
	nc_enddef(file);
	std::vector<double> least, greatest;
	std::vector<std::uint16_t> words = mincWords(least, greatest);
	for (std::size_t row = 0; row < words.size(); row += 5)
		std::reverse(words.begin() + static_cast<std::ptrdiff_t>(row),
		             words.begin() + static_cast<std::ptrdiff_t>(row) + 5);
	nc_put_var_short(file, image, reinterpret_cast<const short*>(words.data()));
	nc_put_var_double(file, least_id, least.data());
	nc_put_var_double(file, greatest_id, greatest.data());
	nc_close(file);
}

// Columns whose levels go down, at two times, and beside them the quads between the columns.
void writeCam(const std::string& path)
{
	int file = 0, time = 0, columns = 0, levels = 0, values = 0;
	nc_create(path.c_str(), NC_CLOBBER, &file);
	nc_def_dim(file, "time", 2, &time);
	nc_def_dim(file, "lev", 6, &levels);
	nc_def_dim(file, "ncol", 20, &columns);
	std::array<int, 4> axes = {};
	nc_def_var(file, "time", NC_DOUBLE, 1, &time, &axes[0]);
	nc_def_var(file, "lev", NC_DOUBLE, 1, &levels, &axes[1]);
	nc_def_var(file, "lon", NC_DOUBLE, 1, &columns, &axes[2]);
	nc_def_var(file, "lat", NC_DOUBLE, 1, &columns, &axes[3]);
	const std::array<int, 3> dimensions = {time, levels, columns};
	nc_def_var(file, "f", NC_FLOAT, 3, dimensions.data(), &values);
	nc_enddef(file);
	std::vector<double> times = {0.0, 0.5}, pressures, east, north;
	std::vector<float> f(120, 0.0f);
	for (int level = 0; level < 6; ++level)
	{
		pressures.push_back(100.0 * level);
		for (int column = 0; column < 20; ++column)
			f.push_back(static_cast<float>(sampleValue(Vec3(column % 5, column / 5, 5 - level))));
	}
	for (int column = 0; column < 20; ++column)
		east.push_back(column % 5), north.push_back(column / 5);
	nc_put_var_double(file, axes[0], times.data());
	nc_put_var_double(file, axes[1], pressures.data());
	nc_put_var_double(file, axes[2], east.data());
	nc_put_var_double(file, axes[3], north.data());
	nc_put_var_float(file, values, f.data());
	nc_close(file);

	std::vector<int> corners;
	for (const int corner : {0, 5, 6, 1})
		for (int quad = 0; quad < 12; ++quad)
			corners.push_back(quad % 4 + 5 * (quad / 4) + corner + 1);
	nc_create((std::filesystem::path(path).parent_path() / "quads.nc").c_str(), NC_CLOBBER, &file);
	nc_def_dim(file, "ncorners", 4, &axes[0]);
	nc_def_dim(file, "ncells", 12, &axes[1]);
	nc_def_var(file, "element_corners", NC_INT, 2, axes.data(), &values);
	nc_enddef(file);
	nc_put_var_int(file, values, corners.data());
	nc_close(file);
}

// Quads on a plane and five layers below them, at two times.
void writeMpas(const std::string& path)
{
	int file = 0;
	nc_create(path.c_str(), NC_CLOBBER, &file);
	std::array<int, 5> sides = {};
	const std::array<std::pair<const char*, std::size_t>, 5> dimensions = {
	    {{"Time", 2}, {"nCells", 12}, {"nVertLevels", 5}, {"nVertices", 20}, {"maxEdges", 4}}};
	for (std::size_t d = 0; d < 5; ++d)
		nc_def_dim(file, dimensions[d].first, dimensions[d].second, &sides[d]);
	std::array<int, 3> axes = {};
	int edges = 0, lists = 0, g = 0;
	for (std::size_t axis = 0; axis < 3; ++axis)
		nc_def_var(file, (std::string(1, "xyz"[axis]) + "Vertex").c_str(), NC_DOUBLE, 1, &sides[3], &axes[axis]);
	nc_def_var(file, "nEdgesOnCell", NC_INT, 1, &sides[1], &edges);
	const std::array<int, 2> of_lists = {sides[1], sides[4]};
	nc_def_var(file, "verticesOnCell", NC_INT, 2, of_lists.data(), &lists);
	nc_def_var(file, "g", NC_DOUBLE, 3, sides.data(), &g);
	nc_put_att_text(file, NC_GLOBAL, "on_a_sphere", 3, "NO ");
	nc_enddef(file);
	std::array<std::vector<double>, 3> places;
	for (int vertex = 0; vertex < 20; ++vertex)
	{
		places[0].push_back(vertex % 5);
		places[1].push_back(vertex / 5);
		places[2].push_back(0.0);
	}
	for (std::size_t axis = 0; axis < 3; ++axis)
		nc_put_var_double(file, axes[axis], places[axis].data());
	std::vector<int> counts(12, 4), corners;
	std::vector<double> values(60, 0.0);
	for (int cell = 0; cell < 12; ++cell)
	{
		for (const int corner : {0, 1, 6, 5})
			corners.push_back(cell % 4 + 5 * (cell / 4) + corner + 1);
		for (int layer = 0; layer < 5; ++layer)
			values.push_back(sampleValue(Vec3(cell % 4 + 0.5, cell / 4 + 0.5, -10000.0 * (layer + 0.5))));
	}
	nc_put_var_int(file, edges, counts.data());
	nc_put_var_int(file, lists, corners.data());
	nc_put_var_double(file, g, values.data());
	nc_close(file);
}

// An image in chunks, which may stay in the file.
void writeVtkHdfImage(const std::string& path)
{
	SampleHdf5 file(path);
	file.group("/VTKHDF");
	file.attribute("/VTKHDF", "Version", std::vector<double>{1.0, 0.0});
	file.attribute("/VTKHDF", "Type", "ImageData");
	file.attribute("/VTKHDF", "WholeExtent", std::vector<double>{0.0, 4.0, 0.0, 3.0, 0.0, 5.0});
	file.attribute("/VTKHDF", "Origin", std::vector<double>(3, 0.0));
	file.attribute("/VTKHDF", "Spacing", std::vector<double>(3, 1.0));
	std::vector<double> values;
	eachSamplePoint([&](const Vec3& at, int) { values.push_back(sampleValue(at)); });
	file.set("/VTKHDF/PointData/f", {6, 4, 5}, H5T_NATIVE_DOUBLE, values.data(), {2, 2, 3});
}

// A folder for each array, with a file for each half of the values.
void writeZarr(const std::string& path)
{
	const auto writeArray =
	    [&](const std::string& name, const std::string& sides, const std::string& chunks, const std::string& dimensions)
	{
		std::filesystem::create_directories(path + "/" + name);
		writeContents(path + "/" + name + "/.zarray",
		              fmt::format("{{\"zarr_format\": 2, \"shape\": [{}], \"chunks\": [{}], \"dtype\": \"<f8\", "
		                          "\"compressor\": null, \"fill_value\": 0.0, \"order\": \"C\", \"filters\": null}}",
		                          sides, chunks));
		writeContents(path + "/" + name + "/.zattrs", fmt::format("{{\"_ARRAY_DIMENSIONS\": [{}]}}", dimensions));
	};
	writeArray("f", "6, 4, 5", "3, 4, 5", "\"z\", \"y\", \"x\"");
	writeContents(path + "/.zgroup", "{\"zarr_format\": 2}");
	writeContents(path + "/.zattrs", "{\"Conventions\": \"CF-1.8\"}");
	for (int axis = 0; axis < 3; ++axis)
	{
		const std::string name(1, "xyz"[axis]);
		const std::string count = std::to_string(kSamplePoints[static_cast<std::size_t>(axis)]);
		writeArray(name, count, count, "\"" + name + "\"");
		std::string places;
		for (int i = 0; i < kSamplePoints[static_cast<std::size_t>(axis)]; ++i)
			addBytes(places, static_cast<double>(i));
		writeContents(path + "/" + name + "/0", places);
	}
	std::array<std::string, 2> halves;
	eachSamplePoint([&](const Vec3& at, int) { addBytes(halves[at.z < 3.0 ? 0 : 1], sampleValue(at)); });
	writeContents(path + "/f/0.0.0", halves[0]);
	writeContents(path + "/f/1.0.0", halves[1]);
}

// Version 3 of Zarr, 0.5 of OME-Zarr: two chunks in a shard.
void writeOmeZarr(const std::string& path)
{
	std::filesystem::create_directories(path + "/0/c/0/0");
	const auto axis = [](char name) { return fmt::format(R"({{"name": "{}", "type": "space"}})", name); };
	writeContents(path + "/zarr.json",
	              fmt::format(R"({{"zarr_format": 3, "node_type": "group", "attributes": {{"ome": {{"version": "0.5",
"multiscales": [{{"axes": [{}, {}, {}], "datasets": [{{"path": "0", "coordinateTransformations":
[{{"type": "scale", "scale": [1, 1, 1]}}]}}]}}], "omero": {{"channels": [{{"label": "f"}}]}}}}}}}})",
	                          axis('z'), axis('y'), axis('x')));
	writeContents(path + "/0/zarr.json", R"({"zarr_format": 3, "node_type": "array", "shape": [6, 4, 5],
"data_type": "float64", "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [6, 4, 5]}},
"chunk_key_encoding": {"name": "default"}, "fill_value": 0, "codecs": [{"name": "sharding_indexed", "configuration":
{"chunk_shape": [3, 4, 5], "codecs": [{"name": "bytes", "configuration": {"endian": "little"}}],
"index_codecs": [{"name": "bytes", "configuration": {"endian": "little"}}]}}]})");
	std::string shard;
	eachSamplePoint([&](const Vec3& at, int) { addBytes(shard, sampleValue(at)); });
	const std::uint64_t half = shard.size() / 2;
	for (const std::uint64_t number : {std::uint64_t(0), half, half, half}) // offset and size of each chunk
		addBytes(shard, number);
	writeContents(path + "/0/c/0/0/0", shard);
}

// N5: two blocks, each behind its head, all numbers with their first byte highest, and the fastest side first.
void writeN5(const std::string& path)
{
	std::filesystem::create_directories(path + "/0/0");
	writeContents(path + "/attributes.json", R"({"n5": "2.5.1", "dimensions": [5, 4, 6], "blockSize": [5, 4, 3],
"dataType": "float64", "compression": {"type": "raw"}})");
	const auto addTurned = [](std::string& to, auto number)
	{
		std::string bytes;
		addBytes(bytes, number);
		to.append(bytes.rbegin(), bytes.rend());
	};
	std::array<std::string, 2> blocks;
	for (std::string& block : blocks)
	{
		addTurned(block, std::uint16_t(0));
		addTurned(block, std::uint16_t(3));
		for (const std::uint32_t side : {5u, 4u, 3u})
			addTurned(block, side);
	}
	eachSamplePoint([&](const Vec3& at, int) { addTurned(blocks[at.z < 3.0 ? 0 : 1], sampleValue(at)); });
	writeContents(path + "/0/0/0", blocks[0]);
	writeContents(path + "/0/0/1", blocks[1]);
}

} // namespace

std::vector<SampleFile> containerSamples()
{
	return {
	    {"fields.med", writeMed, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"steps.vtkhdf", writeVtkHdf, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"packed.vtkhdf", writePack, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"chunks.vtkhdf", writeVtkHdfImage, "image", kSampleCellCount, kSamplePointCount, false, ""},
	    {"two.mnc", writeMinc2, "image", kSampleCellCount, kSamplePointCount, false, ""},
	    {"one.mnc", writeMinc1, "image", kSampleCellCount, kSamplePointCount, false, ""},
	    {"columns.nc", writeCam, "unstructured", kSampleCellCount, kSamplePointCount, false, ""},
	    {"prisms.nc", writeMpas, "unstructured", kSampleCellCount, kSamplePointCount, true, "", false},
	    {"group.zarr", writeZarr, "image", kSampleCellCount, kSamplePointCount, false, "group.zarr/f/1.0.0"},
	    {"levels.zarr", writeOmeZarr, "image", kSampleCellCount, kSamplePointCount, false, "levels.zarr/0/c/0/0/0"},
	    {"blocks.n5", writeN5, "image", kSampleCellCount, kSamplePointCount, false, "blocks.n5/0/0/1"},
	};
}
