// Stacks of TIFF pages through libtiff: VTK's readers know neither ImageJ's nor OME's times, and turn pages over.
#include "tiff_volume.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace vp::reader::volumes
{

namespace
{

vtkSmartPointer<vtkDataArray> calibrated(vtkSmartPointer<vtkDataArray> values, const TiffLayout& layout)
{
	if (!layout.value_units.empty())
		values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), layout.value_units.c_str());
	if (layout.slope == 1.0 && layout.intercept == 0.0)
		return values;
	const auto scaled = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_DOUBLE));
	scaled->SetName(values->GetName());
	scaled->SetNumberOfComponents(values->GetNumberOfComponents());
	scaled->SetNumberOfTuples(values->GetNumberOfTuples());
	scaled->CopyInformation(values->GetInformation());
	for (vtkIdType tuple = 0; tuple < values->GetNumberOfTuples(); ++tuple)
		for (int component = 0; component < values->GetNumberOfComponents(); ++component)
			scaled->SetComponent(tuple, component,
			                     layout.intercept + layout.slope * values->GetComponent(tuple, component));
	return scaled;
}

// Returns an array whose values are read, or stay in the file if the request lets them.
vtkSmartPointer<vtkDataArray> arrayOf(TiffVolume& volume, std::uint32_t channel, const Request& request)
{
	const TiffLayout& layout = volume.layout();
	const arrays::ValueLayout values = volume.values();
	const std::string name = layout.channels > 1 ? fmt::format("channel {}", channel) : "values";
	const bool is_as_written = layout.slope == 1.0 && layout.intercept == 0.0;
	if (request.leaves(values.byteCount()) && is_as_written)
		if (std::optional<arrays::StoredPlace> place = volume.storedPlace(channel))
			return arrays::storedArray(values, name, std::move(*place));
	auto array = arrays::emptyArray(values, name);
	char* to = static_cast<char*>(array->GetVoidPointer(0));
	for (std::uint32_t slice = 0; slice < layout.slices; ++slice)
		volume.readPlane(channel, slice, to + slice * (values.byteCount() / layout.slices));
	return array;
}

} // namespace

void readTiff(const Request& request, manifest::Writer& manifest)
{
	TiffVolume volume(request.file);
	const TiffLayout& layout = volume.layout();
	for (const std::vector<std::string>& notes : {volume.leftOut(), layout.notes})
		for (const std::string& note : notes)
			manifest.warn(note);
	manifest::StepsInTime times = manifest::stepsInTime(layout.time_values, manifest);
	manifest::chooseIfAny(times.times, request);
	volume.choose(
	    static_cast<std::uint32_t>(times.times.empty() ? 0 : times.steps[manifest::chooseStep(times.times, request)]));

	vtkSmartPointer<vtkImageData> image;
	for (std::uint32_t channel = 0; channel < layout.channels; ++channel)
	{
		const auto array = calibrated(arrayOf(volume, channel, request), layout);
		if (image)
			image->GetPointData()->AddArray(array);
		else
			image = arrays::imageOf(array, volume.values().points);
	}
	image->SetSpacing(layout.spacing.data());
	image->SetOrigin(layout.origin.data());
	manifest.setLengthUnits(layout.length_units);
	manifest.setTimeUnits(layout.time_units);
	manifest.setImaging({"rows-down", true});
	manifest.addLone(image);
	manifest.offerTimes(std::move(times.times));
}

} // namespace vp::reader::volumes
