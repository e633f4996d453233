#include "pack_faces.h"

#include "vprobe-read/base/refusal.h"

#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <algorithm>

namespace vp::reader::convert
{

PackFaces::PackFaces(vtkUnstructuredGrid* grid)
    : grid_(grid), own_types_(grid->GetCellTypesArray()->GetPointer(0),
                              static_cast<std::size_t>(grid->GetCellTypesArray()->GetNumberOfValues())),
      types_(own_types_)
{
	const auto isPrism = [](std::uint8_t type) { return read::prismSides(type) > 0; };
	if (std::ranges::any_of(own_types_, isPrism))
	{
		types_without_prisms_.assign(own_types_.begin(), own_types_.end());
		std::ranges::replace_if(types_without_prisms_, isPrism, read::kPolyhedron);
		types_ = types_without_prisms_;
	}
	has_polyhedra_ = std::ranges::find(types_, read::kPolyhedron) != types_.end();
}

std::vector<vtkIdType> PackFaces::facesOfPrism(std::size_t cell, vtkIdType sides) const
{
	vtkCellArray* cells = grid_->GetCells();
	const auto number = static_cast<vtkIdType>(cell);
	if (cells->GetCellSize(number) < 2 * sides)
		throw damaged(
		    fmt::format("cell {}, a prism of {} sides, lists {} points", cell, sides, cells->GetCellSize(number)));
	std::vector<vtkIdType> points(static_cast<std::size_t>(2 * sides));
	const auto take = [&](const auto* offsets, const auto* ids)
	{ std::copy_n(ids + offsets[cell], points.size(), points.begin()); };
	if (cells->IsStorage64Bit())
		take(cells->GetOffsetsArray64()->GetPointer(0), cells->GetConnectivityArray64()->GetPointer(0));
	else
		take(cells->GetOffsetsArray32()->GetPointer(0), cells->GetConnectivityArray32()->GetPointer(0));
	return read::prismFaces(std::span<const vtkIdType>(points));
}

} // namespace vp::reader::convert
