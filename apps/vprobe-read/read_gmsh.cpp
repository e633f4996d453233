// Gmsh's meshes by a parser of our own: its library is GPL.
#include "formats.h"
#include "gmsh_mesh.h"
#include "manifest_writer.h"
#include "mapped_text.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace
{

template <class Array, class Number>
vtkSmartPointer<Array> arrayOf(const std::vector<Number>& numbers, int components = 1)
{
	auto array = vtkSmartPointer<Array>::New();
	array->SetNumberOfComponents(components);
	array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()) / components);
	std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
	return array;
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
	for (const auto& [values, name] :
	     {std::pair{&mesh.physical, "gmsh:physical"}, std::pair{&mesh.entity, "gmsh:geometrical"}})
	{
		const auto array = arrayOf<vtkIntArray>(*values);
		array->SetName(name);
		grid->GetCellData()->AddArray(array);
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
			continue; // of an element that is not read, or of a node that no element has
		std::copy_n(data.values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
		            values.begin() + at * data.components);
	}
	auto array = arrayOf<vtkDoubleArray>(values, data.components);
	array->SetName(data.name.c_str());
	return array;
}

} // namespace

void readGmsh(const Request& request, ManifestWriter& manifest)
{
	const MappedText file(request.file);
	const GmshMesh mesh = parseGmsh(file.text());
	const auto grid = gridOf(mesh);

	std::vector<double> times;
	for (const GmshData& data : mesh.data)
		times.push_back(data.time);
	times = inOrder(std::move(times));
	if (times.size() == 1)
		times.clear(); // results without a time have 0
	const std::optional<double> time = chooseIfAny(times, request);

	std::unordered_map<std::int64_t, std::int64_t> element_of_tag;
	for (std::size_t e = 0; e < mesh.tags.size() && !mesh.data.empty(); ++e)
		element_of_tag.emplace(mesh.tags[e], static_cast<std::int64_t>(e));
	for (const GmshData& data : mesh.data)
	{
		if (time && data.time != *time)
			continue;
		const auto& index = data.of_nodes ? mesh.point_of_tag : element_of_tag;
		const auto array = valuesOf(data, data.of_nodes ? mesh.coordinates.size() / 3 : mesh.tags.size(),
		                            [&](std::int64_t tag)
		                            {
			                            const auto found = index.find(tag);
			                            return found == index.end() ? std::int64_t(-1) : found->second;
		                            });
		data.of_nodes ? grid->GetPointData()->AddArray(array) : grid->GetCellData()->AddArray(array);
	}
	for (const auto& [type, count] : mesh.unknown_types)
		manifest.warn(fmt::format("{} elements of Gmsh type {} are not shown; their order is above 2", count, type));
	if (mesh.has_other_data)
		manifest.warn("data of element nodes are left out");
	manifest.add(grid);
	manifest.offerTimes(std::move(times));
}
