#include "write/slice_formats.h"
#include "write/unique_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

namespace vp::write
{

namespace
{

using grid::NumberType;

static_assert(std::endian::native == std::endian::little, "the header says little endian");

// Numbers of a column as PLY knows them.
struct Property
{
	std::vector<std::string> names; // per component
	NumberType type;
	const std::byte* bytes;
	std::size_t tuple;                // bytes per vertex or face
	std::vector<std::byte> converted; // what `bytes` points to where the type had to change
};

// PLY has no integers of 64 bits: int where all values fit, else double.
template <class T>
void narrow(std::span<const std::byte> source, Property& property)
{
	std::vector<T> values(source.size() / sizeof(T));
	if (!values.empty())
		std::memcpy(values.data(), source.data(), source.size());
	const bool fits = std::all_of(values.begin(), values.end(), [](T v) { return std::in_range<std::int32_t>(v); });
	const auto convert = [&](auto to)
	{
		using To = decltype(to);
		property.converted.resize(values.size() * sizeof(To));
		for (std::size_t i = 0; i < values.size(); ++i)
		{
			const To value = static_cast<To>(values[i]);
			std::memcpy(property.converted.data() + i * sizeof(To), &value, sizeof(To));
		}
	};
	if (fits)
		convert(std::int32_t{});
	else
		convert(double{});
	property.type = fits ? NumberType::int32 : NumberType::float64;
}

// Header words end at white space, and the header is ASCII.
std::string plyName(std::string name)
{
	for (char& c : name)
		if (c <= ' ' || c > '~')
			c = '_';
	return name;
}

Property makeProperty(std::vector<std::string> names, NumberType type, std::span<const std::byte> bytes, int components)
{
	Property property{std::move(names), type, bytes.data(), 0, {}};
	if (type == NumberType::int64)
		narrow<std::int64_t>(bytes, property);
	else if (type == NumberType::uint64)
		narrow<std::uint64_t>(bytes, property);
	if (property.type != type)
		property.bytes = property.converted.data();
	property.tuple = grid::byteSize(property.type) * components;
	return property;
}

Property makeProperty(const Column& column, UniqueNames& taken)
{
	std::vector<std::string> names;
	for (int c = 0; c < column.components; ++c)
		names.push_back(taken.add(plyName(column.componentName(c))));
	return makeProperty(std::move(names), column.type, column.bytes, column.components);
}

template <class Values>
Property makeProperty(const char* name, NumberType type, const Values& values, UniqueNames& taken)
{
	return makeProperty({taken.add(name)}, type, std::as_bytes(std::span(values)), 1);
}

std::string declarations(const std::vector<Property>& properties)
{
	constexpr const char* types[] = {"char", "uchar", "short", "ushort", "int", "uint", "", "", "float", "double"};
	std::string text;
	for (const Property& property : properties)
		for (const std::string& name : property.names)
			fmt::format_to(std::back_inserter(text), "property {} {}\n", types[static_cast<int>(property.type)], name);
	return text;
}

template <class T>
void append(std::string& bytes, T number)
{
	bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void append(std::string& bytes, const std::vector<Property>& properties, std::size_t row)
{
	for (const Property& property : properties)
		bytes.append(reinterpret_cast<const char*>(property.bytes + row * property.tuple), property.tuple);
}

constexpr std::size_t kChunk = std::size_t(1) << 20; // written at a time

void flushPast(std::string& bytes, std::size_t size, AtomicFile& file)
{
	if (bytes.size() <= size)
		return;
	file.write(bytes);
	bytes.clear();
}

} // namespace

void writePly(const SliceTable& table, AtomicFile& file)
{
	UniqueNames vertex_names;
	UniqueNames face_names;
	for (const char* name : {"x", "y", "z"})
		vertex_names.add(name);
	face_names.add("vertex_indices");

	std::vector<Property> vertex_properties;
	for (const Column& column : table.vertex_columns)
		vertex_properties.push_back(makeProperty(column, vertex_names));
	std::vector<Property> face_properties;
	face_properties.push_back(makeProperty("vprobe:cell", NumberType::int64, table.cell, face_names));
	face_properties.push_back(makeProperty("vprobe:block", NumberType::int32, table.block, face_names));
	face_properties.push_back(makeProperty("vprobe:sheet", NumberType::int32, table.sheet, face_names));
	if (table.has_contours)
		face_properties.push_back(makeProperty("vprobe:contour", NumberType::float64, table.contour, face_names));
	for (const Column& column : table.polygon_columns)
		face_properties.push_back(makeProperty(column, face_names));

	std::int64_t most_corners = 0;
	for (std::size_t p = 0; p < table.polygons(); ++p)
		most_corners = std::max(most_corners, table.polygon_starts[p + 1] - table.polygon_starts[p]);
	const bool short_count = most_corners <= std::numeric_limits<std::uint8_t>::max();
	const bool few_vertices = std::in_range<std::int32_t>(table.vertices()); // the same bits, but more readers know int

	std::string bytes =
	    fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
	                "property double x\nproperty double y\nproperty double z\n{}"
	                "element face {}\nproperty list {} {} vertex_indices\n{}end_header\n",
	                table.vertices(), declarations(vertex_properties), table.polygons(), short_count ? "uchar" : "int",
	                few_vertices ? "int" : "uint", declarations(face_properties));
	for (std::size_t v = 0; v < table.vertices(); ++v)
	{
		append(bytes, table.positions[v]);
		append(bytes, vertex_properties, v);
		flushPast(bytes, kChunk, file);
	}
	for (std::size_t p = 0; p < table.polygons(); ++p)
	{
		const std::int64_t begin = table.polygon_starts[p];
		const std::int64_t end = table.polygon_starts[p + 1];
		if (short_count)
			append(bytes, static_cast<std::uint8_t>(end - begin));
		else
			append(bytes, static_cast<std::int32_t>(end - begin));
		for (std::int64_t i = begin; i < end; ++i)
			append(bytes, static_cast<std::uint32_t>(table.polygon_vertices[i]));
		append(bytes, face_properties, p);
		flushPast(bytes, kChunk, file);
	}
	flushPast(bytes, 0, file);
}

} // namespace vp::write
