// Gmsh's meshes by a parser of our own: its library is GPL.
#include "gmsh_data.h"
#include "gmsh_mesh.h"
#include "read/cell_types.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace vp::reader::meshes
{

namespace
{

// More groups than these get no array each.
constexpr std::size_t kMaxGroupArrays = 64;

template <class Array, class Number>
vtkSmartPointer<Array> arrayOf(const std::vector<Number>& numbers, int components = 1)
{
	auto array = vtkSmartPointer<Array>::New();
	array->SetNumberOfComponents(components);
	array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()) / components);
	std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
	return array;
}

void addCells(vtkUnstructuredGrid* grid, const char* name, const std::vector<std::int32_t>& values)
{
	const auto array = arrayOf<vtkIntArray>(values);
	array->SetName(name);
	grid->GetCellData()->AddArray(array);
}

std::string nameOfGroup(const GmshMesh& mesh, int dimension, std::int32_t number)
{
	const auto name = mesh.group_names.find({dimension, number});
	return name == mesh.group_names.end() || name->second.empty() ? std::to_string(number) : name->second;
}

// visit(group) for each physical group of an element.
template <class Visit>
void forEachGroup(const GmshMesh& mesh, std::size_t element, Visit&& visit)
{
	if (mesh.physical[element] != 0)
		visit(mesh.physical[element]);
	if (const auto more = mesh.more_groups.find(static_cast<std::int64_t>(element)); more != mesh.more_groups.end())
		for (const std::int32_t group : more->second)
			visit(group);
}

// Where cells are in several groups, an array for each group of cells: 1 for those in it. Returns how many cells are.
std::size_t addGroups(const GmshMesh& mesh, vtkUnstructuredGrid* grid)
{
	const auto isSolid = [&](std::size_t element) { return read::cellDimension(mesh.types[element]) == 3; };
	const auto shared = std::ranges::count_if(mesh.more_groups, [&](const auto& more)
	                                          { return isSolid(static_cast<std::size_t>(more.first)); });
	if (shared == 0)
		return 0;
	std::set<std::int32_t> groups;
	for (std::size_t e = 0; e < mesh.types.size(); ++e)
		if (isSolid(e))
			forEachGroup(mesh, e, [&](std::int32_t group) { groups.insert(group); });
	if (groups.size() > kMaxGroupArrays)
		return static_cast<std::size_t>(shared);
	for (const std::int32_t group : groups)
	{
		std::vector<std::uint8_t> is_in(mesh.types.size(), 0);
		for (std::size_t e = 0; e < mesh.types.size(); ++e)
			if (isSolid(e))
				forEachGroup(mesh, e, [&](std::int32_t own) { is_in[e] |= own == group; });
		const auto array = arrayOf<vtkUnsignedCharArray>(is_in);
		array->SetName(fmt::format("gmsh:physical:{}", nameOfGroup(mesh, 3, group)).c_str());
		grid->GetCellData()->AddArray(array);
	}
	return static_cast<std::size_t>(shared);
}

// The physical groups of surfaces are the parts of the boundary.
vtkSmartPointer<vtkMultiBlockDataSet> patchesOf(const GmshMesh& mesh, vtkUnstructuredGrid* grid)
{
	std::map<std::string, std::vector<vtkIdType>> faces;
	for (std::size_t e = 0; e < mesh.types.size(); ++e)
		if (read::cellDimension(mesh.types[e]) == 2)
			forEachGroup(mesh, e,
			             [&](std::int32_t group)
			             { faces[nameOfGroup(mesh, 2, group)].push_back(static_cast<vtkIdType>(e)); });
	auto patches = vtkSmartPointer<vtkMultiBlockDataSet>::New();
	unsigned int number = 0;
	vtkNew<vtkIdList> corners;
	for (const auto& [name, cells] : faces)
	{
		vtkNew<vtkUnstructuredGrid> patch;
		patch->SetPoints(grid->GetPoints());
		patch->Allocate(static_cast<vtkIdType>(cells.size()));
		for (const vtkIdType cell : cells)
		{
			grid->GetCellPoints(cell, corners);
			patch->InsertNextCell(grid->GetCellType(cell), corners);
		}
		patches->SetBlock(number, patch);
		patches->GetMetaData(number++)->Set(vtkCompositeDataSet::NAME(), name);
	}
	return patches;
}

vtkSmartPointer<vtkUnstructuredGrid> gridOf(const GmshMesh& mesh)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetData(arrayOf<vtkDoubleArray>(mesh.coordinates, 3));
	grid->SetPoints(points);
	vtkNew<vtkCellArray> cells;
	cells->SetData(arrayOf<vtkIdTypeArray>(mesh.offsets), arrayOf<vtkIdTypeArray>(mesh.corners));
	grid->SetCells(arrayOf<vtkUnsignedCharArray>(mesh.types), cells);
	// The names that meshio gives them too.
	addCells(grid, "gmsh:physical", mesh.physical);
	addCells(grid, "gmsh:geometrical", mesh.entity);
	if (!mesh.partition.empty())
		addCells(grid, "gmsh:partition", mesh.partition);
	if (!mesh.ghost.empty())
	{
		auto ghosts = arrayOf<vtkUnsignedCharArray>(mesh.ghost);
		ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
		for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
			if (ghosts->GetValue(i) != 0)
				ghosts->SetValue(i, vtkDataSetAttributes::DUPLICATECELL);
		grid->GetCellData()->AddArray(ghosts);
	}
	return grid;
}

// NaN where the data say nothing.
template <class IndexOf>
vtkSmartPointer<vtkDoubleArray> valuesOf(const GmshData& data, std::size_t tuples, IndexOf&& indexOf)
{
	const auto components = static_cast<std::size_t>(data.components);
	std::vector<double> values(tuples * components, std::numeric_limits<double>::quiet_NaN());
	for (std::size_t i = 0; i < data.tags.size(); ++i)
	{
		const auto at = indexOf(data.tags[i]);
		if (at < 0)
			continue; // it belongs to an element that is not read, or to a node that no element has
		std::copy_n(data.values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
		            values.begin() + at * data.components);
	}
	auto array = arrayOf<vtkDoubleArray>(values, data.components);
	array->SetName(data.name.c_str());
	return array;
}

} // namespace

void readGmsh(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	GmshMesh mesh = parseGmsh(file.text());
	const auto grid = gridOf(mesh);

	std::vector<double> times = manifest::inOrder(gmshTimes(mesh.data));
	if (times.size() == 1)
		times.clear(); // results without a time have 0
	const std::optional<double> time = manifest::chooseIfAny(times, request);

	std::unordered_map<std::int64_t, std::int64_t> element_of_tag;
	for (std::size_t e = 0; e < mesh.tags.size() && !mesh.data.empty(); ++e)
		element_of_tag.emplace(mesh.tags[e], static_cast<std::int64_t>(e));
	if (!mesh.data.empty())
		element_of_tag.insert(mesh.other_tags.begin(), mesh.other_tags.end());
	for (const GmshView& view : gmshViewsAt(std::move(mesh.data), time))
	{
		const GmshData& data = view.data;
		const auto& index = data.of_nodes ? mesh.point_of_tag : element_of_tag;
		const auto array = valuesOf(data, data.of_nodes ? mesh.coordinates.size() / 3 : mesh.tags.size(),
		                            [&](std::int64_t tag)
		                            {
			                            const auto found = index.find(tag);
			                            return found == index.end() ? std::int64_t(-1) : found->second;
		                            });
		data.of_nodes ? grid->GetPointData()->AddArray(array) : grid->GetCellData()->AddArray(array);
		if (view.is_before)
			manifest.warn(fmt::format("{} is shown at time {}, its first", data.name, data.time));
	}
	if (const std::size_t shared = addGroups(mesh, grid); shared > 0)
		manifest.warn(fmt::format("{} cells are in several physical groups: gmsh:physical has the first, an array "
		                          "gmsh:physical:NAME tells who is in a group",
		                          shared));
	for (const auto& [type, count] : mesh.unknown_types)
		manifest.warn(fmt::format("{} elements of Gmsh type {} are not shown; their order is above 2", count, type));
	if (mesh.has_other_data)
		manifest.warn("data of element nodes are left out");
	manifest.add(grid);
	if (request.patches)
		manifest.addPatches(patchesOf(mesh, grid));
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::meshes
