#include "cell_boxes.h"

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::boxes
{

vtkSmartPointer<vtkImageData> imageOfBox(const CellBox& box)
{
	constexpr std::size_t most = 1 << 20; // along an axis
	std::array<int, 3> points;
	std::array<double, 3> spacing;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (box.cells[axis] < 1 || box.cells[axis] > most)
			throw damaged(fmt::format("a box of {} cells along an axis", box.cells[axis]));
		points[axis] = static_cast<int>(box.cells[axis]) + 1;
		spacing[axis] = (box.hi[axis] - box.lo[axis]) / static_cast<double>(box.cells[axis]);
		if (!(spacing[axis] > 0.0) || !std::isfinite(spacing[axis]) || !std::isfinite(box.lo[axis]))
			throw damaged(fmt::format("a box from {} to {}", box.lo[axis], box.hi[axis]));
	}
	auto image = vtkSmartPointer<vtkImageData>::New();
	image->SetDimensions(points.data());
	image->SetOrigin(box.lo.data());
	image->SetSpacing(spacing.data());
	return image;
}

void addCellArray(vtkDataSet* data, const std::string& name, std::span<const double> values)
{
	const auto cells = static_cast<std::size_t>(data->GetNumberOfCells());
	const std::size_t components = cells > 0 ? values.size() / cells : 0;
	if (components < 1 || components > 64 || components * cells != values.size())
		throw damaged(fmt::format("{} has {} values for {} cells", name, values.size(), cells));
	vtkNew<vtkDoubleArray> array;
	array->SetName(name.c_str());
	array->SetNumberOfComponents(static_cast<int>(components));
	array->SetNumberOfTuples(static_cast<vtkIdType>(cells));
	std::copy(values.begin(), values.end(), array->GetPointer(0));
	data->GetCellData()->AddArray(array);
}

CellArrayChoice::CellArrayChoice(const Request& request, const std::vector<CellArrayName>& arrays)
{
	for (const CellArrayName& array : arrays)
		if (request.arrays.wants("cell", array.name, &array == arrays.data()))
			wanted_.push_back(array.name);
		else
			left_out_.push_back(array);
}

void CellArrayChoice::noteLeftOut(manifest::Writer& manifest) const
{
	for (const CellArrayName& array : left_out_)
		manifest.noteLeftOut(
		    manifest::describeLeftOut("cell", array.name, grid::NumberType::float64, array.components));
}

void offerOnlyTime(double time, const Request& request, manifest::Writer& manifest)
{
	std::vector<double> times = manifest::inOrder({time});
	manifest::chooseIfAny(times, request);
	manifest.offerTimes(std::move(times));
}

} // namespace vp::reader::boxes
