// Images of OME-Zarr and N5: a level of the first one. Time is an axis, and each channel is an array.
#include "read_ome_zarr.h"
#include "n5_image.h"
#include "ome_zarr.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/text/length_units.h"
#include "zarr_array.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <set>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

constexpr std::size_t kMaxChannels = 10'000;

NumberType numberTypeOf(const ZarrType& type, const std::string& name)
{
	switch (type.kind)
	{
	case 'f':
		return type.width == 8 ? NumberType::float64 : NumberType::float32;
	case 'i':
		return type.width == 1   ? NumberType::int8
		       : type.width == 2 ? NumberType::int16
		       : type.width == 4 ? NumberType::int32
		                         : NumberType::int64;
	case 'u':
		return type.width == 1   ? NumberType::uint8
		       : type.width == 2 ? NumberType::uint16
		       : type.width == 4 ? NumberType::uint32
		                         : NumberType::uint64;
	case 'b':
		return NumberType::uint8;
	default:
		throw Refusal(fmt::format("the values of {} are no numbers that are read; write real or whole ones", name));
	}
}

// Spacing and origin of x, y and z in one unit.
void placeImage(const OmeZarr& image, const OmeZarr::Level& level, vtkImageData& data, manifest::Writer& manifest)
{
	std::array<double, 3> spacing{1.0, 1.0, 1.0}, origin{};
	std::array<std::string, 3> units;
	for (std::size_t axis = 0; axis < image.spaceAxes(); ++axis)
	{
		const std::size_t place = image.axes.size() - 1 - axis;
		spacing[axis] = level.scale[place];
		origin[axis] = level.translation[place];
		units[axis] = image.axes[place].unit;
	}
	if (image.spaceAxes() == 2)
		units[2] = units[0];
	const text::OneLengthUnit one = text::oneLengthUnit(units);
	if (one.differ)
		manifest.warn(text::unitsDiffer(units));
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		spacing[axis] *= one.factors[axis];
		origin[axis] *= one.factors[axis];
	}
	data.SetSpacing(spacing.data());
	data.SetOrigin(origin.data());
	manifest.setLengthUnits(one.sign);
}

std::size_t chooseTime(const OmeZarr& image, const ZarrArray& array, const Request& request, manifest::Writer& manifest)
{
	constexpr std::size_t kMaxTimes = 1'000'000;
	const std::optional<std::size_t> axis = image.axisOf("time");
	std::vector<double> times;
	if (axis && array.shape()[*axis] > kMaxTimes)
		throw damaged(fmt::format("its level {} has {} times", array.name(), array.shape()[*axis]));
	if (axis && array.shape()[*axis] > 1)
		for (std::size_t step = 0; step < array.shape()[*axis]; ++step)
			times.push_back(image.levels[0].translation[*axis] +
			                image.levels[0].scale[*axis] * static_cast<double>(step));
	if (axis)
		manifest.setTimeUnits(image.axes[*axis].unit);
	return manifest::offerSteps(times, request, manifest).value_or(0);
}

// Labels where each channel has one of its own.
std::vector<std::string> namesOfChannels(const OmeZarr& image, std::size_t count)
{
	const std::set<std::string> different(image.channels.begin(), image.channels.end());
	if (image.channels.size() == count && different.size() == count && !different.contains(""))
		return image.channels;
	std::vector<std::string> names;
	for (std::size_t channel = 0; channel < count; ++channel)
		names.push_back(count == 1 ? "values" : fmt::format("channel {}", channel));
	return names;
}

vtkSmartPointer<vtkDataArray> arrayAt(const ZarrArray& array, const arrays::ValueLayout& layout,
                                      const std::string& name, const std::vector<std::size_t>& front,
                                      const Request& request)
{
	std::optional<arrays::StoredPlace> place =
	    request.leaves(layout.byteCount()) ? array.storedPlace(front) : std::nullopt;
	if (place)
		return arrays::storedArray(layout, name, std::move(*place));
	std::vector<std::size_t> starts = front, counts(front.size(), 1);
	for (std::size_t side = front.size(); side < array.shape().size(); ++side)
	{
		starts.push_back(0);
		counts.push_back(array.shape()[side]);
	}
	auto values = arrays::emptyArray(layout, name);
	array.read(starts, counts, static_cast<std::byte*>(values->GetVoidPointer(0)));
	return values;
}

} // namespace

void readOmeZarr(const OmeZarr& image, const Request& request, manifest::Writer& manifest)
{
	manifest.offerLevels(image.levels.size());
	manifest.refuseOtherLevel(request.level);
	const OmeZarr::Level& level = image.levels[request.level];
	const std::filesystem::path folder = (std::filesystem::path(request.file) / level.path).lexically_normal();
	const auto about = zarrArrayJson(folder);
	if (!about)
		throw Refusal(fmt::format("its level {} is not there; copy the whole folder", folder.string()));
	const bool is_lone = level.path == "."; // its own folder was named
	ZarrArray array(folder, is_lone ? folder.parent_path().filename().string() : level.path, *about);
	const std::size_t sides = array.shape().size(), space = image.spaceAxes();
	if (sides != image.axes.size())
		throw damaged(fmt::format("its level {} has {} sides and {} axes", array.name(), sides, image.axes.size()));
	array.turn(image.order);
	arrays::ValueLayout layout{{1, 1, 1}, 1, numberTypeOf(array.type(), array.name())};
	for (std::size_t axis = 0; axis < space; ++axis)
		if (const std::size_t side = array.shape()[sides - 1 - axis]; side < std::size_t(1) << 31)
			layout.points[axis] = static_cast<std::uint32_t>(side);
		else
			throw Refusal(fmt::format("its level {} has {} points a side, more than are read", array.name(), side));

	const std::optional<std::size_t> time = image.axisOf("time"), channel = image.axisOf("channel");
	std::vector<std::size_t> front(sides - space, 0);
	if (time)
		front[*time] = chooseTime(image, array, request, manifest);
	for (std::size_t side = 0; side < front.size(); ++side)
		if (side != time && side != channel && array.shape()[side] > 1)
			manifest.warn(fmt::format("of its axis {} the first of {} places is shown", image.axes[side].name,
			                          array.shape()[side]));
	const std::size_t channels = channel ? array.shape()[*channel] : 1;
	if (channels > kMaxChannels)
		throw damaged(fmt::format("its level {} has {} channels", array.name(), channels));
	const std::vector<std::string> names = namesOfChannels(image, channels);
	vtkSmartPointer<vtkImageData> data;
	for (std::size_t i = 0; i < names.size(); ++i)
	{
		if (channel)
			front[*channel] = i;
		const auto values = arrayAt(array, layout, names[i], front, request);
		if (data)
			data->GetPointData()->AddArray(values);
		else
			data = arrays::imageOf(values, layout.points);
	}
	if (!data)
		throw Refusal(fmt::format("its level {} has no values", array.name()));
	placeImage(image, level, *data, manifest);
	if (image.images > 1)
		manifest.warn(fmt::format("it has {} images; the first is shown", image.images));
	grid::Imaging imaging{"rows-down", !image.labels, image.labels};
	if (names.size() == 1)
		imaging.window = image.window;
	manifest.setImaging(imaging);
	manifest.addLone(data);
}

// Its folder may be named, or the file of attributes in it.
void readN5(const Request& request, manifest::Writer& manifest)
{
	Request of_folder = request;
	if (!std::filesystem::is_directory(request.file))
		of_folder.file = std::filesystem::absolute(request.file).parent_path().string();
	readOmeZarr(n5Image(of_folder.file), of_folder, manifest);
}

} // namespace vp::reader::volumes
