// MetaImage by a parser of our own: VTK 9.1's reader takes longs for 8 bytes, knows none of 8, crashes over four
// dimensions, drops directions and signs, and shows zeros where packed data cannot be unpacked.
#include "meta_header.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/arrays/text_values.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/text/length_units.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

NumberType typeOfMeta(std::string_view type)
{
	constexpr std::pair<std::string_view, NumberType> types[] = {
	    {"MET_CHAR", NumberType::int8},         {"MET_ASCII_CHAR", NumberType::int8},
	    {"MET_UCHAR", NumberType::uint8},       {"MET_SHORT", NumberType::int16},
	    {"MET_USHORT", NumberType::uint16},     {"MET_INT", NumberType::int32},
	    {"MET_UINT", NumberType::uint32},       {"MET_LONG", NumberType::int32},
	    {"MET_ULONG", NumberType::uint32},      {"MET_LONG_LONG", NumberType::int64},
	    {"MET_ULONG_LONG", NumberType::uint64}, {"MET_FLOAT", NumberType::float32},
	    {"MET_DOUBLE", NumberType::float64}};
	for (const auto& [name, number] : types)
		if (name == type)
			return number;
	throw damaged("its ElementType is unknown");
}

double metaNumber(const std::vector<double>& values, std::size_t axis, double otherwise)
{
	return axis < values.size() ? values[axis] : otherwise;
}

manifest::StepsInTime timesOfMeta(const MetaHeader& header, manifest::Writer& manifest)
{
	constexpr std::uint64_t most = 1 << 24;
	std::vector<double> times;
	if (header.times() > most)
		throw damaged("it has more times than there can be");
	for (std::uint64_t t = 0; header.times() > 1 && t < header.times(); ++t)
		times.push_back(metaNumber(header.offset, 3, 0.0) +
		                static_cast<double>(t) * metaNumber(header.spacing, 3, 1.0));
	return manifest::stepsInTime(times, manifest);
}

void placeMeta(const MetaHeader& header, vtkImageData* image, manifest::Writer& manifest)
{
	image->SetOrigin(metaNumber(header.offset, 0, 0.0), metaNumber(header.offset, 1, 0.0),
	                 metaNumber(header.offset, 2, 0.0));
	image->SetSpacing(metaNumber(header.spacing, 0, 1.0), metaNumber(header.spacing, 1, 1.0),
	                  metaNumber(header.spacing, 2, 1.0));
	const auto& d = header.direction;
	const double volume =
	    d[0] * (d[4] * d[8] - d[5] * d[7]) - d[1] * (d[3] * d[8] - d[5] * d[6]) + d[2] * (d[3] * d[7] - d[4] * d[6]);
	if (volume == 0.0)
		throw damaged("its TransformMatrix makes no grid");
	image->SetDirectionMatrix(d.data());
	manifest.setLengthUnits(text::lengthSign(header.units));
	// Where the header tells of a patient, the coordinates are ITK's: x to the left, y to the back, z to the head.
	const bool is_patient = header.orientation.find_first_of("LRAPSI") != std::string::npos;
	manifest.setImaging({is_patient ? "LPS" : "", true});
}

vtkSmartPointer<vtkDataArray> valuesOf(const Request& request, const MetaHeader& header,
                                       const arrays::ValueLayout& layout, std::size_t step)
{
	vtkNew<vtkMatrix3x3> direction;
	direction->DeepCopy(header.direction.data());
	if (request.leaves(layout.byteCount()) && layout.byteCount() == header.volumeBytes() &&
	    cells::isAxisAligned(direction))
		if (const std::optional<MetaPlace> place = metaPlace(request.file, header, step))
			return arrays::storedArray(layout, "MetaImage", arrays::storedRows(place->file, place->offset, layout));
	const std::string bytes = metaBytes(request.file, header, step);
	return header.is_text ? arrays::arrayOfText(bytes, layout, step, header.times(), "MetaImage")
	                      : arrays::arrayOf(bytes, layout, "MetaImage");
}

} // namespace

void readMetaImage(const Request& request, manifest::Writer& manifest)
{
	MetaHeader header = readMetaHeader(request.file);
	if (header.is_picture && !request.is_slice)
		throw Refusal("nothing to slice: a picture of two dimensions");
	makeSpacingPositive(header);
	arrays::ValueLayout layout;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (header.size[axis] > std::numeric_limits<std::int32_t>::max())
			throw damaged("its DimSize cannot be");
		layout.points[axis] = static_cast<std::uint32_t>(header.size[axis]);
	}
	layout.components = static_cast<std::uint32_t>(header.channels);
	layout.type = typeOfMeta(header.type);
	layout.is_big_endian = header.is_big_endian;
	manifest::StepsInTime times = timesOfMeta(header, manifest);
	manifest::chooseIfAny(times.times, request);
	const std::size_t step = times.times.empty() ? 0 : times.steps[manifest::chooseStep(times.times, request)];

	const auto values = valuesOf(request, header, layout, step);
	const auto image = arrays::imageOf(values, layout.points);
	placeMeta(header, image, manifest);
	if (header.has_scale)
		manifest.warn("its ElementToIntensityFunction is not applied to the values, as in ITK");
	manifest.addLone(image);
	manifest.offerTimes(std::move(times.times));
}

} // namespace vp::reader::volumes
