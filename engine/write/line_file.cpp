#include "write/line_file.h"

#include "measure/plane_triangles.h"
#include "measure/sheet_line.h"
#include "write/atomic_file.h"
#include "write/csv_text.h"
#include "write/unique_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace vp::write
{

namespace
{

using measure::LinePiece;

class LineRows
{
public:
	LineRows(const SliceTable& table, const probe::Sheet& content, const SheetLine& line)
	    : table_(table), content_(content), line_(line)
	{
	}

	std::string text(std::span<const LinePiece> pieces)
	{
		header();
		double end = 0.0;
		const LinePiece* last = nullptr;
		for (const LinePiece& piece : pieces)
		{
			const bool gap = piece.from - end > measure::kLineGap;
			if (last && (gap || pointValues(*last, last->to) != pointValues(piece, piece.from)))
				row(last->to, last);
			if (gap)
				row(last ? 0.5 * (end + piece.from) : 0.0, nullptr);
			row(piece.from, &piece);
			last = &piece;
			end = piece.to;
		}
		if (last)
			row(end, last);
		if (1.0 - end > measure::kLineGap)
		{
			if (!last)
				row(0.0, nullptr);
			row(1.0, nullptr);
		}
		return std::move(text_);
	}

private:
	void header()
	{
		UniqueNames names;
		for (const char* name : {"distance", "u", "v", "x", "y", "z", "block", "cell"})
			fmt::format_to(std::back_inserter(text_), "{}{}", text_.empty() ? "" : ",", names.add(name));
		for (const std::vector<Column>* columns : {&table_.vertex_columns, &table_.polygon_columns})
			for (const Column& column : *columns)
				for (int c = 0; c < column.components; ++c)
					text_ += ',' + quoted(names.add(column.componentName(c)));
		text_ += '\n';
	}

	// Only arrays whose numbers are names have an integer type (slice_table.h). They take the nearer value.
	static double between(const Column& column, double a, double b, double part)
	{
		if (column.type != grid::NumberType::float32 && column.type != grid::NumberType::float64)
			return part <= 0.5 ? a : b;
		return a + part * (b - a);
	}

	static double at(const Column& column, const measure::SideCrossing& side, int component)
	{
		return between(column, column.value(side.a, component), column.value(side.b, component), side.part);
	}

	std::vector<double> pointValues(const LinePiece& piece, double t) const
	{
		std::vector<double> values;
		for (const Column& column : table_.vertex_columns)
			for (int c = 0; c < column.components; ++c)
				values.push_back(t == piece.enter.t   ? at(column, piece.enter, c)
				                 : t == piece.leave.t ? at(column, piece.leave, c)
				                                      : between(column, at(column, piece.enter, c),
				                                                at(column, piece.leave, c), piece.along(t)));
		return values;
	}

	// In the slice with a piece, else outside.
	void row(double t, const LinePiece* piece)
	{
		const glm::dvec2 uv = line_.from + t * (line_.to - line_.from);
		const Vec3 p = content_.origin + uv.x * content_.xAxis() + uv.y * content_.up;
		fmt::format_to(std::back_inserter(text_), "{},{},{},{},{},{}", t * glm::length(line_.to - line_.from), uv.x,
		               uv.y, p.x, p.y, p.z);
		if (piece)
			fmt::format_to(std::back_inserter(text_), ",{},{}", table_.block[piece->polygon],
			               table_.cell[piece->polygon]);
		else
			text_ += ",nan,nan";
		const auto put = [&](double value) { fmt::format_to(std::back_inserter(text_), ",{}", value); };
		if (piece)
			for (const double value : pointValues(*piece, t))
				put(value);
		else
			for (const Column& column : table_.vertex_columns)
				for (int c = 0; c < column.components; ++c)
					put(std::numeric_limits<double>::quiet_NaN());
		for (const Column& column : table_.polygon_columns)
			for (int c = 0; c < column.components; ++c)
				put(piece ? column.value(piece->polygon, c) : std::numeric_limits<double>::quiet_NaN());
		text_ += '\n';
	}

	const SliceTable& table_;
	const probe::Sheet& content_;
	const SheetLine& line_;
	std::string text_;
};

// Returns true if a polygon reaches across the extended line, or lies beside it within rounding. The answer depends on
// the polygon alone, and not on other polygons.
bool mayMeet(const SheetLine& line, std::span<const std::uint32_t> polygon, std::span<const glm::dvec2> points)
{
	constexpr double kRounding = 1e-9;
	const glm::dvec2 way = line.to - line.from;
	const double length = glm::length(way);
	double left = -std::numeric_limits<double>::infinity();
	double right = left;
	double reach = length;
	for (const std::uint32_t v : polygon)
	{
		const glm::dvec2 from = points[v] - line.from;
		const double off = (way.x * from.y - way.y * from.x) / length;
		left = std::max(left, off);
		right = std::max(right, -off);
		reach = std::max(reach, glm::length(from));
	}
	return left >= -kRounding * reach && right >= -kRounding * reach;
}

// The polygons of a table, without where they come from.
mesh::SheetMesh meshOf(const SliceTable& table)
{
	mesh::SheetMesh mesh;
	mesh.positions.resize(table.vertices());
	std::ranges::copy(table.positions, mesh.positions.begin());
	mesh.polygon_starts.push_back(0);
	for (std::size_t p = 0; p < table.polygons(); ++p)
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(table.polygon_starts[p + 1]));
	for (const std::int64_t v : table.polygon_vertices)
		mesh.polygon_vertices.push_back(static_cast<std::uint32_t>(v));
	mesh.polygon_cells.resize(table.polygons());
	return mesh;
}

} // namespace

SliceTable tabulateAlong(const grid::BlockSet& blocks, const probe::Sheet& content, const mesh::SheetMesh& mesh,
                         const SheetLine& line)
{
	const auto points = measure::planePoints(mesh, content);
	mesh::SheetMesh along = mesh;
	along.polygon_starts.clear();
	along.polygon_vertices.clear();
	along.polygon_cells.clear();
	along.polygon_starts.push_back(0);
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		if (!mayMeet(line, mesh.polygon(p), points))
			continue;
		for (const std::uint32_t v : mesh.polygon(p))
			along.polygon_vertices.push_back(v);
		along.polygon_starts.push_back(static_cast<std::uint32_t>(along.polygon_vertices.size()));
		along.polygon_cells.push_back(mesh.polygon_cells[p]);
	}
	mesh::dropUnusedVertices(along);
	return tabulate(blocks, std::span(&along, 1));
}

Status writeLine(const SliceTable& table, const probe::Sheet& content, const SheetLine& line, const std::string& path)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	const mesh::SheetMesh mesh = meshOf(table);
	const std::vector<LinePiece> pieces =
	    measure::alongLine(mesh, measure::planePoints(mesh, content), line.from, line.to);
	file->write(LineRows(table, content, line).text(pieces));
	return file->commit();
}

} // namespace vp::write
