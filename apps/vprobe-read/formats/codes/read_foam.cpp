// OpenFOAM by parsers of our own. VTK's reader makes single precision of all numbers, knows few macros, and goes on
// where it does not understand a field.
#include "foam_averages.h"
#include "foam_case.h"
#include "foam_grid.h"
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

double lastTime(const std::vector<FoamTime>& times)
{
	return times.empty() ? -1.0 : times.back().value;
}

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

// The parts of a decomposed case lie in processor0, processor1 and so on, or all together in processorsN.
void refuseDecomposed(const fs::path& folder, const std::vector<FoamTime>& times, manifest::Writer& manifest)
{
	double last = -1.0;
	bool is_decomposed = false;
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder, none))
		if (const std::string name = entry.path().filename().string();
		    entry.is_directory() && name.starts_with("processor") && name.find_first_of("0123456789") != name.npos)
		{
			is_decomposed = true;
			last = std::max(last, lastTime(foamTimes(entry.path())));
		}
	if (is_decomposed && !hasMesh(folder))
		throw Refusal("a case that is decomposed among processors, which is not read; run reconstructPar (and "
		              "reconstructParMesh, if that says so) in its folder");
	if (is_decomposed && last > lastTime(times))
		manifest.warn(
		    fmt::format("its times up to {} lie with the processors and are not shown; run reconstructPar", last));
}

// Reads the fields of a region that are wanted, and remembers why others are left out.
class FoamFields
{
public:
	FoamFields(const FoamCase& files, const FoamMesh& mesh, const ArrayWish& wish, manifest::Writer& manifest)
	    : files_(files), mesh_(mesh), wish_(wish), manifest_(manifest)
	{
	}

	void addTo(vtkUnstructuredGrid* grid, const std::string& region)
	{
		std::vector<FoamFieldFile> of_points;
		for (FoamFieldFile& file : files_.fields(region))
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
			        const FoamField field = files_.field(file, mesh_);
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
				        add(foamArray(*files_.field(file, mesh_).inside, mesh_.points.size(), file.head.isDouble()),
				            file, grid->GetPointData());
				        has_shown_ = true;
			        });
	}

	static void add(vtkDataArray* array, const FoamFieldFile& file, vtkDataSetAttributes* fields)
	{
		array->SetName(file.name.c_str());
		fields->AddArray(array);
	}

	const FoamCase& files_;
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
	const std::vector<FoamTime> all = foamTimes(folder);
	refuseDecomposed(folder, all, manifest);
	std::vector<double> times;
	for (const FoamTime& time : all)
		times.push_back(time.value);
	std::vector<std::string> names;
	if (manifest::chooseIfAny(times, request))
		for (std::size_t i = 0; i <= manifest::chooseStep(times, request); ++i)
			names.push_back(all[i].name);
	std::error_code none;
	if (!fs::is_directory(folder / "constant", none))
		throw damaged("constant/ is missing or cannot be opened");
	const FoamCase files(folder, names);
	const std::vector<std::string> regions = files.regions();
	if (regions.empty())
		throw damaged("no constant/polyMesh with cells beside it");
	for (const std::string& region : regions)
	{
		const FoamMesh mesh = files.mesh(region);
		const vtkSmartPointer<vtkUnstructuredGrid> grid = foamGrid(mesh);
		FoamFields(files, mesh, request.arrays, manifest).addTo(grid, region);
		manifest.setPrefix(region.empty() ? "internalMesh" : region);
		manifest.add(grid);
		if (request.patches)
			addFoamPatches(mesh, manifest);
	}
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::codes
