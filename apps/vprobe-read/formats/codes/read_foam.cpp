// OpenFOAM by parsers of our own. VTK's reader makes single precision of all numbers, knows few macros, and goes on
// where it does not understand a field.
#include "foam_averages.h"
#include "foam_grid.h"
#include "foam_parts.h"
#include "foam_whole.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vp::reader::codes
{

namespace fs = std::filesystem;

namespace
{

// The mesh of the case, or of one of its regions.
bool hasMesh(const fs::path& folder)
{
	std::error_code none;
	if (fs::is_directory(folder / "constant" / "polyMesh", none))
		return true;
	for (const auto& entry : fs::directory_iterator(folder / "constant", none))
		if (fs::is_directory(entry.path() / "polyMesh", none))
			return true;
	return false;
}

// Whether the parts of processors are shown, put together: they are if they have later times than the case itself, or
// if it has no mesh.
bool showsParts(const FoamParts& parts, const std::vector<FoamTime>& own, bool has_mesh, manifest::Writer& manifest)
{
	if (has_mesh && lastFoamTime(parts.times) <= lastFoamTime(own))
		return false;
	if (parts.missing)
	{
		const std::string lack = fmt::format(
		    "part of processor {} is missing; copy the folders of all processors beside it", *parts.missing);
		if (!has_mesh)
			throw Refusal("its " + lack);
		manifest.warn(fmt::format("its times up to {} lie with its processors and are not shown, since the {}",
		                          parts.times.back().value, lack));
		return false;
	}
	if (parts.places.empty())
		return false;
	if (has_mesh && own.size() > 1)
		manifest.warn(fmt::format("the parts of its {} processors are shown, since they have later times than the case "
		                          "itself; run reconstructPar to see both",
		                          parts.places.size()));
	if (parts.unfinished > 0)
		manifest.warn(fmt::format("left out: {} times that only some of its processors have", parts.unfinished));
	return true;
}

// The files of the case at the time that is asked for. Offers all times.
FoamWhole chosenFiles(const fs::path& folder, const Request& request, manifest::Writer& manifest)
{
	std::vector<FoamTime> all = foamTimes(folder);
	FoamParts parts = foamParts(folder);
	const bool is_decomposed = showsParts(parts, all, hasMesh(folder), manifest);
	if (is_decomposed)
		all = std::move(parts.times);
	std::error_code none;
	if (!is_decomposed && !fs::is_directory(folder / "constant", none))
		throw damaged("constant/ is missing or cannot be opened");
	std::vector<double> times;
	for (const FoamTime& time : all)
		times.push_back(time.value);
	std::vector<std::string> names;
	if (manifest::chooseIfAny(times, request))
		for (std::size_t i = 0; i <= manifest::chooseStep(times, request); ++i)
			names.push_back(all[i].name);
	manifest.offerTimes(std::move(times));
	if (!is_decomposed)
		return FoamWhole(FoamCase(folder, {folder}, std::move(names)));
	std::vector<FoamCase> cases;
	for (FoamPlace& place : parts.places)
		cases.emplace_back(folder, std::move(place), names);
	return {std::move(cases), request.threads};
}

// Reads the fields of a region that are wanted, and remembers why others are left out.
class FoamFields
{
public:
	FoamFields(const FoamWhole& files, const std::string& name, const FoamRegion& region, const ArrayWish& wish,
	           manifest::Writer& manifest)
	    : files_(files), name_(name), region_(region), mesh_(region.mesh), wish_(wish), manifest_(manifest)
	{
	}

	void addTo(vtkUnstructuredGrid* grid)
	{
		std::vector<FoamFieldFile> of_points;
		for (FoamFieldFile& file : files_.fields(name_))
			if (file.head.type.empty())
				left_out_["an empty file"].push_back(file.name);
			else if (foamComponentsOfField(file.head.type) == 0)
				left_out_[fmt::format("a {}, which is of no cells or points", file.head.type)].push_back(file.name);
			else if (file.head.type.starts_with("vol"))
				addOfCells(file, grid);
			else
				of_points.push_back(std::move(file));
		for (const FoamFieldFile& file : of_points)
			addOfPoints(file, grid);
		for (const auto& [reason, names] : left_out_)
			manifest_.warn(fmt::format("left out: {} ({})", fmt::join(names, ", "), reason));
	}

private:
	bool wants(const char* association, const FoamFieldFile& file)
	{
		if (wish_.wants(association, file.name, std::string_view(association) == "point" && !has_shown_))
			return true;
		manifest_.noteLeftOut(manifest::describeLeftOut(association, file.name, grid::NumberType::float64,
		                                                foamComponentsOfField(file.head.type)));
		return false;
	}

	template <class Read>
	void attempt(const std::string& name, const Read& read)
	{
		try
		{
			read();
		}
		catch (const FoamUnknown& unknown)
		{
			left_out_[unknown.what()].push_back(name);
		}
	}

	// Its values at the points have the same name.
	void addOfCells(const FoamFieldFile& file, vtkUnstructuredGrid* grid)
	{
		const bool wants_points = wants("point", file), wants_cells = wants("cell", file);
		if (!wants_points && !wants_cells)
			return;
		attempt(file.name,
		        [&]
		        {
			        const FoamField field = files_.field(file, name_, region_);
			        if (wants_cells)
				        add(foamArray(*field.inside, mesh_.cells, file.head.isDouble()), file, grid->GetCellData());
			        if (wants_points)
				        attempt("point:" + file.name,
				                [&]
				                {
					                add(foamAverages(mesh_, grid, field, file.head.isDouble()), file,
					                    grid->GetPointData());
					                has_shown_ = true;
				                });
		        });
	}

	void addOfPoints(const FoamFieldFile& file, vtkUnstructuredGrid* grid)
	{
		if (grid->GetPointData()->HasArray(file.name.c_str()))
		{
			left_out_["a field of cells has that name too"].push_back(file.name);
			return;
		}
		if (wants("point", file))
			attempt(file.name,
			        [&]
			        {
				        add(foamArray(*files_.field(file, name_, region_).inside, mesh_.points.size(),
				                      file.head.isDouble()),
				            file, grid->GetPointData());
				        has_shown_ = true;
			        });
	}

	static void add(vtkDataArray* array, const FoamFieldFile& file, vtkDataSetAttributes* fields)
	{
		array->SetName(file.name.c_str());
		fields->AddArray(array);
	}

	const FoamWhole& files_;
	const std::string& name_; // that the region has
	const FoamRegion& region_;
	const FoamMesh& mesh_;
	const ArrayWish& wish_;
	manifest::Writer& manifest_;
	std::map<std::string, std::vector<std::string>> left_out_; // by the reason
	bool has_shown_ = false;
};

// Each patch by its name, and each group of patches by its own.
void addFoamPatches(const FoamMesh& mesh, manifest::Writer& manifest)
{
	std::map<std::string, std::vector<const FoamPatch*>> groups;
	std::set<std::string> names;
	vtkNew<vtkMultiBlockDataSet> all;
	const auto add = [&](const std::string& name, std::span<const FoamPatch* const> patches)
	{
		const unsigned int number = all->GetNumberOfBlocks();
		all->SetBlock(number, foamFacesOf(mesh, patches));
		all->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name.c_str());
	};
	for (const FoamPatch& patch : mesh.patches)
	{
		names.insert(patch.name);
		for (const std::string& group : std::set<std::string>(patch.groups.begin(), patch.groups.end()))
			groups[group].push_back(&patch);
		const FoamPatch* one = &patch;
		add(patch.name, {&one, 1});
	}
	for (const auto& [name, patches] : groups)
		if (!names.contains(name))
			add(name, patches);
	manifest.addPatches(all);
}

} // namespace

void readFoam(const Request& request, manifest::Writer& manifest)
{
	fs::path folder = fs::path(request.file).parent_path();
	if (folder.empty())
		folder = ".";
	const FoamWhole files = chosenFiles(folder, request, manifest);
	const std::vector<std::string> names = files.regions();
	if (names.empty())
		throw damaged("no constant/polyMesh with cells beside it");
	for (const std::string& name : names)
	{
		const FoamRegion region = files.region(name);
		const vtkSmartPointer<vtkUnstructuredGrid> grid = foamGrid(region.mesh);
		FoamFields(files, name, region, request.arrays, manifest).addTo(grid);
		manifest.setPrefix(name.empty() ? "internalMesh" : name);
		manifest.add(grid);
		if (request.patches)
			addFoamPatches(region.mesh, manifest);
		if (!region.has_numbers)
			manifest.warn(
			    "its points and cells are numbered one processor after the other, since the numbers that they "
			    "have in the whole (cellProcAddressing, pointProcAddressing) are missing or do not fit");
	}
}

} // namespace vp::reader::codes
