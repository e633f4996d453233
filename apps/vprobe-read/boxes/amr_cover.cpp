#include "amr_cover.h"

#include "vprobe-read/base/refusal.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLDataElement.h>

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <sstream>
#include <string_view>

namespace vp::reader::boxes
{

namespace
{

// Cells that were halved 40 times are smaller than floating point resolves.
constexpr int kMaxLevels = 40;
constexpr int kMaxRatio = 1024;

AmrBox boxOf(vtkXMLDataElement* element, std::size_t number)
{
	AmrBox box = {};
	std::istringstream words(element->GetAttribute("amr_box") ? element->GetAttribute("amr_box") : "");
	for (int axis = 0; axis < 3; ++axis)
		words >> box.lo[axis] >> box.hi[axis];
	box.file = element->GetAttribute("file") ? element->GetAttribute("file") : "";
	box.number = number;
	if (!words || box.file.empty())
		throw damaged("a box has no amr_box of six numbers, or no file");
	return box;
}

AmrLevels readVersion1(vtkXMLDataElement* index)
{
	AmrLevels levels;
	std::vector<double> spacing;
	for (int i = 0; i < index->GetNumberOfNestedElements(); ++i)
	{
		vtkXMLDataElement* block = index->GetNestedElement(i);
		if (std::string_view(block->GetName()) != "Block")
			continue;
		double h = 0.0;
		if (!block->GetScalarAttribute("spacing", h) || !(h > 0.0))
			throw damaged("a level has no spacing");
		spacing.push_back(h);
		levels.boxes.emplace_back();
		for (int d = 0; d < block->GetNumberOfNestedElements(); ++d)
			levels.boxes.back().push_back(boxOf(block->GetNestedElement(d), levels.boxes.back().size()));
	}
	for (std::size_t level = 0; level + 1 < spacing.size(); ++level)
		levels.ratios.push_back(
		    static_cast<int>(std::lround(std::min(spacing[level] / spacing[level + 1], kMaxRatio + 1.0))));
	return levels;
}

AmrLevels readVersion0(vtkXMLDataElement* index)
{
	AmrLevels levels;
	for (int i = 0; i < index->GetNumberOfNestedElements(); ++i)
	{
		vtkXMLDataElement* element = index->GetNestedElement(i);
		const bool is_ratio = std::string_view(element->GetName()) == "RefinementRatio";
		int level = -1;
		if (!element->GetScalarAttribute(is_ratio ? "level" : "group", level) || level < 0 || level >= kMaxLevels)
			throw damaged("a box or a ratio has no level");
		if (is_ratio)
		{
			levels.ratios.resize(std::max<std::size_t>(levels.ratios.size(), level + 1), 1);
			element->GetScalarAttribute("refinement", levels.ratios[level]);
			continue;
		}
		levels.boxes.resize(std::max<std::size_t>(levels.boxes.size(), level + 1));
		levels.boxes[level].push_back(boxOf(element, levels.boxes[level].size()));
	}
	levels.ratios.resize(levels.boxes.empty() ? 0 : levels.boxes.size() - 1, 1);
	return levels;
}

int floorDivided(int value, int by)
{
	return value >= 0 ? value / by : -((-(value + 1)) / by) - 1;
}

} // namespace

AmrLevels readAmrLevels(vtkXMLDataElement* index)
{
	const bool has_blocks = index->FindNestedElementWithName("Block") != nullptr;
	AmrLevels levels = has_blocks ? readVersion1(index) : readVersion0(index);
	for (const int ratio : levels.ratios)
		if (ratio < 1 || ratio > kMaxRatio)
			throw damaged(fmt::format("a refinement ratio of {}", ratio));
	if (levels.boxes.size() > kMaxLevels)
		throw damaged("more levels than can be told apart");
	return levels;
}

bool hasCellsOf(const AmrBox& box, vtkImageData* image)
{
	for (int axis = 0; axis < 3; ++axis)
		if (std::int64_t(box.hi[axis]) - box.lo[axis] + 1 != image->GetDimensions()[axis] - 1)
			return false;
	return true;
}

void markCovered(const AmrLevels& levels, std::size_t level, const AmrBox& box, vtkImageData* image)
{
	vtkCellData* data = image->GetCellData();
	vtkSmartPointer<vtkUnsignedCharArray> marks =
	    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
	std::int64_t ratio = 1;
	for (std::size_t finer = level + 1; finer < levels.boxes.size() && level < levels.ratios.size(); ++finer)
	{
		ratio = std::min<std::int64_t>(ratio * levels.ratios[finer - 1], INT_MAX);
		for (const AmrBox& over : levels.boxes[finer])
		{
			std::array<std::int64_t, 3> lo;
			std::array<std::int64_t, 3> hi;
			bool meets = true;
			for (int axis = 0; axis < 3; ++axis)
			{
				lo[axis] = std::max(box.lo[axis], floorDivided(over.lo[axis], static_cast<int>(ratio)));
				hi[axis] = std::min(box.hi[axis], floorDivided(over.hi[axis], static_cast<int>(ratio)));
				meets = meets && lo[axis] <= hi[axis];
			}
			if (!meets)
				continue;
			if (!marks)
			{
				marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
				marks->SetName(vtkDataSetAttributes::GhostArrayName());
				marks->SetNumberOfValues(image->GetNumberOfCells());
				marks->FillValue(0);
				data->AddArray(marks);
			}
			const std::int64_t nx = box.hi[0] - box.lo[0] + 1;
			const std::int64_t ny = box.hi[1] - box.lo[1] + 1;
			for (std::int64_t k = lo[2] - box.lo[2]; k <= hi[2] - box.lo[2]; ++k)
				for (std::int64_t j = lo[1] - box.lo[1]; j <= hi[1] - box.lo[1]; ++j)
					for (std::int64_t i = lo[0] - box.lo[0]; i <= hi[0] - box.lo[0]; ++i)
					{
						const vtkIdType cell = i + nx * (j + ny * k);
						marks->SetValue(cell, marks->GetValue(cell) | vtkDataSetAttributes::REFINEDCELL);
					}
		}
	}
}

} // namespace vp::reader::boxes
