#include "own_samples.h"

#include <fmt/format.h>

#include <netcdf.h>
#include <zlib.h>

namespace
{

using vp::Vec3;

constexpr std::size_t kPoints = 5 * 4 * 6;
constexpr std::size_t kCells = 4 * 3 * 5;

template <class Number>
void add(std::string& bytes, Number number)
{
	bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// Calls `use` with the place and the index of each point of a box.
template <class Use>
void eachPoint(Use&& use)
{
	int index = 0;
	for (int k = 0; k < kSamplePoints[2]; ++k)
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				use(Vec3(i, j, k), index++);
}

// Calls `use` with the middle, the corners and the index of each hexahedron.
template <class Use>
void eachCell(Use&& use)
{
	int index = 0;
	for (int k = 0; k + 1 < kSamplePoints[2]; ++k)
		for (int j = 0; j + 1 < kSamplePoints[1]; ++j)
			for (int i = 0; i + 1 < kSamplePoints[0]; ++i)
			{
				std::array<int, 8> corners = {0, 1, 6, 5, 20, 21, 26, 25};
				for (int& corner : corners)
					corner += i + 5 * j + 20 * k;
				use(Vec3(i, j, k) + 0.5, corners, index++);
			}
}

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
	eachPoint(
	    [&](const Vec3& at, int p)
	    {
		    nodes += fmt::format("{} {} {} {}\n", nodeTag(p), at.x, at.y, at.z);
		    f += fmt::format("{} {}\n", nodeTag(p), sampleValue(at));
	    });
	eachCell(
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
	                                kPoints, nodes, kCells, elements) +
	                        gmshData("NodeData", "f", kPoints, f) + gmshData("ElementData", "g", kCells, g));
}

void writeGmsh4(const std::string& path)
{
	std::string tags, places, elements, f, g;
	eachPoint(
	    [&](const Vec3& at, int p)
	    {
		    add<std::int64_t>(tags, nodeTag(p));
		    for (int axis = 0; axis < 3; ++axis)
			    add<double>(places, at[axis]);
		    add<std::int32_t>(f, nodeTag(p));
		    add<double>(f, sampleValue(at));
	    });
	eachCell(
	    [&](const Vec3& middle, const std::array<int, 8>& corners, int c)
	    {
		    add<std::int64_t>(elements, c + 1);
		    for (const int corner : corners)
			    add<std::int64_t>(elements, nodeTag(corner));
		    add<std::int32_t>(g, c + 1);
		    add<double>(g, sampleValue(middle));
	    });
	const auto head =
	    [](std::initializer_list<std::int64_t> sizes, std::initializer_list<std::int32_t> block, std::int64_t count)
	{
		std::string bytes;
		for (const std::int64_t size : sizes)
			add(bytes, size);
		for (const std::int32_t number : block)
			add(bytes, number);
		add(bytes, count);
		return bytes;
	};
	std::string one;
	add<std::int32_t>(one, 1);
	const std::int64_t last = nodeTag(static_cast<int>(kPoints) - 1);
	writeContents(path, "$MeshFormat\n4.1 1 8\n" + one + "\n$EndMeshFormat\n$Nodes\n" +
	                        head({1, kPoints, nodeTag(0), last}, {3, 1, 0}, kPoints) + tags + places +
	                        "\n$EndNodes\n$Elements\n" + head({1, kCells, 1, kCells}, {3, 1, 5}, kCells) + elements +
	                        "\n$EndElements\n" + gmshData("NodeData", "f", kPoints, f + "\n") +
	                        gmshData("ElementData", "g", kCells, g + "\n"));
}

std::string npyBytes()
{
	std::string header = "{'descr': '>f8', 'fortran_order': False, 'shape': (6, 4, 5), }";
	header.resize(117, ' ');
	std::string bytes = "\x93NUMPY";
	bytes += '\1';
	bytes += '\0';
	add<std::uint16_t>(bytes, 118);
	bytes += header + "\n";
	eachPoint(
	    [&](const Vec3& at, int)
	    {
		    std::string value;
		    add<double>(value, sampleValue(at));
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
		add<std::uint16_t>(about, static_cast<std::uint16_t>(number));
	add<std::uint32_t>(
	    about, static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(array.data()), array.size())));
	add<std::uint32_t>(about, static_cast<std::uint32_t>(packed.size()));
	add<std::uint32_t>(about, static_cast<std::uint32_t>(array.size()));
	add<std::uint16_t>(about, static_cast<std::uint16_t>(name.size()));
	add<std::uint16_t>(about, 0);
	const std::string file = "PK\3\4" + about + name + packed;
	std::string list = "PK\1\2";
	add<std::uint16_t>(list, 20);
	list += about;
	list.append(10, '\0'); // comment, disk, attributes
	add<std::uint32_t>(list, 0);
	list += name;
	std::string end = "PK\5\6";
	end.append(4, '\0');
	add<std::uint16_t>(end, 1);
	add<std::uint16_t>(end, 1);
	add<std::uint32_t>(end, static_cast<std::uint32_t>(list.size()));
	add<std::uint32_t>(end, static_cast<std::uint32_t>(file.size()));
	add<std::uint16_t>(end, 0);
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
	eachPoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    places[static_cast<std::size_t>(axis)].push_back(at[axis]);
		    f.push_back(sampleValue(at));
	    });
	eachCell(
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
	eachPoint(
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
	eachPoint(
	    [&](const Vec3& at, int p)
	    {
		    text += fmt::format("{} {} {} {}\n", nodeTag(p), at.x, at.y, at.z);
		    f += fmt::format("{} {}\n", nodeTag(p), sampleValue(at));
	    });
	eachCell(
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
	eachPoint(
	    [&](const Vec3& at, int)
	    {
		    places += fmt::format("{} {} {}\n", at.x, at.y, at.z);
		    f += fmt::format("{}\n", sampleValue(at));
	    });
	eachCell(
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

template <class Number>
void addBigEndian(std::string& bytes, Number number)
{
	std::string little;
	add(little, number);
	bytes.append(little.rbegin(), little.rend());
}

// Columns run along y, rows along z, sections along x.
void writeTurnedMrc(const std::string& path)
{
	std::string bytes;
	const auto words = [&](std::initializer_list<int> numbers)
	{
		for (const int number : numbers)
			addBigEndian(bytes, number);
	};
	const auto reals = [&](std::initializer_list<float> numbers)
	{
		for (const float number : numbers)
			addBigEndian(bytes, number);
	};
	words({5, 4, 6, 2, 0, 0, 0, 6, 5, 4});
	reals({3.0f, 1.25f, 8.0f, 90.0f, 90.0f, 90.0f});
	words({2, 3, 1});
	reals({0.0f, 0.0f, 0.0f});
	words({1, 80}); // an extended header of 80 bytes
	bytes.append(100, '\0');
	reals({2.0f, -2.0f, -1.5f});
	bytes += "MAP \x11\x11";
	bytes.resize(1024 + 80, '\0');
	for (int section = 0; section < 6; ++section)
		for (int row = 0; row < 4; ++row)
			for (int column = 0; column < 5; ++column)
				addBigEndian(bytes, static_cast<float>(sampleValue(
				                        Vec3(2.0 + 0.5 * section, -2.0 + 0.25 * column, -1.5 + 2.0 * row))));
	writeContents(path, bytes);
}

// As ImageJ writes stacks, with two times: pages of one strip each.
void writeImageJ(const std::string& path)
{
	const std::string description = std::string("ImageJ=1.53t\nimages=12\nslices=6\nframes=2\nhyperstack=true\n"
	                                            "unit=micron\nfinterval=0.5\nspacing=2.0\nloop=false\n") +
	                                '\0';
	std::string bytes = "II*";
	bytes += '\0';
	add<std::uint32_t>(bytes, 8 + 16);
	for (const std::uint32_t number : {4u, 1u, 4u, 1u}) // four pixels in a micron
		add(bytes, number);
	for (std::uint32_t page = 0; page < 12; ++page)
	{
		const auto at = static_cast<std::uint32_t>(bytes.size());
		constexpr std::uint32_t kTags = 13;
		const std::uint32_t text = at + 2 + 12 * kTags + 4;
		const std::uint32_t values = text + static_cast<std::uint32_t>(description.size());
		const std::uint32_t size = 5 * 4 * sizeof(float);
		const auto entry = [&](std::uint16_t tag, std::uint16_t type, std::uint32_t count, std::uint32_t value)
		{
			add(bytes, tag);
			add(bytes, type);
			add(bytes, count);
			add(bytes, value);
		};
		add<std::uint16_t>(bytes, kTags);
		entry(256, 4, 1, 5);
		entry(257, 4, 1, 4);
		entry(258, 3, 1, 32);
		entry(259, 3, 1, 1);
		entry(262, 3, 1, 1);
		entry(270, 2, static_cast<std::uint32_t>(description.size()), text);
		entry(273, 4, 1, values);
		entry(277, 3, 1, 1);
		entry(278, 4, 1, 4);
		entry(279, 4, 1, size);
		entry(282, 5, 1, 8);
		entry(283, 5, 1, 16);
		entry(339, 3, 1, 3);
		add<std::uint32_t>(bytes, page == 11 ? 0 : values + size);
		bytes += description;
		for (int row = 0; row < 4; ++row)
			for (int column = 0; column < 5; ++column)
				add(bytes, page < 6
				               ? 0.0f
				               : static_cast<float>(sampleValue(Vec3(0.25 * column, 0.25 * row, 2.0 * (page - 6)))));
	}
	writeContents(path, bytes);
}

// An element with an explicit type, filled up to an even length.
void addElement(std::string& bytes, std::uint16_t group, std::uint16_t element, const std::string& type,
                std::string value)
{
	if (value.size() % 2 != 0)
		value += type == "UI" ? '\0' : ' ';
	add(bytes, group);
	add(bytes, element);
	bytes += type;
	if (type == "OW")
	{
		add<std::uint16_t>(bytes, 0);
		add(bytes, static_cast<std::uint32_t>(value.size()));
	}
	else
		add(bytes, static_cast<std::uint16_t>(value.size()));
	bytes += value;
}

std::string shortNumber(std::uint16_t number)
{
	std::string bytes;
	add(bytes, number);
	return bytes;
}

// A series of a file for each slice.
void writeDicom(const std::string& path)
{
	const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
	for (int k = 0; k < kSamplePoints[2]; ++k)
	{
		const std::string instance = fmt::format("1.2.3.4.{}", k + 1);
		std::string meta;
		addElement(meta, 2, 2, "UI", ct);
		addElement(meta, 2, 3, "UI", instance);
		addElement(meta, 2, 0x10, "UI", "1.2.840.10008.1.2.1");
		std::string bytes(128, '\0');
		bytes += "DICM";
		std::string length;
		add(length, static_cast<std::uint32_t>(meta.size()));
		addElement(bytes, 2, 0, "UL", length);
		bytes += meta;
		std::string pixels;
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				add(pixels, static_cast<std::uint16_t>(sampleValue(Vec3(i, j, k))));
		addElement(bytes, 8, 0x16, "UI", ct);
		addElement(bytes, 8, 0x18, "UI", instance);
		addElement(bytes, 8, 0x60, "CS", "CT");
		addElement(bytes, 0x20, 0xd, "UI", "1.2.3.5");
		addElement(bytes, 0x20, 0xe, "UI", "1.2.3.6");
		addElement(bytes, 0x20, 0x13, "IS", fmt::format("{}", k + 1));
		addElement(bytes, 0x20, 0x32, "DS", fmt::format("0\\0\\{}", k));
		addElement(bytes, 0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0");
		addElement(bytes, 0x28, 2, "US", shortNumber(1));
		addElement(bytes, 0x28, 4, "CS", "MONOCHROME2");
		addElement(bytes, 0x28, 0x10, "US", shortNumber(4));
		addElement(bytes, 0x28, 0x11, "US", shortNumber(5));
		addElement(bytes, 0x28, 0x30, "DS", "1\\1");
		addElement(bytes, 0x28, 0x100, "US", shortNumber(16));
		addElement(bytes, 0x28, 0x101, "US", shortNumber(16));
		addElement(bytes, 0x28, 0x102, "US", shortNumber(15));
		addElement(bytes, 0x28, 0x103, "US", shortNumber(0));
		addElement(bytes, 0x7fe0, 0x10, "OW", pixels);
		writeContents((std::filesystem::path(path).parent_path() / fmt::format("slice_{}.dcm", k)).string(), bytes);
	}
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
	eachPoint([&](const Vec3& at, int) { values.push_back(sampleValue(0.25 * at * at)); });
	nc_put_var_double(file, f, values.data());
	nc_close(file);
}

} // namespace

std::vector<SampleFile> ownSamples()
{
	return {
	    {"ascii_bricks.dat", writeTecplotBricks, "unstructured", kCells, kPoints, true, ""},
	    {"ascii_ordered.tec", writeTecplotOrdered, "curvilinear", kCells, kPoints, false, ""},
	    {"ascii_ucd.inp", writeUcd, "unstructured", kCells, kPoints, true, ""},
	    {"inline.xmf", writeXdmf, "unstructured", kCells, kPoints, true, ""},
	    {"turned.mrc", writeTurnedMrc, "curvilinear", kCells, kPoints, false, ""},
	    {"slice_0.dcm", writeDicom, "image", kCells, kPoints, false, "slice_3.dcm"},
	    {"stack.tif", writeImageJ, "image", kCells, kPoints, false, ""},
	    {"classic.nc", [](const std::string& p) { writeNetcdf(p, NC_CLOBBER); }, "rectilinear", kCells, kPoints, false,
	     ""},
	    {"four.nc", [](const std::string& p) { writeNetcdf(p, NC_CLOBBER | NC_NETCDF4); }, "rectilinear", kCells,
	     kPoints, false, ""},
	    {"ascii_2.msh", writeGmsh2, "unstructured", kCells, kPoints, true, ""},
	    {"binary_4.msh", writeGmsh4, "unstructured", kCells, kPoints, true, ""},
	    {"f.npy", [](const std::string& path) { writeContents(path, npyBytes()); }, "image", kCells, kPoints, false,
	     ""},
	    {"volume.npz", writeNpz, "image", kCells, kPoints, false, ""},
	};
}
