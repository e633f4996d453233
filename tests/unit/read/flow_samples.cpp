#include "box_faces.h"
#include "own_samples.h"
#include "sample_bytes.h"
#include "sample_hdf5.h"

#include <fmt/format.h>

#include <netcdf.h>
#include <zlib.h>

namespace
{

using vp::Vec3;

std::vector<double> placesOfBox()
{
	std::vector<double> places;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    places.push_back(at[axis]);
	    });
	return places;
}

std::vector<double> valuesOfCells()
{
	std::vector<double> values;
	eachSampleCell([&](const Vec3& middle, const std::array<int, 8>&, int) { values.push_back(sampleValue(middle)); });
	return values;
}

// Polygons seen counterclockwise from outside of their first cell.
void writeConverge(const std::string& path)
{
	SampleHdf5 file(path);
	const std::vector<double> places = placesOfBox(), values = valuesOfCells();
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		std::vector<float> along;
		for (std::size_t p = axis; p < places.size(); p += 3)
			along.push_back(static_cast<float>(places[p]));
		file.set(
		    std::string("/STREAM_00/VERTEX_COORDINATES/") + "XYZ" [axis], { along.size() }, H5T_NATIVE_FLOAT,
		    along.data());
	}
	std::vector<int> starts = {0}, corners, cells;
	for (const BoxFace& face : facesOfBox())
	{
		corners.insert(corners.end(), face.corners.rbegin(), face.corners.rend());
		starts.push_back(static_cast<int>(corners.size()));
		cells.push_back(face.cells[0]);
		cells.push_back(face.cells[1] < 0 ? -3 : face.cells[1]);
	}
	const std::string connectivity = "/STREAM_00/CONNECTIVITY/";
	file.set(connectivity + "POLYGON_OFFSET", {starts.size()}, H5T_NATIVE_INT, starts.data());
	file.set(connectivity + "POLYGON_TO_VERTEX", {corners.size()}, H5T_NATIVE_INT, corners.data());
	file.set(connectivity + "CONNECTED_CELLS", {cells.size()}, H5T_NATIVE_INT, cells.data());
	file.set("/STREAM_00/CELL_CENTER_DATA/g", {values.size()}, H5T_NATIVE_DOUBLE, values.data());
	file.group("/BOUNDARIES");
	file.attribute("/", "OUTPUT_TIME", std::vector<double>{0.75});
}

void setFluentRange(SampleHdf5& file, const std::string& object, double first, double last)
{
	file.attribute(object, "minId", std::vector<double>{first});
	file.attribute(object, "maxId", std::vector<double>{last});
}

// One zone of cells; faces in one list, those inside first, as they alone have a cell on both sides.
void writeFluentHdf5(const std::string& path)
{
	const std::vector<double> places = placesOfBox(), values = valuesOfCells();
	{
		SampleHdf5 file(path);
		const std::string mesh = "/meshes/1";
		const std::vector<BoxFace> faces = facesOfBox();
		std::vector<int> corners, first, second;
		const std::vector<std::int16_t> counts(faces.size(), 4);
		for (const BoxFace& face : faces)
		{
			for (const int corner : face.corners)
				corners.push_back(corner + 1);
			first.push_back(face.cells[0] + 1);
			if (face.cells[1] >= 0)
				second.push_back(face.cells[1] + 1);
		}
		const auto all = static_cast<double>(faces.size());
		file.set(mesh + "/nodes/coords/1", {kSamplePointCount, 3}, H5T_NATIVE_DOUBLE, places.data());
		setFluentRange(file, mesh + "/nodes/coords/1", 1, kSamplePointCount);
		file.set(mesh + "/faces/nodes/1/nnodes", {counts.size()}, H5T_NATIVE_INT16, counts.data());
		file.set(mesh + "/faces/nodes/1/nodes", {corners.size()}, H5T_NATIVE_INT, corners.data());
		setFluentRange(file, mesh + "/faces/nodes/1", 1, all);
		file.set(mesh + "/faces/c0/1", {first.size()}, H5T_NATIVE_INT, first.data());
		setFluentRange(file, mesh + "/faces/c0/1", 1, all);
		file.set(mesh + "/faces/c1/1", {second.size()}, H5T_NATIVE_INT, second.data());
		setFluentRange(file, mesh + "/faces/c1/1", 1, static_cast<double>(second.size()));
		const std::array<std::pair<const char*, int>, 3> zone = {{{"id", 7}, {"minId", 1}, {"maxId", 60}}};
		for (const auto& [name, number] : zone)
			file.set(mesh + "/cells/zoneTopology/" + name, {1}, H5T_NATIVE_INT, &number);
		file.texts(mesh + "/cells/zoneTopology/name", {1}, 5, {"fluid"});
		file.attribute(mesh, "nodeCount", std::vector<double>{kSamplePointCount});
		file.attribute(mesh, "cellCount", std::vector<double>{kSampleCellCount});
		file.attribute(mesh, "faceCount", std::vector<double>{all});
		file.attribute(mesh, "dimension", std::vector<double>{3});
		file.group("/settings");
	}
	std::string data = path;
	SampleHdf5 file(data.replace(data.rfind(".cas."), 5, ".dat."));
	const std::string cells = "/results/1/phase-1/cells";
	file.texts(cells + "/fields", {1}, 4, {"SV_T"});
	file.set(cells + "/SV_T/1", {values.size()}, H5T_NATIVE_DOUBLE, values.data());
	setFluentRange(file, cells + "/SV_T/1", 1, kSampleCellCount);
}

// Packs the text of another sample.
void writeFluentGzip(const std::string& path)
{
	const TemporaryFolder folder;
	for (const SampleFile& sample : codeSamples())
		if (sample.name == "ascii_fluent.cas")
			sample.write(folder / sample.name);
	for (const char* ending : {".cas", ".dat"})
	{
		const std::string bytes = contentsOf(folder / ("ascii_fluent" + std::string(ending)));
		std::string packed = path;
		packed.replace(packed.rfind(".cas"), 4, ending);
		const gzFile file = gzopen(packed.c_str(), "wb");
		gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
		gzclose(file);
	}
}

// Six tetrahedra for each of the box's cells, of which the last four have faces on a boundary, and modes.
void writeSlac(const std::string& path)
{
	constexpr std::array<std::array<std::size_t, 4>, 6> kTetrahedra = {
	    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
	std::vector<int> inside, outside;
	eachSampleCell(
	    [&](const Vec3&, const std::array<int, 8>& corners, int cell)
	    {
		    for (const auto& tetrahedron : kTetrahedra)
		    {
			    std::vector<int>& list = cell < 56 ? inside : outside;
			    list.push_back(1);
			    for (const std::size_t corner : tetrahedron)
				    list.push_back(corners[corner]);
			    if (cell >= 56)
				    list.insert(list.end(), {-1, 4, -1, -1});
		    }
	    });
	const auto make = [](const std::string& name, const auto& define, const auto& put)
	{
		int file = 0, points = 0, three = 0, coordinates = 0;
		nc_create(name.c_str(), NC_CLOBBER, &file);
		nc_def_dim(file, "ncoord", kSamplePointCount, &points);
		nc_def_dim(file, "three", 3, &three);
		const std::array<int, 2> sides = {points, three};
		nc_def_var(file, "coords", NC_DOUBLE, 2, sides.data(), &coordinates);
		define(file, points);
		nc_enddef(file);
		nc_put_var_double(file, coordinates, placesOfBox().data());
		put(file);
		nc_close(file);
	};
	std::array<int, 2> lists = {};
	make(
	    path,
	    [&](int file, int)
	    {
		    std::array<int, 2> sides = {};
		    nc_def_dim(file, "ntetint", inside.size() / 5, &sides[0]);
		    nc_def_dim(file, "ntetintsize", 5, &sides[1]);
		    nc_def_var(file, "tetrahedron_interior", NC_INT, 2, sides.data(), &lists[0]);
		    nc_def_dim(file, "ntetext", outside.size() / 9, &sides[0]);
		    nc_def_dim(file, "ntetextsize", 9, &sides[1]);
		    nc_def_var(file, "tetrahedron_exterior", NC_INT, 2, sides.data(), &lists[1]);
	    },
	    [&](int file)
	    {
		    nc_put_var_int(file, lists[0], inside.data());
		    nc_put_var_int(file, lists[1], outside.data());
	    });
	int frequency = 0, f = 0;
	make((std::filesystem::path(path).parent_path() / "field.mod").string(),
	     [&](int file, int points)
	     {
		     nc_def_var(file, "frequency", NC_DOUBLE, 0, nullptr, &frequency);
		     nc_def_var(file, "f", NC_DOUBLE, 1, &points, &f);
	     },
	     [&](int file)
	     {
		     const double hertz = 1.3e9;
		     nc_put_var_double(file, frequency, &hertz);
		     std::vector<double> values;
		     eachSamplePoint([&](const Vec3& at, int) { values.push_back(sampleValue(at)); });
		     nc_put_var_double(file, f, values.data());
	     });
}

// Records of 512 bytes in the order of MFIX's write_res0.f, of version 1.6, with one phase of solids.
class MfixSample
{
public:
	void skip(int records) { bytes_.append(512 * static_cast<std::size_t>(records), '\0'); }
	void text(std::size_t place, const std::string& words) { current_.replace(place, words.size(), words); }
	template <class Number>
	void number(std::size_t place, Number value)
	{
		std::string big;
		addBigEndian(big, value);
		current_.replace(place, big.size(), big);
	}
	void end()
	{
		bytes_ += current_;
		current_.assign(512, '\0');
	}
	template <class Number>
	void numbers(const std::vector<Number>& values)
	{
		for (const Number value : values)
			addBigEndian(bytes_, value);
		bytes_.resize((bytes_.size() + 511) / 512 * 512);
	}
	const std::string& bytes() const { return bytes_; }

private:
	std::string bytes_;
	std::string current_ = std::string(512, '\0');
};

constexpr std::array<int, 3> kMfixCells = {6, 5, 7}; // with the ghosts

template <class Use>
void eachMfixSampleCell(Use&& use)
{
	for (int k = 0; k < kMfixCells[2]; ++k)
		for (int j = 0; j < kMfixCells[1]; ++j)
			for (int i = 0; i < kMfixCells[0]; ++i)
				use(Vec3(i, j, k) - 0.5, i == 0 || j == 0 || k == 0 || i == 5 || j == 4 || k == 6);
}

void writeMfix(const std::string& path)
{
	MfixSample file;
	file.text(0, "RES = 01.6");
	file.end();
	file.skip(2);
	for (std::size_t axis = 0; axis < 3; ++axis)
		file.number(36 + 4 * axis, kMfixCells[axis]);
	file.number(56, 1); // phases
	for (std::size_t i = 0; i < 4; ++i)
		file.number(60 + 4 * i, 2); // conditions of four kinds
	file.end();
	file.skip(1 + 2); // constants
	file.numbers(std::vector<std::int32_t>{1, 1});
	for (const int count : kMfixCells)
		file.numbers(std::vector<double>(static_cast<std::size_t>(count), 1.0));
	file.text(120, "SI              ");
	file.text(152, "CARTESIAN       ");
	file.end();
	file.skip(2 + 1);
	file.skip(12 + 3 + 1 + 3 + 5 + 1);     // initial conditions
	file.skip(12 + 3 + 1 + 7 + 7 + 1 + 2); // boundary conditions
	std::vector<std::int32_t> flags;
	eachMfixSampleCell([&](const Vec3&, bool is_ghost) { flags.push_back(is_ghost ? 100 : 1); });
	file.numbers(flags);
	file.skip(12 + 2 + 1 + 2); // inner surfaces
	file.skip(2);
	file.number(0, 11); // files of values
	file.end();
	file.skip(11 + 2 + 7 + 5 + 2 + 2 + 6);
	file.skip(4 + 8 + 3 + 4 + 1);
	file.end(); // no scalars
	file.end(); // no reactions
	file.end(); // no turbulence
	writeContents(path, file.bytes());

	MfixSample values;
	values.text(0, "SP1 = 01.00");
	values.end();
	values.skip(1);
	const int of_time = 1 + 2;
	values.number(0, 4 + 2 * of_time);
	values.number(4, of_time);
	values.end();
	for (const float time : {0.0f, 1.5f})
	{
		values.number(0, time);
		values.end();
		std::vector<float> all;
		eachMfixSampleCell([&](const Vec3& middle, bool)
		                   { all.push_back(time > 0.0f ? static_cast<float>(sampleValue(middle)) : 0.0f); });
		values.numbers(all);
	}
	writeContents(std::filesystem::path(path).replace_extension(".SP1").string(), values.bytes());
}

} // namespace

std::vector<SampleFile> flowSamples()
{
	return {
	    {"post000001.h5", writeConverge, "unstructured", kSampleCellCount, kSamplePointCount, true, "", false},
	    {"hdf5.cas.h5", writeFluentHdf5, "unstructured", kSampleCellCount, kSamplePointCount, true, "", false},
	    {"hdf5_data.cas.h5", writeFluentHdf5, "unstructured", kSampleCellCount, kSamplePointCount, true,
	     "hdf5_data.dat.h5", false},
	    {"packed.cas.gz", writeFluentGzip, "unstructured", kSampleCellCount, kSamplePointCount, true, "", false},
	    {"cavity.ncdf", writeSlac, "unstructured", 6 * kSampleCellCount, kSamplePointCount, false, ""},
	    {"bed.RES", writeMfix, "rectilinear", kSampleCellCount, kSamplePointCount, true, "", false},
	    {"bed_values.RES", writeMfix, "rectilinear", kSampleCellCount, kSamplePointCount, true, "bed_values.SP1",
	     false},
	};
}
