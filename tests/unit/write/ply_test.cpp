#include "sample_slice.h"

#include "mesh/mesh_values.h"
#include "write/slice_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

namespace vp::test
{

namespace
{

// A PLY reader as a stranger would write it: from the header alone.
struct PlyElement
{
	std::size_t count = 0;
	std::vector<std::string> names; // in the file's order
	std::map<std::string, std::string> types;
	std::map<std::string, std::vector<double>> values;
	std::vector<std::vector<std::size_t>> lists;
};

class PlyFile
{
public:
	explicit PlyFile(const std::string& bytes) : bytes_(bytes)
	{
		std::istringstream header(bytes);
		std::string line;
		std::vector<std::string> order;
		while (std::getline(header, line) && line != "end_header")
		{
			std::istringstream words(line);
			std::string key, name;
			words >> key;
			if (key == "format")
				words >> format;
			else if (key == "element")
			{
				words >> name >> elements[name].count;
				order.push_back(name);
			}
			else if (key == "property")
				readProperty(words, elements[order.back()]);
		}
		at_ = static_cast<std::size_t>(header.tellg());
		for (const std::string& name : order)
			readElement(elements[name]);
	}

	std::string format;
	std::map<std::string, PlyElement> elements;
	bool whole() const { return at_ == bytes_.size(); }

private:
	static void readProperty(std::istringstream& words, PlyElement& element)
	{
		std::string type, name, count_type, index_type;
		words >> type;
		if (type == "list")
		{
			words >> count_type >> index_type;
			type += ' ' + count_type + ' ' + index_type;
		}
		words >> name;
		element.names.push_back(name);
		element.types[name] = type;
	}
	template <class T>
	double take()
	{
		T number;
		std::memcpy(&number, bytes_.data() + at_, sizeof(T));
		at_ += sizeof(T);
		return static_cast<double>(number);
	}
	double take(const std::string& type)
	{
		if (type == "uchar")
			return take<std::uint8_t>();
		if (type == "short")
			return take<std::int16_t>();
		if (type == "int")
			return take<std::int32_t>();
		if (type == "float")
			return take<float>();
		EXPECT_EQ(type, "double");
		return take<double>();
	}
	void readElement(PlyElement& element)
	{
		for (std::size_t row = 0; row < element.count; ++row)
			for (const std::string& name : element.names)
			{
				std::istringstream type(element.types[name]);
				std::string word, count_type, index_type;
				type >> word >> count_type >> index_type;
				if (word != "list")
				{
					element.values[name].push_back(take(word));
					continue;
				}
				element.lists.emplace_back(static_cast<std::size_t>(take(count_type)));
				for (std::size_t& index : element.lists.back())
					index = static_cast<std::size_t>(take(index_type));
			}
	}

	const std::string bytes_;
	std::size_t at_ = 0;
};

} // namespace

TEST(Ply, HoldsTheMesh)
{
	const SampleSlice sample = sampleSlice();
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeSlice(sample.blocks, sample.meshes, folder / "cut.PLY"));
	PlyFile file(readText(folder / "cut.PLY"));
	EXPECT_EQ(file.format, "binary_little_endian");
	EXPECT_TRUE(file.whole());
	PlyElement& vertex = file.elements["vertex"];
	PlyElement& face = file.elements["face"];
	ASSERT_EQ(vertex.count, sample.vertices());
	ASSERT_EQ(face.count, sample.polygons());
	EXPECT_EQ(vertex.types["x"], "double");
	EXPECT_EQ(face.types["vertex_indices"], "list uchar int");

	std::size_t v = 0;
	std::size_t f = 0;
	for (const mesh::SheetMesh& mesh : sample.meshes)
	{
		const std::size_t base = v;
		for (const Vec3& position : mesh.positions)
		{
			EXPECT_EQ(Vec3(vertex.values["x"][v], vertex.values["y"][v], vertex.values["z"][v]), position);
			++v;
		}
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
		{
			std::vector<std::size_t> expected;
			for (const std::uint32_t corner : mesh.polygon(p))
				expected.push_back(base + corner);
			EXPECT_EQ(face.lists[f++], expected);
		}
	}
}

TEST(Ply, CarriesArraysAsProperties)
{
	const SampleSlice sample = sampleSlice();
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeSlice(sample.blocks, sample.meshes, folder / "cut.ply"));
	PlyFile file(readText(folder / "cut.ply"));
	PlyElement& vertex = file.elements["vertex"];
	PlyElement& face = file.elements["face"];
	const std::vector<std::string> vertex_names{"x", "y", "z", "s", "v_x", "v_y", "v_z", "level"};
	EXPECT_EQ(vertex.names, vertex_names);
	const std::vector<std::string> face_names{
	    "vertex_indices", "vprobe:cell",     "vprobe:block",   "vprobe:sheet", "id",
	    "flag",           "odd,_\"name\"_x", "odd,_\"name\"_y"};
	EXPECT_EQ(face.names, face_names);
	EXPECT_EQ(face.types["vprobe:cell"], "int");
	EXPECT_EQ(face.types["id"], "double"); // past 32 bits
	EXPECT_EQ(face.types["flag"], "uchar");

	std::size_t v = 0;
	for (const mesh::SheetMesh& mesh : sample.meshes)
		for (const mesh::EdgePoint& edge : mesh.edges)
		{
			const grid::Block& block = sample.blocks.blocks[edge.block];
			EXPECT_EQ(vertex.values["s"][v], mesh::interpolate(block, block.fields[0], 0, edge));
			EXPECT_EQ(vertex.values["v_z"][v], static_cast<float>(mesh::interpolate(block, block.fields[1], 2, edge)));
			++v;
		}
	for (std::size_t f = 0; f < face.count; ++f)
	{
		const bool first_block = face.values["vprobe:block"][f] == 0;
		const double source = face.values["vprobe:cell"][f];
		EXPECT_EQ(face.values["id"][f],
		          first_block ? static_cast<double>(kFirstId + static_cast<std::int64_t>(source)) : 0.0);
	}
}

TEST(Ply, NamesAreOfOneKind)
{
	SampleSlice sample = sampleSlice();
	sample.blocks.blocks.pop_back(); // its polygons go too
	const grid::UniformGrid image({3, 3, 3}, Vec3(0.0), Vec3(1.0));
	grid::Block block;
	block.grid = image;
	block.fields.push_back(grid::makeField("x", grid::Association::point, 1, std::vector<float>(27, 1.0f)));
	block.fields.push_back(grid::makeField("a b", grid::Association::point, 1, std::vector<float>(27, 2.0f)));
	block.fields.push_back(grid::makeField("a\tb", grid::Association::point, 1, std::vector<float>(27, 3.0f)));
	sample.blocks.blocks = {block};
	sample.meshes.assign(1, {});
	mesh::SheetMesh& mesh = sample.meshes[0];
	mesh.positions = {{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 1, 1}};
	mesh.edges = {{0, 0, 1, 0.5}, {0, 3, 4, 0.5}, {0, 12, 13, 0.5}};
	mesh.polygon_starts = {0, 3};
	mesh.polygon_vertices = {0, 1, 2};
	mesh.polygon_cells = {{0, 0}};
	const TemporaryFolder folder;
	ASSERT_TRUE(write::writeSlice(sample.blocks, sample.meshes, folder / "cut.ply"));
	PlyFile file(readText(folder / "cut.ply"));
	const std::vector<std::string> names{"x", "y", "z", "x_2", "a_b", "a_b_2"};
	EXPECT_EQ(file.elements["vertex"].names, names);
	EXPECT_EQ(file.elements["vertex"].values["x"][0], 0.5);
	EXPECT_EQ(file.elements["vertex"].values["x_2"][0], 1.0);
	EXPECT_EQ(file.elements["vertex"].values["a_b_2"][2], 3.0);
}

} // namespace vp::test
