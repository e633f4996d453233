// NRRD through teem, whose format it is: VTK 9.1 reads no header with several data files, and no directions.
#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

#include <teem/nrrd.h>

namespace
{

struct NrrdDeleter
{
	void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
};
using NrrdPointer = std::unique_ptr<Nrrd, NrrdDeleter>;

// Of teem's several lines, the last one is the cause.
std::string biffReason()
{
	char* text = biffGetDone(NRRD);
	std::string reason = text ? text : "";
	std::free(text);
	while (!reason.empty() && reason.back() == '\n')
		reason.pop_back();
	if (const auto line = reason.rfind('\n'); line != reason.npos)
		reason.erase(0, line + 1);
	return reason.empty() ? "teem cannot read it" : reason;
}

int vtkTypeOf(int type)
{
	switch (type)
	{
	case nrrdTypeChar:
		return VTK_SIGNED_CHAR;
	case nrrdTypeUChar:
		return VTK_UNSIGNED_CHAR;
	case nrrdTypeShort:
		return VTK_SHORT;
	case nrrdTypeUShort:
		return VTK_UNSIGNED_SHORT;
	case nrrdTypeInt:
		return VTK_INT;
	case nrrdTypeUInt:
		return VTK_UNSIGNED_INT;
	case nrrdTypeLLong:
		return VTK_LONG_LONG;
	case nrrdTypeULLong:
		return VTK_UNSIGNED_LONG_LONG;
	case nrrdTypeFloat:
		return VTK_FLOAT;
	case nrrdTypeDouble:
		return VTK_DOUBLE;
	default:
		throw Refusal("a NRRD file of values of type block, which have no number");
	}
}

// An axis whose direction is "none" is not of space, also where no kind says so.
void markAxesWithoutDirection(Nrrd& nrrd)
{
	for (unsigned i = 0; nrrd.spaceDim == 3 && i < nrrd.dim; ++i)
		if (nrrd.axis[i].kind == nrrdKindUnknown && !std::isfinite(nrrd.axis[i].spaceDirection[0]))
			nrrd.axis[i].kind = nrrdKindList;
}

// The three axes of space behind those of the components, which VTK wants to run fastest.
std::array<unsigned, 3> componentsFirst(NrrdPointer& nrrd)
{
	std::array<unsigned, NRRD_DIM_MAX> domain = {};
	std::array<unsigned, NRRD_DIM_MAX> range = {};
	const unsigned domains = nrrdDomainAxesGet(nrrd.get(), domain.data());
	const unsigned ranges = nrrdRangeAxesGet(nrrd.get(), range.data());
	if (domains < 3)
		throw Refusal("nothing to slice: fewer than three axes of space");
	if (domains > 3)
		throw Refusal(fmt::format("{} axes of space; kinds: in its header say which are not", domains));

	std::array<unsigned, NRRD_DIM_MAX> order = {};
	for (unsigned i = 0; i < nrrd->dim; ++i)
		order[i] = i < ranges ? range[i] : domain[i - ranges];
	if (!std::is_sorted(order.begin(), order.begin() + nrrd->dim))
	{
		NrrdPointer permuted(nrrdNew());
		if (nrrdAxesPermute(permuted.get(), nrrd.get(), order.data()))
			throw damaged(biffReason());
		std::swap(permuted->content, nrrd->content); // teem says there what it did
		nrrd = std::move(permuted);
	}
	return {ranges, ranges + 1, ranges + 2};
}

// Where the first sample is, and the step along each axis: from the directions in space, else from spacings and minima.
void place(const Nrrd& nrrd, const std::array<unsigned, 3>& axes, vtkImageData* image)
{
	std::array<double, 3> origin = {0.0, 0.0, 0.0};
	std::array<double, 3> spacing = {1.0, 1.0, 1.0};
	std::array<double, 9> direction = {1, 0, 0, 0, 1, 0, 0, 0, 1};
	for (int a = 0; a < 3; ++a)
	{
		const NrrdAxisInfo& axis = nrrd.axis[axes[a]];
		if (nrrd.spaceDim == 3 && std::isfinite(axis.spaceDirection[0]))
		{
			const double* step = axis.spaceDirection;
			spacing[a] = std::hypot(step[0], step[1], step[2]);
			for (int row = 0; row < 3; ++row)
				direction[3 * row + a] = step[row] / spacing[a];
			continue;
		}
		const bool in_cells = axis.center == nrrdCenterCell;
		const double gaps = static_cast<double>(axis.size) - (in_cells ? 0 : 1);
		if (std::isfinite(axis.spacing))
			spacing[a] = axis.spacing;
		else if (std::isfinite(axis.min) && std::isfinite(axis.max) && gaps > 0)
			spacing[a] = (axis.max - axis.min) / gaps;
		if (std::isfinite(axis.min))
			origin[a] = axis.min + (in_cells ? 0.5 * spacing[a] : 0.0);
	}
	if (nrrd.spaceDim == 3 && std::isfinite(nrrd.spaceOrigin[0]))
		std::copy_n(nrrd.spaceOrigin, 3, origin.begin());
	for (int i = 0; i < 9; ++i)
		if (!std::isfinite(direction[i]) || !std::isfinite(spacing[i % 3]) || spacing[i % 3] == 0.0)
			throw damaged("its spacings or directions make no grid");
	image->SetOrigin(origin.data());
	image->SetSpacing(spacing.data());
	image->SetDirectionMatrix(direction.data());
}

// Of space, or of the axes; empty where they differ.
std::string lengthUnitsOfAxes(const Nrrd& nrrd, const std::array<unsigned, 3>& axes)
{
	std::array<std::string, 3> units;
	for (unsigned a = 0; a < 3; ++a)
	{
		const bool in_space = nrrd.spaceDim == 3 && std::isfinite(nrrd.axis[axes[a]].spaceDirection[0]);
		const char* of_axis = in_space ? nrrd.spaceUnits[a] : nrrd.axis[axes[a]].units;
		units[a] = of_axis ? of_axis : "";
	}
	return units[0] == units[1] && units[1] == units[2] ? units[0] : "";
}

} // namespace

void readNrrd(const Request& request, ManifestWriter& manifest)
{
	NrrdPointer nrrd(nrrdNew());
	if (nrrdLoad(nrrd.get(), request.file.c_str(), nullptr))
		throw damaged(biffReason());
	if (std::any_of(nrrd->axis, nrrd->axis + nrrd->dim,
	                [](const NrrdAxisInfo& axis) { return std::isfinite(axis.spaceDirection[0]); }))
		markAxesWithoutDirection(*nrrd);
	const std::array<unsigned, 3> axes = componentsFirst(nrrd);

	vtkNew<vtkImageData> image;
	std::array<int, 3> points;
	for (int a = 0; a < 3; ++a)
	{
		if (nrrd->axis[axes[a]].size > 1u << 30)
			throw damaged("an axis of more samples than there can be");
		points[a] = static_cast<int>(nrrd->axis[axes[a]].size);
	}
	image->SetDimensions(points.data());
	place(*nrrd, axes, image);

	const std::size_t samples = nrrdElementNumber(nrrd.get());
	const auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkTypeOf(nrrd->type)));
	values->SetNumberOfComponents(static_cast<int>(samples / static_cast<std::size_t>(image->GetNumberOfPoints())));
	// From now on they belong to the array, which may be kept for longer. teem has them from malloc().
	values->SetVoidArray(std::exchange(nrrd->data, nullptr), static_cast<vtkIdType>(samples), 0,
	                     vtkAbstractArray::VTK_DATA_ARRAY_FREE);
	values->SetName(nrrd->content && *nrrd->content ? nrrd->content : "NRRD");
	image->GetPointData()->SetScalars(values);
	manifest.setLengthUnits(lengthUnitsOfAxes(*nrrd, axes));
	manifest.addLone(image);
}
