// Fluent's case and data files, by a parser of our own: VTK's makes convex sets of points of polyhedra, and runs past
// the end of files that are cut.
#include "fluent_case.h"
#include "fluent_names.h"
#include "fluent_sections.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/text/gzip_text.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::codes
{

namespace
{

// An array of a zone. NaN where the file says nothing.
struct FluentArray
{
	vtkSmartPointer<vtkDoubleArray> values;
	std::vector<std::pair<vtkIdType, vtkIdType>> parts; // ranges of the zone's cells, first and past last

	bool meets(const std::pair<vtkIdType, vtkIdType>& part) const
	{
		return std::ranges::any_of(parts,
		                           [&](const auto& p) { return part.first < p.second && p.first < part.second; });
	}
	vtkIdType filled() const
	{
		return std::accumulate(parts.begin(), parts.end(), vtkIdType(0),
		                       [](vtkIdType sum, const auto& part) { return sum + part.second - part.first; });
	}
};

// By the number of their name. Several of one name are those of phases, or of steps.
using FluentValues = std::map<std::int64_t, std::vector<FluentArray>>;

const FluentZone* fluentZoneOf(const FluentCase& mesh, std::int64_t id, std::int64_t first, std::int64_t last)
{
	bool is_there = false;
	for (const FluentZone& zone : mesh.zones)
	{
		if (zone.id == id && zone.first <= first && last <= zone.last)
			return &zone;
		is_there = is_there || zone.id == id;
	}
	if (is_there)
		throw damaged(fmt::format("values of the cells {} to {}, which are not in their zone", first + 1, last + 1));
	return nullptr; // a zone of faces, or of cells that were refined
}

// The array that has no values of these cells yet.
FluentArray& fluentArrayFor(std::vector<FluentArray>& all, std::int64_t number, int components, const FluentZone& zone,
                            const std::pair<vtkIdType, vtkIdType>& part)
{
	const auto open = std::ranges::find_if(all, [&](const FluentArray& array) { return !array.meets(part); });
	if (open != all.end())
	{
		if (open->values->GetNumberOfComponents() != components)
			throw damaged("values whose number of components changes");
		return *open;
	}
	FluentArray& array = all.emplace_back();
	array.values = vtkSmartPointer<vtkDoubleArray>::New();
	array.values->SetName(
	    (fluentName(number) + (all.size() > 1 ? fmt::format(" {}", all.size()) : std::string())).c_str());
	array.values->SetNumberOfComponents(components);
	array.values->SetNumberOfTuples(zone.last - zone.first + 1);
	array.values->Fill(std::numeric_limits<double>::quiet_NaN());
	return array;
}

// "(300 (NAME ZONE SIZE TIMES PHASES FIRST LAST) (VALUES))", with decimal numbers.
void readFluentValues(const FluentSection& section, FluentSections& sections, const FluentCase& mesh,
                      std::map<std::int64_t, FluentValues>& of_zones)
{
	const std::vector<std::int64_t> head = section.numbers(10);
	if (head.size() < 7)
		throw damaged("values without a place");
	const FluentZone* zone = head[5] > head[6] ? nullptr : fluentZoneOf(mesh, head[1], head[5] - 1, head[6] - 1);
	if (!zone)
		return sections.skip(section);
	if (section.body == 0 || head[2] < 1 || head[2] > 64)
		throw damaged(fmt::format("values of {} components", head[2]));
	text::Cursor at = sections.bodyOf(section);
	const std::size_t width = !section.is_binary ? 2 : section.number >= 3000 ? 8 : 4;
	const std::size_t count = at.checkedCount((head[6] - head[5] + 1) * head[2], width);
	const std::pair<vtkIdType, vtkIdType> part(head[5] - 1 - zone->first, head[6] - zone->first);
	FluentArray& array = fluentArrayFor(of_zones[zone->id][head[0]], head[0], static_cast<int>(head[2]), *zone, part);
	array.parts.push_back(part);
	const vtkIdType first = part.first * head[2];
	for (std::size_t i = 0; i < count; ++i)
		array.values->SetValue(first + static_cast<vtkIdType>(i), !section.is_binary       ? at.real()
		                                                          : section.number >= 3000 ? at.binary<double>()
		                                                                                   : at.binary<float>());
	sections.endBody(section, at);
}

std::map<std::int64_t, FluentValues> parseFluentData(const std::string& file, const FluentCase& mesh)
{
	const text::MaybeGzip contents(file);
	FluentSections sections(contents.text());
	std::map<std::int64_t, FluentValues> of_zones;
	for (FluentSection section; sections.next(section);)
		if (section.kind() == 300)
			readFluentValues(section, sections, mesh, of_zones);
		else if (section.kind() == 33) // cells, faces and nodes of the mesh
		{
			const std::vector<std::int64_t> sizes = section.numbers(10);
			if (!sizes.empty() && sizes[0] != mesh.cells)
				throw Refusal(fmt::format("{} holds values of {} cells where the case has {}; name the right one with "
				                          "--solution",
				                          file, sizes[0], mesh.cells));
		}
		else
			sections.skip(section);
	return of_zones;
}

// Tells what the arrays lack, and which names occur several times.
void noteFluentValues(const std::map<std::int64_t, FluentValues>& of_zones, const std::string& data,
                      manifest::Writer& manifest)
{
	if (of_zones.empty())
		manifest.warn(fmt::format("{} holds no values at cells", std::filesystem::path(data).filename().string()));
	std::set<std::string> partial, repeated;
	for (const auto& [zone, values] : of_zones)
		for (const auto& [number, arrays] : values)
			for (const FluentArray& array : arrays)
			{
				if (array.filled() < array.values->GetNumberOfTuples())
					partial.insert(array.values->GetName());
				if (&array != &arrays.front())
					repeated.insert(array.values->GetName());
			}
	if (!partial.empty())
		manifest.warn(fmt::format("the data file has values of some cells alone, the others are NaN: {}",
		                          fmt::join(partial, ", ")));
	if (!repeated.empty())
		manifest.warn(fmt::format("the data file has several arrays of one name; the later ones are called {}",
		                          fmt::join(repeated, ", ")));
}

// run.cas has run.dat beside it, or run.dat.gz; so has run.cas.gz. Empty where there is none.
std::string fluentDataBeside(const std::string& file)
{
	namespace fs = std::filesystem;
	const fs::path plain = file.ends_with(".gz") ? fs::path(file).replace_extension("") : fs::path(file);
	for (const char* ending : {".dat", ".dat.gz"})
	{
		const fs::path data = fs::path(plain).replace_extension(ending);
		std::error_code ignored;
		if (data != plain && fs::is_regular_file(data, ignored))
			return data.string();
	}
	return {};
}

} // namespace

void readFluent(const Request& request, manifest::Writer& manifest)
{
	const text::MaybeGzip file(request.file);
	const FluentCase mesh = parseFluentCase(file.text());
	const std::string data = request.solution.empty() ? fluentDataBeside(request.file) : request.solution;
	std::map<std::int64_t, FluentValues> values;
	if (data.empty())
		manifest.warn("no data file (.dat) lies beside this Fluent case; --solution names one");
	else
	{
		values = parseFluentData(data, mesh);
		noteFluentValues(values, data, manifest);
	}
	for (const FluentZone& zone : mesh.zones)
	{
		const auto grid = fluentGrid(mesh, zone);
		for (const auto& [number, arrays] : values[zone.id])
			for (const FluentArray& array : arrays)
				grid->GetCellData()->AddArray(array.values);
		manifest.setPrefix(zone.name);
		manifest.add(grid);
	}
}

} // namespace vp::reader::codes
