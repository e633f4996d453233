#include "api/border.h"
#include "api/states.h"
#include "measure/stats.h"
#include "read/check_mesh.h"
#include "read/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace vprobe
{

namespace
{

using vp::read::Unusable;

// Numbers of cuts that no cutter makes: these count from 1.
std::uint64_t ownNumber()
{
	static std::atomic<std::uint64_t> next = std::uint64_t(1) << 63;
	return next++;
}

template <class T>
std::span<const T> numbersFrom(const Numbers& numbers, const char* what)
{
	if (numbers.type != numberTypeOf<T>() || (numbers.size > 0 && !numbers.data))
		throw Unusable(fmt::format("{}: another number type than it should have", what));
	return {static_cast<const T*>(numbers.data), numbers.size};
}

// The caller's polygons after the checks.
struct OwnParts
{
	std::span<const double> points;
	std::span<const std::int64_t> offsets, connectivity, cells;
	std::span<const std::int32_t> blocks;

	std::size_t vertices() const { return points.size() / 3; }
	std::size_t polygons() const { return cells.size(); }
};

OwnParts checkedParts(const OwnPolygons& own)
{
	const OwnParts parts{numbersFrom<double>(own.points, "points"), numbersFrom<std::int64_t>(own.offsets, "offsets"),
	                     numbersFrom<std::int64_t>(own.connectivity, "connectivity"),
	                     numbersFrom<std::int64_t>(own.cells, "cells"),
	                     numbersFrom<std::int32_t>(own.blocks, "blocks")};
	if (parts.points.size() % 3 != 0)
		throw Unusable("points: points without three coordinates");
	if (parts.vertices() >= vp::kMaxBlockIds || parts.connectivity.size() >= vp::kMaxBlockIds)
		throw Unusable("points: more than a slice can have");
	if (parts.offsets.size() != parts.polygons() + 1 || parts.blocks.size() != parts.polygons())
		throw Unusable(fmt::format("{} offsets and {} blocks where there are {} polygons", parts.offsets.size(),
		                           parts.blocks.size(), parts.polygons()));
	const auto corners = static_cast<std::int64_t>(parts.connectivity.size());
	for (std::size_t p = 0; p < parts.polygons(); ++p)
		if (parts.offsets[p] < 0 || parts.offsets[p + 1] > corners || parts.offsets[p + 1] < parts.offsets[p] + 3)
			throw Unusable(fmt::format("offsets: polygon {} does not have three corners or more", p));
	if (parts.offsets.front() != 0 || parts.offsets.back() != corners)
		throw Unusable("offsets: do not go from 0 to the end of the connectivity");
	for (const std::int64_t id : parts.connectivity)
		if (id < 0 || static_cast<std::size_t>(id) >= parts.vertices())
			throw Unusable(fmt::format("connectivity: there is no point {}", id));
	return parts;
}

std::vector<vp::grid::Field> checkedArrays(const OwnPolygons& own, const OwnParts& parts)
{
	std::vector<vp::grid::Field> fields;
	for (const Field& field : own.fields)
	{
		if (field.values.size > 0 && !field.values.data)
			throw Unusable(fmt::format("the array {} has no memory", field.name));
		vp::grid::Field& made = fields.emplace_back();
		made.name = field.name;
		made.association = static_cast<vp::grid::Association>(field.association);
		made.components = field.components;
		made.type = static_cast<vp::grid::NumberType>(field.values.type);
		made.units = field.units;
		const auto* bytes = static_cast<const std::byte*>(field.values.data);
		const std::size_t count = field.values.size * vp::grid::byteSize(made.type);
		made.bytes = vp::Array<std::byte>(std::vector<std::byte>(bytes, bytes + count));
		vp::read::checkField(made, parts.vertices(), parts.polygons());
	}
	return fields;
}

// Each vertex is a point of its own, and each polygon a cell.
vp::mesh::SheetMesh ownMesh(const OwnParts& parts)
{
	vp::mesh::SheetMesh mesh;
	for (std::size_t v = 0; v < parts.vertices(); ++v)
	{
		const auto point = static_cast<vp::PointId>(v);
		mesh.positions.push_back(vp::grid::loadPoint(&parts.points[3 * v]));
		mesh.edges.push_back({0, point, point, 0.0});
	}
	mesh.polygon_starts.assign(parts.offsets.begin(), parts.offsets.end());
	mesh.polygon_vertices.assign(parts.connectivity.begin(), parts.connectivity.end());
	for (std::size_t p = 0; p < parts.polygons(); ++p)
		mesh.polygon_cells.push_back({0, static_cast<vp::CellId>(p)});
	mesh.flat = false;
	return mesh;
}

// Blocks that such a mesh refers to. Their cells are asked for nothing but their numbers.
std::shared_ptr<const vp::grid::BlockSet> ownBlocks(const OwnParts& parts, std::vector<vp::grid::Field> fields)
{
	constexpr std::uint8_t tetrahedron = 10;
	vp::grid::CellList cells;
	cells.types = std::vector<std::uint8_t>(parts.polygons(), tetrahedron);
	cells.connectivity = vp::Array<std::int64_t>(std::vector<std::int64_t>(4 * parts.polygons(), 0));
	auto blocks = std::make_shared<vp::grid::BlockSet>();
	vp::grid::Block& block = blocks->blocks.emplace_back();
	block.grid = vp::grid::UnstructuredGrid::listed(
	    vp::grid::Points(vp::Array<double>(std::vector<double>(parts.points.begin(), parts.points.end()))),
	    std::move(cells));
	vp::grid::replaceFields(block, std::move(fields));
	return blocks;
}

vp::write::SliceTable ownTable(const OwnParts& parts, const std::vector<vp::grid::Field>& fields, std::size_t sheet)
{
	vp::write::SliceTable table;
	for (std::size_t v = 0; v < parts.vertices(); ++v)
		table.positions.push_back(vp::grid::loadPoint(&parts.points[3 * v]));
	table.polygon_starts.assign(parts.offsets.begin(), parts.offsets.end());
	table.polygon_vertices.assign(parts.connectivity.begin(), parts.connectivity.end());
	table.cell.assign(parts.cells.begin(), parts.cells.end());
	table.block.assign(parts.blocks.begin(), parts.blocks.end());
	table.sheet.assign(parts.polygons(), static_cast<std::int32_t>(sheet));
	for (const vp::grid::Field& field : fields)
	{
		auto& columns =
		    field.association == vp::grid::Association::point ? table.vertex_columns : table.polygon_columns;
		columns.push_back(
		    {field.name, field.components, field.type, {field.bytes.data(), field.bytes.data() + field.bytes.size()}});
	}
	return table;
}

} // namespace

Result<Cut> Cut::withOwn(std::size_t sheet, const View& view, const OwnPolygons& own) const
{
	const auto make = [&]() -> Result<Cut>
	{
		const OwnParts parts = checkedParts(own);
		std::vector<vp::grid::Field> fields = checkedArrays(own, parts);
		auto state = std::make_shared<Cut::State>();
		state->is_own = true;
		state->table = ownTable(parts, fields, sheet);
		auto frame = std::make_shared<vp::session::Frame>();
		vp::cut::SheetCut& shown = frame->slice.sheets.emplace_back(state_->frame->slice.sheets[sheet]);
		shown.records.reset();
		shown.cuts.clear();
		shown.number = ownNumber();
		frame->slice.refined = ownBlocks(parts, std::move(fields));
		vp::session::SheetStats& stats = frame->sheets.emplace_back();
		stats.mesh = ownMesh(parts);
		if (state_->frame->sheets[sheet].crinkle)
			stats.crinkle = stats.mesh; // which is drawn as a surface
		state->blocks = std::make_shared<CutBlocks>(frame->slice.refined);
		state->frame = std::move(frame);
		state->figures.resize(1);
		state->flux_arrays.resize(1);
		state->made_by = state_->made_by;
		state->probe = view.state_->spec.probe;
		return Cut(std::move(state));
	};
	return guarded(
	    [&]() -> Result<Cut>
	    {
		    try
		    {
			    return make();
		    }
		    catch (const Unusable& unusable)
		    {
			    return Error{ErrorKind::input, unusable.what()};
		    }
	    });
}

namespace
{

// An array's values and those of another with its name: the range of both.
vp::grid::Field joined(const vp::grid::Field& a, const vp::grid::Field& b)
{
	std::vector<double> values;
	for (const vp::grid::Field* field : {&a, &b})
		for (std::size_t t = 0; t < field->tuples(); ++t)
			for (int c = 0; c < field->components; ++c)
				values.push_back(field->value(t, c));
	vp::grid::Field both = vp::grid::makeField(a.name, a.association, a.components, std::move(values));
	both.units = a.units;
	return both;
}

// The arrays of a data set with those of a caller's polygons in the first block: settings may name these, and colors
// span the values of both. Nobody interpolates them in the cells of the data set.
std::vector<std::vector<vp::grid::Field>> withOwnArrays(const vp::grid::BlockSet& blocks, const vp::grid::Block& own)
{
	std::vector<std::vector<vp::grid::Field>> all;
	for (const vp::grid::Block& block : blocks.blocks)
		all.push_back(block.fields);
	for (const vp::grid::Field& field : own.fields)
	{
		const auto isSame = [&](const vp::grid::Field& other)
		{ return other.name == field.name && other.association == field.association; };
		const auto known = std::ranges::find_if(all.front(), isSame);
		if (known == all.front().end())
			all.front().push_back(field);
		else
			*known = known->components == field.components ? joined(*known, field) : field;
	}
	return all;
}

vp::Status requireSamePlace(vp::view::ProbeSpec asked, const vp::view::ProbeSpec& made)
{
	asked.array = made.array;
	asked.component = made.component;
	if (asked == made)
		return vp::Nothing{};
	return vp::Error{vp::ErrorKind::usage, "a copy of a slice is drawn where it was cut; give `array`, `component` and "
	                                       "settings of the look alone, or draw the data set"};
}

} // namespace

Result<Image> DatasetState::drawOwn(const Cut& cut, const View& view, const std::stop_token& stop)
{
	const Cut::State& state = *cut.state_;
	if (state.made_by != this)
		return Error{ErrorKind::usage, "a copy of a slice is drawn by the data set that it was cut from"};
	if (vp::Status returned = returnToItsTime(); !returned)
		return publicError(returned.error());
	const vp::grid::Block& own = state.blocks->blocks->blocks.front();
	std::vector<std::vector<vp::grid::Field>> before;
	for (const vp::grid::Block& block : session->blocks().blocks)
		before.push_back(block.fields);
	keepBlocksOfCuts();
	const auto drawn = [&]() -> vp::Result<vp::render::Picture>
	{
		if (vp::Status taken = session->replaceFields(withOwnArrays(session->blocks(), own)); !taken)
			return taken.error();
		if (vp::Status taken = take(view); !taken)
			return taken.error();
		if (vp::Status same = requireSamePlace(session->spec().probe, state.probe); !same)
			return same.error();
		vp::session::Frame frame = *state.frame;
		vp::cut::SheetCut& sheet = frame.slice.sheets.front();
		sheet.number = ownNumber(); // values are kept by it
		sheet.field = session->view().field;
		if (sheet.field && !sheet.field->in(own))
			return vp::Error{vp::ErrorKind::input,
			                 "`array` " + sheet.field->name + ": the copy of the slice has no such array"};
		frame.sheets.front().measure =
		    vp::measure::measure(*frame.slice.refined, frame.sheets.front().mesh, sheet.field);
		if (vp::Status ready = readyPainter(); !ready)
			return ready.error();
		return painter->draw(frame.slice, frame.sheets, {}, stop);
	};
	vp::Result<vp::render::Picture> picture = drawn();
	session->timeline()->takeSections();
	if (vp::Status restored = session->replaceFields(std::move(before)); !restored)
		return publicError(restored.error());
	if (!picture)
		return publicError(afterFailure(picture.error()));
	return Image{picture->width, picture->height, std::move(picture->rgba)};
}

} // namespace vprobe
