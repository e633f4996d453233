// MINC 1 and 2, by a parser of our own: VTK's takes only version 1, and leaves directions out.
#include "minc_volume.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/file_head.h"
#include "vprobe-read/checks/netcdf_size.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

// The values of a volume that has its ranges by slices.
void scaleMinc(MincVolume& volume)
{
	const double width = volume.valid[1] - volume.valid[0];
	if (volume.is_float)
		return;
	const std::size_t slices = volume.least.size();
	if (slices == 0 || slices != volume.greatest.size() || volume.values.size() % slices != 0 || !(width > 0.0))
		throw damaged("the ranges of its values do not match them");
	const std::size_t size = volume.values.size() / slices;
	for (std::size_t i = 0; i < volume.values.size(); ++i)
	{
		const double least = volume.least[i / size], greatest = volume.greatest[i / size];
		volume.values[i] = (volume.values[i] - volume.valid[0]) / width * (greatest - least) + least;
	}
}

bool isMincSpace(const MincAxis& axis)
{
	return axis.name == "xspace" || axis.name == "yspace" || axis.name == "zspace";
}

// Where a value lies in the file, for each step along an axis.
std::size_t mincStepOf(const MincVolume& volume, std::size_t axis)
{
	std::size_t step = 1;
	for (std::size_t later = axis + 1; later < volume.axes.size(); ++later)
		step *= volume.axes[later].count;
	return step;
}

// The image of the axes of space, its fastest axis the last of them; `at`: of the time's first value.
vtkSmartPointer<vtkImageData> mincImage(const MincVolume& volume, std::size_t at)
{
	std::vector<std::size_t> space;
	std::size_t components = 1, component_step = 0;
	for (std::size_t a = 0; a < volume.axes.size(); ++a)
		if (isMincSpace(volume.axes[a]))
			space.insert(space.begin(), a);
		else if (volume.axes[a].name == "vector_dimension")
			components = volume.axes[a].count, component_step = mincStepOf(volume, a);
	if (space.size() != 3)
		throw Refusal("nothing to slice: an image of fewer than three dimensions");
	std::array<int, 3> points;
	std::array<double, 3> spacing, origin = {0.0, 0.0, 0.0};
	std::array<double, 9> direction;
	for (std::size_t i = 0; i < 3; ++i)
	{
		const MincAxis& axis = volume.axes[space[i]];
		points[i] = static_cast<int>(axis.count);
		spacing[i] = std::abs(axis.step);
		const double length = std::hypot(axis.direction[0], axis.direction[1], axis.direction[2]);
		if (!(length > 0.0) || !(spacing[i] > 0.0) || !std::isfinite(axis.start + axis.step))
			throw damaged(fmt::format("{} has no direction or no step", axis.name));
		for (std::size_t row = 0; row < 3; ++row)
		{
			direction[3 * row + i] = axis.direction[row] / length * (axis.step < 0.0 ? -1.0 : 1.0);
			origin[row] += axis.start * axis.direction[row] / length;
		}
	}
	vtkNew<vtkDoubleArray> values;
	values->SetName("MINC");
	values->SetNumberOfComponents(static_cast<int>(components));
	values->SetNumberOfTuples(vtkIdType(points[0]) * points[1] * points[2]);
	vtkIdType next = 0;
	for (int k = 0; k < points[2]; ++k)
		for (int j = 0; j < points[1]; ++j)
			for (int i = 0; i < points[0]; ++i)
				for (std::size_t c = 0; c < components; ++c)
					values->SetValue(
					    next++,
					    volume.values[at + mincStepOf(volume, space[0]) * static_cast<std::size_t>(i) +
					                  mincStepOf(volume, space[1]) * static_cast<std::size_t>(j) +
					                  mincStepOf(volume, space[2]) * static_cast<std::size_t>(k) + component_step * c]);
	auto image = vtkSmartPointer<vtkImageData>::New();
	image->SetDimensions(points.data());
	image->SetSpacing(spacing.data());
	image->SetOrigin(origin.data());
	image->SetDirectionMatrix(direction.data());
	image->GetPointData()->SetScalars(values);
	return image;
}

} // namespace

void readMinc(const Request& request, manifest::Writer& manifest)
{
	const bool is_hdf5 = checks::FileHead(request.file).isHdf5();
	if (!is_hdf5)
		checks::refuseShortNetcdf(request.file);
	MincVolume volume = is_hdf5 ? readMinc2(request.file) : readMinc1(request.file);
	for (const MincAxis& axis : volume.axes)
		if (axis.count == 0 || axis.count > 1 << 20)
			throw damaged(fmt::format("{} has {} places", axis.name, axis.count));
	scaleMinc(volume);
	std::size_t at = 0;
	for (std::size_t a = 0; a < volume.axes.size(); ++a)
		if (const MincAxis& axis = volume.axes[a]; axis.name == "time")
		{
			std::vector<double> times;
			for (std::size_t i = 0; i < axis.count; ++i)
				times.push_back(axis.start + axis.step * static_cast<double>(i));
			manifest.setTimeUnits(axis.units);
			at = mincStepOf(volume, a) * manifest::offerSteps(times, request, manifest).value_or(0);
		}
	const auto axis = std::ranges::find_if(volume.axes, isMincSpace);
	manifest.setLengthUnits(axis == volume.axes.end() ? "" : axis->units);
	manifest.setImaging({"RAS", true});
	manifest.add(mincImage(volume, at));
}

} // namespace vp::reader::volumes
