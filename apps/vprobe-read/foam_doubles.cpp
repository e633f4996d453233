#include "foam_doubles.h"

#include "foam_averages.h"
#include "gzip_text.h"
#include "manifest_writer.h"
#include "refusal.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace
{

// The numbers of a list as an array of so many tuples, if they are those of `single` before rounding; else null.
vtkSmartPointer<vtkDoubleArray> widened(const FoamList& list, vtkDataArray* single)
{
	const vtkIdType tuples = single->GetNumberOfTuples();
	if (list.components != single->GetNumberOfComponents() ||
	    list.size() != (list.is_uniform ? 1 : static_cast<std::size_t>(tuples)))
		return nullptr;
	auto wide = vtkSmartPointer<vtkDoubleArray>::New();
	wide->SetName(single->GetName());
	wide->SetNumberOfComponents(list.components);
	wide->SetNumberOfTuples(tuples);
	double rounded[9], exact[9];
	for (vtkIdType t = 0; t < tuples; ++t)
	{
		single->GetTuple(t, rounded);
		foamTuple(list, static_cast<std::size_t>(t), exact);
		for (int c = 0; c < list.components; ++c)
			if (!roundsToFoam(exact[c], rounded[c], std::abs(exact[c])))
				return nullptr;
		wide->SetTuple(t, exact);
	}
	return wide;
}

void setFoamPoints(vtkPointSet* data, vtkDoubleArray* places)
{
	vtkNew<vtkPoints> points;
	points->SetData(places);
	data->SetPoints(points);
}

class FoamRegion
{
public:
	FoamRegion(const FoamCase& files, std::string name, ManifestWriter& manifest)
	    : files_(files), name_(std::move(name)), manifest_(manifest)
	{
	}

	void widenCells(vtkUnstructuredGrid* grid)
	{
		attempt("the places of its points",
		        [&]
		        {
			        const std::optional<FoamList> places = files_.doublePoints(name_);
			        if (!places)
				        return true;
			        const auto wide = widened(*places, grid->GetPoints()->GetData());
			        if (wide)
				        setFoamPoints(grid, wide);
			        return wide != nullptr;
		        });
		FoamAverages averages(files_, name_, grid);
		std::set<std::pair<bool, std::string>> failed;
		for (const FoamFieldFile& field : files_.fields(name_))
		{
			if (!field.head.isDouble())
				continue;
			const bool is_of_cells = field.head.type.starts_with("vol");
			vtkDataSetAttributes* arrays = grid->GetPointData();
			if (is_of_cells)
				arrays = grid->GetCellData();
			auto* single = vtkFloatArray::SafeDownCast(arrays->GetArray(field.head.object.c_str()));
			if (!single) // not asked for, or done already
				continue;
			const auto key = std::make_pair(is_of_cells, field.head.object);
			try
			{
				const FoamField values = foamField(MaybeGzip(field.path.string()).text());
				const auto wide = widened(values.inside, single);
				if (!wide)
				{
					failed.insert(key); // another file may have that name in its head too
					continue;
				}
				failed.erase(key);
				if (is_of_cells)
					averages.widen(values, wide);
				arrays->AddArray(wide);
			}
			catch (const Refusal&)
			{
				failed.insert(key);
			}
		}
		for (const auto& [is_of_cells, name] : failed)
			tell(fmt::format("the values of {}:{}", is_of_cells ? "cell" : "point", name));
	}

	void widenPatches(vtkMultiBlockDataSet* patches)
	{
		attempt("the places of its patches",
		        [&]
		        {
			        const std::optional<FoamList> places = files_.doublePoints(name_);
			        if (!places)
				        return true;
			        const FoamMesh mesh = files_.mesh(name_, places->size(), std::size_t(-1));
			        bool all = true;
			        for (unsigned int i = 0; i < patches->GetNumberOfBlocks(); ++i)
			        {
				        auto* patch = vtkPolyData::SafeDownCast(patches->GetBlock(i));
				        const char* name = patches->HasMetaData(i)
				                               ? patches->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())
				                               : nullptr;
				        if (patch && patch->GetNumberOfPoints() > 0)
					        all &= name && widenPatch(patch, name, mesh, *places);
			        }
			        return all;
		        });
	}

private:
	// The cells of a patch are its faces in their order, corner by corner.
	static bool widenPatch(vtkPolyData* patch, std::string_view name, const FoamMesh& mesh, const FoamList& places)
	{
		const auto found = std::ranges::find(mesh.patches, name, &FoamPatch::name);
		if (found == mesh.patches.end() || found->faces != patch->GetNumberOfCells())
			return false;
		const auto points = static_cast<std::size_t>(patch->GetNumberOfPoints());
		FoamList own = {3, false, std::vector<double>(3 * points, std::numeric_limits<double>::infinity())};
		for (vtkIdType cell = 0; cell < found->faces; ++cell)
		{
			const auto face = static_cast<std::size_t>(found->first + cell);
			const std::int64_t first = mesh.faces.starts[face];
			vtkIdType count = 0;
			const vtkIdType* corners = nullptr;
			patch->GetCellPoints(cell, count, corners);
			if (count != mesh.faces.starts[face + 1] - first)
				return false;
			for (vtkIdType i = 0; i < count; ++i)
				std::copy_n(
				    places.at(static_cast<std::size_t>(mesh.faces.corners[static_cast<std::size_t>(first + i)])), 3,
				    own.numbers.begin() + 3 * corners[i]);
		}
		const auto wide = widened(own, patch->GetPoints()->GetData());
		if (wide)
			setFoamPoints(patch, wide);
		return wide != nullptr;
	}

	template <class Widen>
	void attempt(const char* what, const Widen& widen)
	{
		try
		{
			if (widen())
				return;
		}
		catch (const Refusal&)
		{
		}
		tell(what);
	}

	void tell(const std::string& what)
	{
		const std::string region = name_.empty() ? "" : fmt::format(" of {}", name_);
		manifest_.warn(fmt::format("{}{} have 7 digits, as they are not written in a usual way", what, region));
	}

	const FoamCase& files_;
	std::string name_;
	ManifestWriter& manifest_;
};

} // namespace

void widenFoam(const FoamCase& files, vtkDataObject* output, ManifestWriter& manifest)
{
	auto* root = vtkMultiBlockDataSet::SafeDownCast(output);
	// Several regions have a block each, one has none.
	const auto widenRegion = [&](vtkMultiBlockDataSet* parts, const std::string& region)
	{
		FoamRegion widener(files, region, manifest);
		for (unsigned int i = 0; i < parts->GetNumberOfBlocks(); ++i)
			if (auto* grid = vtkUnstructuredGrid::SafeDownCast(parts->GetBlock(i)))
				widener.widenCells(grid);
			else if (auto* patches = vtkMultiBlockDataSet::SafeDownCast(parts->GetBlock(i)))
				widener.widenPatches(patches);
	};
	const auto nameOfPart = [&](unsigned int i)
	{
		const char* name = root->HasMetaData(i) ? root->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
		return std::string(name ? name : "");
	};
	bool has_regions = false;
	for (unsigned int i = 0; root && i < root->GetNumberOfBlocks(); ++i)
		has_regions |= nameOfPart(i) != "internalMesh" && nameOfPart(i) != "boundary";
	if (root && !has_regions)
		widenRegion(root, "");
	for (unsigned int i = 0; root && has_regions && i < root->GetNumberOfBlocks(); ++i)
		if (auto* parts = vtkMultiBlockDataSet::SafeDownCast(root->GetBlock(i)))
			widenRegion(parts, nameOfPart(i) == "defaultRegion" ? "" : nameOfPart(i));
}
