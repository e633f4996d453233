#include "own_samples.h"

#include "sample_bytes.h"

#include <fmt/format.h>

#include <netcdf.h>
#include <zlib.h>

namespace
{

using vp::Vec3;

// The tags of nodes are not in a row, as after a mesh was edited.
int nodeTag(int point)
{
	return 10 + 3 * point;
}

std::string gmshData(const char* section, const char* name, std::size_t count, const std::string& values)
{
	return fmt::format("${0}\n1\n\"{1}\"\n1\n0.0\n3\n0\n1\n{2}\n{3}$End{0}\n", section, name, count, values);
}

void writeGmsh2(const std::string& path)
{
	std::string nodes, elements, f, g;
	eachSamplePoint(
	    [&](const Vec3& at, int p)
	    {
		    nodes += fmt::format("{} {} {} {}\n", nodeTag(p), at.x, at.y, at.z);
		    f += fmt::format("{} {}\n", nodeTag(p), sampleValue(at));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int c)
	    {
		    elements += fmt::format("{} 5 2 7 1", c + 1);
		    for (const int corner : corners)
			    elements += fmt::format(" {}", nodeTag(corner));
		    elements += "\n";
		    g += fmt::format("{} {}\n", c + 1, sampleValue(middle));
	    });
	writeContents(path, fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"all\"\n"
	                                "$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
	                                kSamplePointCount, nodes, kSampleCellCount, elements) +
	                        gmshData("NodeData", "f", kSamplePointCount, f) +
	                        gmshData("ElementData", "g", kSampleCellCount, g));
}

void writeGmsh4(const std::string& path)
{
	std::string tags, places, elements, f, g;
	eachSamplePoint(
	    [&](const Vec3& at, int p)
	    {
		    addBytes<std::int64_t>(tags, nodeTag(p));
		    for (int axis = 0; axis < 3; ++axis)
			    addBytes<double>(places, at[axis]);
		    addBytes<std::int32_t>(f, nodeTag(p));
		    addBytes<double>(f, sampleValue(at));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int c)
	    {
		    addBytes<std::int64_t>(elements, c + 1);
		    for (const int corner : corners)
			    addBytes<std::int64_t>(elements, nodeTag(corner));
		    addBytes<std::int32_t>(g, c + 1);
		    addBytes<double>(g, sampleValue(middle));
	    });
	const auto head =
	    [](std::initializer_list<std::int64_t> sizes, std::initializer_list<std::int32_t> block, std::int64_t count)
	{
		std::string bytes;
		for (const std::int64_t size : sizes)
			addBytes(bytes, size);
		for (const std::int32_t number : block)
			addBytes(bytes, number);
		addBytes(bytes, count);
		return bytes;
	};
	std::string one;
	addBytes<std::int32_t>(one, 1);
	const std::int64_t last = nodeTag(static_cast<int>(kSamplePointCount) - 1);
	writeContents(path, "$MeshFormat\n4.1 1 8\n" + one + "\n$EndMeshFormat\n$Nodes\n" +
	                        head({1, kSamplePointCount, nodeTag(0), last}, {3, 1, 0}, kSamplePointCount) + tags +
	                        places + "\n$EndNodes\n$Elements\n" +
	                        head({1, kSampleCellCount, 1, kSampleCellCount}, {3, 1, 5}, kSampleCellCount) + elements +
	                        "\n$EndElements\n" + gmshData("NodeData", "f", kSamplePointCount, f + "\n") +
	                        gmshData("ElementData", "g", kSampleCellCount, g + "\n"));
}

std::string npyBytes()
{
	std::string header = "{'descr': '>f8', 'fortran_order': False, 'shape': (6, 4, 5), }";
	header.resize(117, ' ');
	std::string bytes = "\x93NUMPY";
	bytes += '\1';
	bytes += '\0';
	addBytes<std::uint16_t>(bytes, 118);
	bytes += header + "\n";
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    std::string value;
		    addBytes<double>(value, sampleValue(at));
		    bytes.append(value.rbegin(), value.rend());
	    });
	return bytes;
}

std::string deflated(const std::string& bytes)
{
	z_stream stream = {};
	deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
	std::string packed(deflateBound(&stream, bytes.size()), '\0');
	stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
	stream.avail_in = static_cast<uInt>(bytes.size());
	stream.next_out = reinterpret_cast<Bytef*>(packed.data());
	stream.avail_out = static_cast<uInt>(packed.size());
	deflate(&stream, Z_FINISH);
	packed.resize(stream.total_out);
	deflateEnd(&stream);
	return packed;
}

// An archive of one array, as numpy.savez_compressed writes it.
void writeNpz(const std::string& path)
{
	const std::string array = npyBytes();
	const std::string packed = deflated(array);
	const std::string name = "f.npy";
	// From the version to the length of the extra field, the same in both records.
	std::string about;
	for (const int number : {20, 0, 8, 0, 0})
		addBytes<std::uint16_t>(about, static_cast<std::uint16_t>(number));
	addBytes<std::uint32_t>(
	    about, static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(array.data()), array.size())));
	addBytes<std::uint32_t>(about, static_cast<std::uint32_t>(packed.size()));
	addBytes<std::uint32_t>(about, static_cast<std::uint32_t>(array.size()));
	addBytes<std::uint16_t>(about, static_cast<std::uint16_t>(name.size()));
	addBytes<std::uint16_t>(about, 0);
	const std::string file = "PK\3\4" + about + name + packed;
	std::string list = "PK\1\2";
	addBytes<std::uint16_t>(list, 20);
	list += about;
	list.append(10, '\0'); // comment, disk, attributes
	addBytes<std::uint32_t>(list, 0);
	list += name;
	std::string end = "PK\5\6";
	end.append(4, '\0');
	addBytes<std::uint16_t>(end, 1);
	addBytes<std::uint16_t>(end, 1);
	addBytes<std::uint32_t>(end, static_cast<std::uint32_t>(list.size()));
	addBytes<std::uint32_t>(end, static_cast<std::uint32_t>(file.size()));
	addBytes<std::uint16_t>(end, 0);
	writeContents(path, file + list + end);
}

std::string wordsOf(const std::vector<double>& numbers)
{
	std::string words;
	for (const double number : numbers)
		words += fmt::format("{}\n", number);
	return words;
}

// Hexahedra in blocks, with values at cells.
void writeTecplotBricks(const std::string& path)
{
	std::array<std::vector<double>, 3> places;
	std::vector<double> f, g;
	std::string elements;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    places[static_cast<std::size_t>(axis)].push_back(at[axis]);
		    f.push_back(sampleValue(at));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int)
	    {
		    g.push_back(sampleValue(middle));
		    for (const int corner : corners)
			    elements += fmt::format("{} ", corner + 1);
		    elements += "\n";
	    });
	writeContents(path, "TITLE = \"a box\"\nVARIABLES = \"X [m]\" \"Y [m]\" \"Z [m]\" \"f\", \"g\"\n# a comment\n"
	                    "ZONE T=\"bricks\", DATAPACKING=BLOCK, ZONETYPE=FEBRICK, NODES=120, ELEMENTS=60\n"
	                    "VARLOCATION=([5]=CELLCENTERED) SOLUTIONTIME=2.5 STRANDID=1\n" +
	                        wordsOf(places[0]) + wordsOf(places[1]) + wordsOf(places[2]) + wordsOf(f) + wordsOf(g) +
	                        elements);
}

// A zone of an earlier time, and one that shares its places.
void writeTecplotOrdered(const std::string& path)
{
	std::string early, late;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    early += fmt::format("{:.6E} {} {} 1.0\n", at.x, at.y, at.z);
		    late += fmt::format("{}\n", sampleValue(at));
	    });
	writeContents(path, "variables = x, y, z, f\nzone t=early i=5, j=4, k=6, f=point, solutiontime=0\n" + early +
	                        "zone t=late i=5 j=4 k=6 f=point solutiontime=1.5 varsharelist=([1-3]=1)\n" + late);
}

void writeUcd(const std::string& path)
{
	std::string text = "# a comment\n120 60 1 1 0\n", f = "1 1\nf, K\n", g = "1 1\ng, none\n";
	eachSamplePoint(
	    [&](const Vec3& at, int p)
	    {
		    text += fmt::format("{} {} {} {}\n", nodeTag(p), at.x, at.y, at.z);
		    f += fmt::format("{} {}\n", nodeTag(p), sampleValue(at));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& c, int index)
	    {
		    text += fmt::format("{} 3 hex", index + 1);
		    for (const int corner : {c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]})
			    text += fmt::format(" {}", nodeTag(corner));
		    text += "\n";
		    g += fmt::format("{} {}\n", index + 1, sampleValue(middle));
	    });
	writeContents(path, text + f + g);
}

void writeXdmf(const std::string& path)
{
	std::string places, elements, f, g;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    places += fmt::format("{} {} {}\n", at.x, at.y, at.z);
		    f += fmt::format("{}\n", sampleValue(at));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int)
	    {
		    for (const int corner : corners)
			    elements += fmt::format("{} ", corner);
		    g += fmt::format("{}\n", sampleValue(middle));
	    });
	const auto item = [](const std::string& sides, const char* type, const std::string& values)
	{
		return fmt::format("<DataItem Dimensions=\"{}\" NumberType=\"{}\" Format=\"XML\">\n{}</DataItem>\n", sides,
		                   type, values);
	};
	writeContents(path, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain><Grid Name=\"box\">\n"
	                    "<Topology TopologyType=\"Hexahedron\" NumberOfElements=\"60\">" +
	                        item("60 8", "Int", elements) + "</Topology>\n<Geometry GeometryType=\"XYZ\">" +
	                        item("120 3", "Float", places) +
	                        "</Geometry>\n<Attribute Name=\"f\" AttributeType=\"Scalar\" Center=\"Node\">" +
	                        item("120", "Float", f) +
	                        "</Attribute>\n<Attribute Name=\"g\" AttributeType=\"Scalar\" Center=\"Cell\">" +
	                        item("60", "Float", g) + "</Attribute></Grid></Domain></Xdmf>\n");
}

void writeNetcdf(const std::string& path, int mode)
{
	int file = 0;
	nc_create(path.c_str(), mode, &file);
	std::array<int, 3> dimensions = {};
	std::array<int, 3> axes = {};
	const std::array<const char*, 3> names = {"depth", "north", "east"};
	for (std::size_t d = 0; d < 3; ++d)
	{
		nc_def_dim(file, names[d], static_cast<std::size_t>(kSamplePoints[2 - d]), &dimensions[d]);
		nc_def_var(file, names[d], NC_DOUBLE, 1, &dimensions[d], &axes[d]);
	}
	int f = 0;
	nc_def_var(file, "f", NC_DOUBLE, 3, dimensions.data(), &f);
	nc_put_att_text(file, f, "units", 1, "K");
	nc_put_att_text(file, NC_GLOBAL, "Conventions", 6, "CF-1.8");
	nc_enddef(file);
	for (std::size_t d = 0; d < 3; ++d)
	{
		std::vector<double> places;
		for (int i = 0; i < kSamplePoints[2 - d]; ++i)
			places.push_back(i * i * 0.25);
		nc_put_var_double(file, axes[d], places.data());
	}
	std::vector<double> values;
	eachSamplePoint([&](const Vec3& at, int) { values.push_back(sampleValue(0.25 * at * at)); });
	nc_put_var_double(file, f, values.data());
	nc_close(file);
}

} // namespace

std::vector<SampleFile> ownSamples()
{
	return {
	    {"ascii_bricks.dat", writeTecplotBricks, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"ascii_ordered.tec", writeTecplotOrdered, "curvilinear", kSampleCellCount, kSamplePointCount, false, ""},
	    {"ascii_ucd.inp", writeUcd, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"inline.xmf", writeXdmf, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"classic.nc", [](const std::string& p) { writeNetcdf(p, NC_CLOBBER); }, "rectilinear", kSampleCellCount,
	     kSamplePointCount, false, ""},
	    {"four.nc", [](const std::string& p) { writeNetcdf(p, NC_CLOBBER | NC_NETCDF4); }, "rectilinear",
	     kSampleCellCount, kSamplePointCount, false, ""},
	    {"ascii_2.msh", writeGmsh2, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"binary_4.msh", writeGmsh4, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"f.npy", [](const std::string& path) { writeContents(path, npyBytes()); }, "image", kSampleCellCount,
	     kSamplePointCount, false, ""},
	    {"volume.npz", writeNpz, "image", kSampleCellCount, kSamplePointCount, false, ""},
	};
}
