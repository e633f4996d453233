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
#include <optional>

namespace
{

// Values at cells, by the number of their name. NaN where the file says nothing.
using FluentValues = std::map<std::int64_t, vtkSmartPointer<vtkDoubleArray>>;

const FluentZone* fluentZoneOf(const FluentCase& mesh, std::int64_t id, std::int64_t first, std::int64_t last)
{
	for (const FluentZone& zone : mesh.zones)
		if (zone.id == id && zone.first <= first && last <= zone.last)
			return &zone;
	return nullptr;
}

// "(300 (NAME ZONE SIZE TIMES PHASES FIRST LAST) (VALUES))", with decimal numbers.
void readFluentValues(const FluentSection& section, FluentSections& sections, const FluentCase& mesh,
                      std::map<std::int64_t, FluentValues>& of_zones)
{
	const std::vector<std::int64_t> head = section.numbers(10);
	if (head.size() < 7)
		throw damaged("values without a place");
	const FluentZone* zone = fluentZoneOf(mesh, head[1], head[5] - 1, head[6] - 1);
	if (!zone || head[5] > head[6]) // of faces, or of another mesh
		return sections.skip(section);
	if (section.body == 0 || head[2] < 1 || head[2] > 64)
		throw damaged(fmt::format("values of {} components", head[2]));
	TextCursor at = sections.bodyOf(section);
	const std::size_t width = !section.is_binary ? 2 : section.number >= 3000 ? 8 : 4;
	const std::size_t count = at.checkedCount((head[6] - head[5] + 1) * head[2], width);
	vtkSmartPointer<vtkDoubleArray>& values = of_zones[zone->id][head[0]];
	if (!values)
	{
		values = vtkSmartPointer<vtkDoubleArray>::New();
		values->SetName(fluentName(head[0]).c_str());
		values->SetNumberOfComponents(static_cast<int>(head[2]));
		values->SetNumberOfTuples(zone->last - zone->first + 1);
		values->Fill(std::numeric_limits<double>::quiet_NaN());
	}
	if (values->GetNumberOfComponents() != head[2])
		throw damaged("values whose number of components changes");
	const vtkIdType first = (head[5] - 1 - zone->first) * head[2];
	for (std::size_t i = 0; i < count; ++i)
		values->SetValue(first + static_cast<vtkIdType>(i), !section.is_binary       ? at.real()
		                                                    : section.number >= 3000 ? at.binary<double>()
		                                                                             : at.binary<float>());
	sections.endBody(section, at);
}

std::map<std::int64_t, FluentValues> parseFluentData(const std::string& file, const FluentCase& mesh)
{
	const MaybeGzip contents(file);
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

void readFluent(const Request& request, ManifestWriter& manifest)
{
	const MaybeGzip file(request.file);
	const FluentCase mesh = parseFluentCase(file.text());
	const std::string data = request.solution.empty() ? fluentDataBeside(request.file) : request.solution;
	std::map<std::int64_t, FluentValues> values;
	if (data.empty())
		manifest.warn("no data file (.dat) lies beside this Fluent case; --solution names one");
	else
		values = parseFluentData(data, mesh);
	for (const FluentZone& zone : mesh.zones)
	{
		const auto grid = fluentGrid(mesh, zone);
		for (const auto& [name, array] : values[zone.id])
			grid->GetCellData()->AddArray(array);
		manifest.setPrefix(zone.name);
		manifest.add(grid);
	}
}
