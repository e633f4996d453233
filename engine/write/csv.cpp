#include "write/csv_text.h"
#include "write/slice_formats.h"
#include "write/unique_names.h"

#include <fmt/format.h>

#include <iterator>

namespace vp::write
{

namespace
{

void appendColumn(std::string& row, const Column& column, std::size_t tuple)
{
	const std::byte* at = column.bytes.data() + tuple * column.components * grid::byteSize(column.type);
	appendNumbers(row, column.type, at, column.components);
}

} // namespace

void writeCsv(const SliceTable& table, AtomicFile& file)
{
	UniqueNames names;
	std::string text;
	for (const char* name : {"sheet", "block", "cell", "polygon", "x", "y", "z"})
		fmt::format_to(std::back_inserter(text), "{}{}", text.empty() ? "" : ",", names.add(name));
	for (const std::vector<Column>* columns : {&table.vertex_columns, &table.polygon_columns})
		for (const Column& column : *columns)
			for (int c = 0; c < column.components; ++c)
				text += ',' + quoted(names.add(column.componentName(c)));
	if (table.has_contours)
		text += ',' + quoted(names.add("contour"));
	text += '\n';

	// A vertex stands in some five rows: its numbers are put into words once.
	std::string vertex_text;
	std::vector<std::size_t> vertex_starts{0};
	vertex_starts.reserve(table.vertices() + 1);
	for (std::size_t v = 0; v < table.vertices(); ++v)
	{
		const Vec3& p = table.positions[v];
		fmt::format_to(std::back_inserter(vertex_text), ",{},{},{}", p.x, p.y, p.z);
		for (const Column& column : table.vertex_columns)
			appendColumn(vertex_text, column, v);
		vertex_starts.push_back(vertex_text.size());
	}

	constexpr std::size_t kChunk = std::size_t(1) << 20; // written at a time
	std::string origin;
	std::string cell_values;
	for (std::size_t p = 0; p < table.polygons(); ++p)
	{
		origin.clear();
		fmt::format_to(std::back_inserter(origin), "{},{},{},{}", table.sheet[p], table.block[p], table.cell[p], p);
		cell_values.clear();
		for (const Column& column : table.polygon_columns)
			appendColumn(cell_values, column, p);
		if (table.has_contours)
			fmt::format_to(std::back_inserter(cell_values), ",{}", table.contour[p]);
		cell_values += '\n';
		for (std::int64_t i = table.polygon_starts[p]; i < table.polygon_starts[p + 1]; ++i)
		{
			const auto v = static_cast<std::size_t>(table.polygon_vertices[i]);
			text += origin;
			text.append(vertex_text, vertex_starts[v], vertex_starts[v + 1] - vertex_starts[v]);
			text += cell_values;
		}
		if (text.size() > kChunk)
		{
			file.write(text);
			text.clear();
		}
	}
	file.write(text);
}

} // namespace vp::write
