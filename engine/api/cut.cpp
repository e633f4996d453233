#include "api/border.h"
#include "api/states.h"
#include "mesh/part_holes.h"
#include "write/set_arrays.h"
#include "write/slice_file.h"

#include <vprobe/cut.h>

#include <algorithm>

namespace vprobe
{

namespace
{

void addArrays(const std::vector<vp::write::Column>& columns, Association association, std::size_t tuples,
               std::vector<MeshArray>& arrays)
{
	for (const vp::write::Column& column : columns)
	{
		MeshArray array;
		array.name = column.name;
		array.association = association;
		array.type = static_cast<NumberType>(column.type);
		array.components = column.components;
		array.data = column.bytes.data();
		array.tuples = tuples;
		arrays.push_back(std::move(array));
	}
}

Vector3 asArray(const vp::Vec3& v)
{
	return {v.x, v.y, v.z};
}

static_assert(sizeof(vp::Vec3) == 3 * sizeof(double));

} // namespace

double MeshArray::value(std::size_t tuple, int component) const
{
	const auto number_type = static_cast<vp::grid::NumberType>(type);
	const auto* bytes = static_cast<const std::byte*>(data);
	const std::size_t number = tuple * static_cast<std::size_t>(components) + static_cast<std::size_t>(component);
	return vp::grid::loadNumber(number_type, bytes + number * vp::grid::byteSize(number_type));
}

namespace
{

const vp::write::SliceTable& withPolygons(const Mesh::State& mesh)
{
	std::call_once(mesh.polygons_once, [&] { vp::write::tabulatePolygons(*mesh.mesh, mesh.table); });
	return mesh.table;
}

// With the blocks' mutex held.
void makeCells(const Mesh::State& mesh)
{
	std::call_once(mesh.cells_once,
	               [&] { vp::write::tabulateCells(*mesh.cut->blocks->blocks, *mesh.mesh, mesh.table); });
}

const vp::write::SliceTable& withCells(const Mesh::State& mesh)
{
	const std::shared_lock lock(mesh.cut->blocks->mutex);
	makeCells(mesh);
	return mesh.table;
}

const std::vector<MeshArray>& withArrays(const Mesh::State& mesh)
{
	std::call_once(mesh.arrays_once,
	               [&]
	               {
		               const std::shared_lock lock(mesh.cut->blocks->mutex);
		               const vp::grid::BlockSet& blocks = *mesh.cut->blocks->blocks;
		               if (!vp::write::arraysOf(blocks, vp::grid::Association::cell).empty())
			               makeCells(mesh);
		               vp::write::tabulateArrays(blocks, *mesh.mesh, mesh.table);
		               addArrays(mesh.table.vertex_columns, Association::point, mesh.mesh->positions.size(),
		                         mesh.arrays);
		               addArrays(mesh.table.polygon_columns, Association::cell, mesh.mesh->polygons(), mesh.arrays);
	               });
	return mesh.arrays;
}

} // namespace

std::size_t Mesh::pointCount() const
{
	return state_->mesh->positions.size();
}

std::size_t Mesh::polygonCount() const
{
	return state_->mesh->polygons();
}

std::span<const double> Mesh::points() const
{
	const auto& positions = state_->mesh->positions;
	return {reinterpret_cast<const double*>(positions.data()), 3 * positions.size()};
}

std::span<const std::int64_t> Mesh::offsets() const
{
	return withPolygons(*state_).polygon_starts;
}

std::span<const std::int64_t> Mesh::connectivity() const
{
	return withPolygons(*state_).polygon_vertices;
}

std::span<const std::int64_t> Mesh::cells() const
{
	return withCells(*state_).cell;
}

std::span<const std::int32_t> Mesh::blocks() const
{
	return withCells(*state_).block;
}

std::span<const MeshArray> Mesh::arrays() const
{
	return withArrays(*state_);
}

const MeshArray* Mesh::array(std::string_view name) const
{
	const std::span<const MeshArray> all = arrays();
	const auto found = std::ranges::find(all, name, &MeshArray::name);
	return found == all.end() ? nullptr : &*found;
}

Cut::Cut() : state_(std::make_shared<State>()) {}

std::size_t Cut::sheetCount() const
{
	return state_->frame->sheets.size();
}

Mesh Cut::mesh(std::size_t sheet) const
{
	const vp::session::SheetStats& stats = state_->frame->sheets[sheet];
	auto mesh = std::make_shared<Mesh::State>();
	mesh->cut = state_;
	mesh->mesh = stats.crinkle ? &*stats.crinkle : &stats.mesh;
	mesh->parted = vp::mesh::partHoles(*mesh->mesh);
	if (mesh->parted)
		mesh->mesh = &*mesh->parted;
	return Mesh(std::move(mesh));
}

namespace
{

const SheetFigures& measured(const Cut::State& cut, std::size_t sheet)
{
	const std::lock_guard lock(cut.measuring);
	std::optional<SheetFigures>& figures = cut.figures[sheet];
	if (!figures)
	{
		const std::shared_lock reading(cut.blocks->mutex);
		const vp::grid::BlockSet& blocks = *cut.blocks->blocks;
		const vp::mesh::SheetMesh& mesh = cut.frame->sheets[sheet].mesh;
		figures = {vp::measure::measure(blocks, mesh, cut.frame->slice.sheets[sheet].field), {}};
		if (const std::optional<vp::grid::FieldChoice>& array = cut.flux_arrays[sheet])
			figures->flux = vp::vectors::fluxThrough(blocks, mesh, *array);
	}
	return *figures;
}

} // namespace

Figures Cut::figures(std::size_t sheet) const
{
	const auto& [measure, flux] = measured(*state_, sheet);
	Figures figures;
	figures.area = measure.area;
	figures.boundary_area = measure.boundary_area;
	figures.nan_area = measure.nan_area;
	figures.mean = measure.mean;
	figures.boundary_mean = measure.boundary_mean;
	figures.min = measure.min;
	figures.max = measure.max;
	figures.components = measure.components;
	if (flux)
	{
		figures.flux = flux->through;
		figures.boundary_flux = flux->boundary;
	}
	for (const vp::find::BlockCut& cut : state_->frame->slice.sheets[sheet].cuts)
		figures.cut_cells += cut.cutCells();
	return figures;
}

Vector3 Cut::origin(std::size_t sheet) const
{
	return asArray(state_->frame->slice.sheets[sheet].shown.origin);
}

Vector3 Cut::normal(std::size_t sheet) const
{
	return asArray(state_->frame->slice.sheets[sheet].shown.normal);
}

Traces Cut::traces(std::size_t sheet) const
{
	const auto& launched = state_->frame->sheets[sheet].traces;
	Traces traces;
	if (!launched)
		return traces;
	traces.offsets.assign(launched->starts.begin(), launched->starts.end());
	traces.times.assign(launched->times.begin(), launched->times.end());
	for (const vp::Vec3& point : launched->points)
		traces.points.insert(traces.points.end(), {point.x, point.y, point.z});
	return traces;
}

std::size_t Cut::contourCount() const
{
	std::size_t count = 0;
	for (const auto& of_sheet : state_->frame->contours)
		count += of_sheet.size();
	return count;
}

namespace
{

const vp::contour::Contour& contourOf(const vp::session::Contours& contours, std::size_t number)
{
	for (const auto& of_sheet : contours)
	{
		if (number < of_sheet.size())
			return of_sheet[number];
		number -= of_sheet.size();
	}
	return contours.back().back();
}

} // namespace

double Cut::contourValue(std::size_t contour) const
{
	return contourOf(state_->frame->contours, contour).value;
}

Mesh Cut::contour(std::size_t contour) const
{
	auto mesh = std::make_shared<Mesh::State>();
	mesh->cut = state_;
	mesh->mesh = &contourOf(state_->frame->contours, contour).mesh;
	return Mesh(std::move(mesh));
}

Status Cut::save(const std::string& file) const
{
	return guarded(
	    [&]() -> Status
	    {
		    if (!state_->blocks)
			    return Error{ErrorKind::usage, file + ": there is no cut to save; make one first"};
		    const vp::Result<vp::write::SliceFormat> format = vp::write::sliceFormatOf(file);
		    if (state_->table && format && *format == vp::write::SliceFormat::vtm)
			    return Error{ErrorKind::usage, file + ": a copy of a slice is one part; use .vtp, .pvtp, .ply or .csv"};
		    if (state_->table)
			    return publicStatus(vp::write::writeTable(*state_->table, file));
		    const std::shared_lock lock(state_->blocks->mutex);
		    return publicStatus(vp::write::writeSlice(*state_->blocks->blocks,
		                                              vp::session::exportedMeshes(state_->frame->sheets), file,
		                                              vp::session::contourPieces(state_->frame->contours)));
	    });
}

} // namespace vprobe
