#include "requests.h"
#include "parts.h"
#include "run_watched.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace vprobe_paraview
{

namespace
{

// The array that a setting ("point:NAME") means; null where the data set lacks it.
vtkDataArray* arrayOf(vtkDataSet& data, const std::string& setting)
{
	const std::string name = setting.substr(setting.find(':') + 1);
	return setting.starts_with("cell:") ? data.GetCellData()->GetArray(name.c_str())
	                                    : data.GetPointData()->GetArray(name.c_str());
}

double longestVector(vtkDataSet& data, const std::string& setting)
{
	vtkDataArray* array = arrayOf(data, setting);
	if (!array || array->GetNumberOfComponents() != 3)
		return 0.0;
	double range[2];
	array->GetFiniteRange(range, -1);
	return std::isfinite(range[1]) ? range[1] : 0.0;
}

void requireArray(const std::vector<Leaf>& leaves, const std::string& setting)
{
	if (setting.empty() || leaves.empty())
		return;
	if (std::ranges::none_of(leaves, [&](const Leaf& leaf) { return arrayOf(*leaf.data, setting) != nullptr; }))
		throw Refused("the array " + setting.substr(setting.find(':') + 1) + " is missing" +
		              "; choose another, or write it for all parts of the data");
}

} // namespace

void Request::watch(double progress, const std::function<void(std::stop_token)>& work)
{
	const std::vector<std::string> heard = runWatched(filter, progress, work);
	warnings.insert(warnings.end(), heard.begin(), heard.end());
}

Whole Request::whole(const std::vector<Leaf>& leaves)
{
	Whole whole{ranks.count(), {INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY}};
	for (const Leaf& leaf : leaves)
	{
		const double* bounds = leaf.data->GetBounds();
		for (std::size_t a = 0; a < 3; ++a)
		{
			whole.bounds[2 * a] = std::min(whole.bounds[2 * a], bounds[2 * a]);
			whole.bounds[2 * a + 1] = std::max(whole.bounds[2 * a + 1], bounds[2 * a + 1]);
		}
		if (settings.launches() && settings.vector_dt <= 0.0)
			whole.fastest = std::max(whole.fastest, longestVector(*leaf.data, settings.vector_array));
	}
	whole.bounds = ranks.unionOf(whole.bounds);
	whole.fastest = ranks.largest(whole.fastest);
	return whole;
}

vprobe::Cut Request::cut(vtkDataObject& input)
{
	const std::vector<Leaf> leaves = leavesOf(input);
	// Collective, so it comes before anything that may fail on one rank.
	const Whole whole_input = whole(leaves);
	if (leaves.empty())
	{
		grid.forget();
		return {};
	}
	if (settings.needsArray() || settings.drawsLines())
		requireArray(leaves, settings.array);
	if (settings.launches())
		requireArray(leaves, settings.vector_array);
	const vprobe::Result<vprobe::View> view = viewOf(settings, whole_input);
	if (!view)
		throw Refused(view.error().message);
	std::exception_ptr failed;
	vprobe::Cut made;
	watch(0.2,
	      [&](std::stop_token stop)
	      {
		      try
		      {
			      grid.take(leaves, tolerance, stop);
			      if (!grid.data())
				      return;
			      vprobe::Result<vprobe::Cut> cut = grid.cut(*view, stop);
			      if (!cut && cut.error().kind == vprobe::ErrorKind::cancelled)
				      throw Cancelled();
			      if (!cut)
				      throw Refused(cut.error().message);
			      made = std::move(*cut);
		      }
		      catch (...)
		      {
			      failed = std::current_exception();
		      }
	      });
	if (failed)
		std::rethrow_exception(failed);
	return made;
}

namespace
{

void appendTo(vtkSmartPointer<vtkPolyData>& whole, const vtkSmartPointer<vtkPolyData>& part)
{
	if (!whole || whole->GetNumberOfCells() == 0)
	{
		whole = part;
		return;
	}
	if (part->GetNumberOfCells() == 0)
		return;
	vtkNew<vtkAppendPolyData> append;
	append->AddInputData(whole);
	append->AddInputData(part);
	append->Update();
	whole = append->GetOutput();
}

void addPart(vtkMultiBlockDataSet& parts, const std::string& name, vtkPolyData* part)
{
	const unsigned index = parts.GetNumberOfBlocks();
	parts.SetBlock(index, part);
	parts.GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

} // namespace

std::string Request::build(const vprobe::Cut& cut, Parts& parts) const
try
{
	for (std::size_t s = 0; s < cut.sheetCount(); ++s)
		parts.sheets.push_back(polygonsOf(cut.mesh(s), grid));
	for (std::size_t s = 0; settings.drawsLines() && s < parts.sheets.size(); ++s)
		appendTo(parts.lines, contourLines(*parts.sheets[s], settings));
	for (std::size_t c = 0; c < cut.contourCount(); ++c)
		appendTo(parts.contours, polygonsOf(cut.contour(c), grid));
	if (settings.launches())
		parts.paths = pathsOf(cut, grid, settings);
	return {};
}
catch (const std::exception& failure)
{
	return failure.what();
}

void Request::fill(Parts parts, vtkDataObject& output)
{
	std::uint64_t polygons = 0;
	for (const vtkSmartPointer<vtkPolyData>& sheet : parts.sheets)
		polygons += static_cast<std::uint64_t>(sheet->GetNumberOfCells());
	// What one rank lacks, another may have.
	if (ranks.sum(polygons) > 0 && ranks.count() > 1)
		warnings.clear();
	// All ranks have the same parts, some of them empty.
	parts.sheets.resize(static_cast<std::size_t>(ranks.largest(static_cast<double>(parts.sheets.size()))));
	const auto filled = [](const vtkSmartPointer<vtkPolyData>& part)
	{ return part ? part : vtkSmartPointer<vtkPolyData>::New(); };
	auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&output);
	if (!blocks)
	{
		if (!parts.sheets.empty())
			output.ShallowCopy(filled(parts.sheets.front()));
		return;
	}
	for (std::size_t s = 0; s < parts.sheets.size(); ++s)
		addPart(*blocks, "Sheet " + std::to_string(s), filled(parts.sheets[s]));
	if (settings.drawsLines())
		addPart(*blocks, "Contour Lines", filled(parts.lines));
	if (settings.growsContours())
		addPart(*blocks, "Contours", filled(parts.contours));
	if (settings.launches())
		addPart(*blocks, "Vectors", filled(parts.paths));
}

std::string Request::run(vtkDataObject& input, vtkDataObject& output)
{
	std::string error, no_volume;
	vprobe::Cut made;
	try
	{
		made = cut(input);
	}
	catch (const Cancelled&)
	{
	}
	catch (const NoVolume& none)
	{
		no_volume = none.what();
	}
	catch (const std::bad_alloc&)
	{
		error = "out of memory; use more ranks, or a smaller input";
	}
	catch (const std::exception& failure)
	{
		error = failure.what();
	}
	// Surfaces on one rank are no error where another rank has a volume.
	if (ranks.sum(grid.data() ? 1 : 0) == 0 && error.empty())
		error = no_volume;
	const std::string cutting = ranks.first(error);
	Parts parts;
	const std::string filling = ranks.first(build(made, parts));
	fill(std::move(parts), output);
	if (output.GetFieldData() && input.GetFieldData())
		output.GetFieldData()->PassData(input.GetFieldData());
	return cutting.empty() ? filling : cutting;
}

} // namespace vprobe_paraview
