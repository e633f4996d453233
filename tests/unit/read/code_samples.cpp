#include "box_faces.h"
#include "own_samples.h"
#include "sample_bytes.h"

#include <fmt/format.h>

namespace
{

using vp::Vec3;

// Corners row by row, as GAMBIT numbers them.
void writeGambit(const std::string& path)
{
	std::string nodes, elements, group;
	eachSamplePoint([&](const Vec3& at, int p)
	                { nodes += fmt::format("{:>10}{:20.11e}{:20.11e}{:20.11e}\n", p + 5, at.x, at.y, at.z); });
	eachSampleCell(
	    [&](const Vec3&, const std::array<int, 8>& c, int index)
	    {
		    elements += fmt::format("{:>8} {:2} {:2}", index + 1, 4, 8);
		    const std::array<int, 8> by_rows = {c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]};
		    for (std::size_t i = 0; i < 8; ++i)
			    elements += fmt::format("{}{:>8}", i == 7 ? "\n               " : "", by_rows[i] + 5);
		    elements += "\n";
		    group += fmt::format("{:>8}{}", index + 1, index % 10 == 9 ? "\n" : "");
	    });
	writeContents(path, "        CONTROL INFO 2.4.6\n** GAMBIT NEUTRAL FILE\nbox\nPROGRAM:                Gambit     "
	                    "VERSION:  2.4.6\n 1 Jan 2020    12:00:00\n     NUMNP     NELEM     NGRPS    NBSETS     NDFCD "
	                    "    NDFVL\n       120        60         1         0         3         3\nENDOFSECTION\n"
	                    "   NODAL COORDINATES 2.4.6\n" +
	                        nodes + "ENDOFSECTION\n      ELEMENTS/CELLS 2.4.6\n" + elements +
	                        "ENDOFSECTION\n       ELEMENT GROUP 2.4.6\nGROUP:          1 ELEMENTS:         60 MATERIAL:"
	                        "          2 NFLAGS:          1\n                           fluid\n       0\n" +
	                        group + "ENDOFSECTION\n");
}

// Voxels whose values fit in a byte, each plane packed: runs of equal values are not looked for.
void writeSlc(const std::string& path, bool packed)
{
	std::string bytes = fmt::format("11111\n5 4 6\n8\n1.0 1.0 0.25\n1 2 0 {}\n2 1 X", packed ? 1 : 0) + "iconic";
	for (int k = 0; k < kSamplePoints[2]; ++k)
	{
		std::string plane;
		for (int j = 0; j < kSamplePoints[1]; ++j)
			for (int i = 0; i < kSamplePoints[0]; ++i)
				plane += static_cast<char>(static_cast<int>(sampleValue(Vec3(i, j, 0.25 * k))));
		if (packed)
			bytes += fmt::format("{} X", plane.size() + 2) + static_cast<char>(0x80 | plane.size()) + plane + '\0';
		else
			bytes += plane;
	}
	writeContents(path, bytes);
}

// A survey in floats of IBM, whose traces are not in order; samples are 2 ms apart and lie below each other.
void writeSegy(const std::string& path)
{
	std::string bytes(3600, '\0');
	for (std::size_t line = 0; line < 40; ++line)
		bytes.replace(80 * line, 80, "\xC3" + std::string(79, '\x40'));
	const auto set = [](std::string& at, std::size_t place, auto number)
	{
		std::string big;
		addBigEndian(big, number);
		at.replace(place, big.size(), big);
	};
	set(bytes, 3216, std::int16_t(2000));
	set(bytes, 3220, std::int16_t(kSamplePoints[2]));
	set(bytes, 3224, std::int16_t(1));
	for (int trace = 0; trace < 20; ++trace)
	{
		const int column = trace * 7 % 20;
		const int i = column % 5, j = column / 5;
		std::string head(240, '\0');
		set(head, 70, std::int16_t(-10));
		set(head, 114, std::int16_t(kSamplePoints[2]));
		set(head, 180, std::int32_t(10 * i));
		set(head, 184, std::int32_t(10 * j));
		set(head, 188, std::int32_t(100 + j));
		set(head, 192, std::int32_t(200 + 2 * i));
		bytes += head;
		for (int k = 0; k < kSamplePoints[2]; ++k)
		{
			// A sign, a power of 16, and six digits of base 16 behind the point.
			const double value = sampleValue(Vec3(i, j, -2.0 * k));
			const auto digits = static_cast<std::uint32_t>(std::abs(value) * 4096.0);
			addBigEndian(bytes, (value < 0.0 ? 0x80000000u : 0u) | 0x43000000u | digits);
		}
	}
	writeContents(path, bytes);
}

void writeBinaryUcd(const std::string& path)
{
	std::string heads, lists, f, g;
	std::array<std::string, 3> places;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    addBigEndian(places[static_cast<std::size_t>(axis)], static_cast<float>(at[axis]));
		    addBigEndian(f, static_cast<float>(sampleValue(at)));
	    });
	eachSampleCell(
	    [&](const Vec3& middle, const std::array<int, 8>& c, int index)
	    {
		    for (const int number : {index + 1, 3, 8, 7})
			    addBigEndian(heads, number);
		    for (const int corner : {c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]})
			    addBigEndian(lists, corner + 1);
		    addBigEndian(g, static_cast<float>(sampleValue(middle)));
	    });
	const auto arrays = [](std::string name, std::string units, const std::string& values)
	{
		name.resize(1024);
		units.resize(1024);
		std::string bytes = name + units;
		addBigEndian(bytes, 1);
		addBigEndian(bytes, 1);
		addBigEndian(bytes, 0.0f);
		addBigEndian(bytes, 534.0f);
		bytes += values;
		addBigEndian(bytes, 1);
		return bytes;
	};
	std::string bytes = "\7";
	for (const int number : {120, 60, 1, 1, 0, 480})
		addBigEndian(bytes, number);
	writeContents(path, bytes + heads + lists + places[0] + places[1] + places[2] + arrays("f.", "K.", f) +
	                        arrays("g.", "none.", g));
}

// A case with its data file, in text or in binary.
void writeFluent(const std::string& path, bool binary)
{
	const auto section = [binary](int number, int binary_number, const std::string& head, const std::string& body)
	{
		const int shown = binary ? binary_number : number;
		return fmt::format("({} ({})({}{}", shown, head, binary ? "" : "\n", body) +
		       (binary ? fmt::format("\n)\nEnd of Binary Section   {})\n", shown) : std::string("))\n"));
	};
	const auto addReal = [binary](std::string& body, double number)
	{
		if (binary)
			addBytes(body, number);
		else
			body += fmt::format("{} ", number);
	};
	const auto addWhole = [binary](std::string& body, int number)
	{
		if (binary)
			addBytes(body, number);
		else
			body += fmt::format("{:x} ", number);
	};
	std::string nodes, values;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    addReal(nodes, at[axis]);
	    });
	eachSampleCell([&](const Vec3& middle, const std::array<int, 8>&, int) { addReal(values, sampleValue(middle)); });
	const std::vector<BoxFace> faces = facesOfBox();
	std::array<std::string, 2> lists;
	std::size_t inside = 0;
	for (const BoxFace& face : faces)
	{
		inside += face.cells[1] >= 0;
		std::string& list = lists[face.cells[1] >= 0 ? 0 : 1];
		for (const int corner : face.corners)
			addWhole(list, corner + 1);
		for (const int cell : face.cells)
			addWhole(list, cell + 1);
	}
	const std::string head = "(0 \"a comment (with a parenthesis\")\n(4 (60 0 0 1 2 4 4 4 8 8 4))\n";
	writeContents(path, head + "(2 3)\n(10 (0 1 78 0 3))\n(12 (0 1 3c 0))\n" +
	                        fmt::format("(13 (0 1 {:x} 0))\n", faces.size()) + "(12 (2 1 3c 1 4))\n" +
	                        section(10, 3010, "1 1 78 1 3", nodes) +
	                        section(13, 2013, fmt::format("3 1 {:x} 2 4", inside), lists[0]) +
	                        section(13, 2013, fmt::format("4 {:x} {:x} 3 4", inside + 1, faces.size()), lists[1]) +
	                        "(39 (2 fluid water 1)())\n(39 (4 wall sides 1)())\n");
	writeContents(std::filesystem::path(path).replace_extension(".dat").string(),
	              head + fmt::format("(33 (60 {} 120))\n", faces.size()) +
	                  section(300, 3300, "1 2 1 0 0 1 60", values));
}

// Words of 8 bytes: control words, a mesh of solids, and two states of which the later one is not moved.
void writeD3plot(const std::string& path)
{
	std::string control(64 * 8, '\0');
	const auto set = [&](std::size_t word, auto number)
	{
		std::string bytes;
		addBytes(bytes, number);
		control.replace(8 * word, 8, bytes);
	};
	const auto setWhole = [&](std::size_t word, std::int64_t number) { set(word, number); };
	control.replace(0, 5, "a box");
	setWhole(11, 1);
	set(14, 971.0);
	for (const auto& [word, number] :
	     {std::pair{15, 4}, {16, 120}, {17, 6}, {18, 6}, {19, 1}, {20, 1}, {21, 1}, {23, 60}, {24, 1}, {27, 7}})
		setWhole(static_cast<std::size_t>(word), number);
	std::string places, solids;
	eachSamplePoint(
	    [&](const Vec3& at, int)
	    {
		    for (int axis = 0; axis < 3; ++axis)
			    addBytes(places, static_cast<double>(at[axis]));
	    });
	eachSampleCell(
	    [&](const Vec3&, const std::array<int, 8>& corners, int)
	    {
		    for (const int corner : corners)
			    addBytes(solids, std::int64_t(corner) + 1);
		    addBytes(solids, std::int64_t(1));
	    });
	std::string bytes = control + places + solids;
	for (const double time : {0.5, 1.5})
	{
		addBytes(bytes, time);
		for (int global = 0; global < 6; ++global)
			addBytes(bytes, 1.0);
		eachSamplePoint(
		    [&](const Vec3& at, int)
		    {
			    for (int axis = 0; axis < 3; ++axis)
				    addBytes(bytes, static_cast<double>(at[axis]) + (time == 1.5 ? 0.0 : 1.0));
		    });
		eachSamplePoint([&](const Vec3& at, int) { addBytes(bytes, time == 1.5 ? sampleValue(at) : 0.0); });
		eachSamplePoint(
		    [&](const Vec3&, int)
		    {
			    for (const double velocity : {1.0, 2.0, 3.0})
				    addBytes(bytes, velocity);
		    });
		eachSampleCell(
		    [&](const Vec3& middle, const std::array<int, 8>&, int)
		    {
			    for (int stress = 0; stress < 6; ++stress)
				    addBytes(bytes, 1.0 * stress);
			    addBytes(bytes, sampleValue(middle));
		    });
	}
	addBytes(bytes, -999999.0);
	writeContents(path, bytes);
}

} // namespace

std::vector<SampleFile> codeSamples()
{
	return {
	    {"ascii_gambit.neu", writeGambit, "unstructured", kSampleCellCount, kSamplePointCount, false, "", false},
	    {"plain.slc", [](const std::string& p) { writeSlc(p, false); }, "image", kSampleCellCount, kSamplePointCount,
	     false, ""},
	    {"packed.slc", [](const std::string& p) { writeSlc(p, true); }, "image", kSampleCellCount, kSamplePointCount,
	     false, ""},
	    {"survey.sgy", writeSegy, "curvilinear", kSampleCellCount, kSamplePointCount, false, ""},
	    {"d3plot", writeD3plot, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"binary_ucd.inp", writeBinaryUcd, "unstructured", kSampleCellCount, kSamplePointCount, true, ""},
	    {"ascii_fluent.cas", [](const std::string& p) { writeFluent(p, false); }, "unstructured", kSampleCellCount,
	     kSamplePointCount, true, "", false},
	    {"binary_fluent.cas", [](const std::string& p) { writeFluent(p, true); }, "unstructured", kSampleCellCount,
	     kSamplePointCount, true, "", false},
	    {"ascii_fluent_data.cas", [](const std::string& p) { writeFluent(p, false); }, "unstructured", kSampleCellCount,
	     kSamplePointCount, true, "ascii_fluent_data.dat", false},
	    {"binary_fluent_data.cas", [](const std::string& p) { writeFluent(p, true); }, "unstructured", kSampleCellCount,
	     kSamplePointCount, true, "binary_fluent_data.dat", false},
	};
}
