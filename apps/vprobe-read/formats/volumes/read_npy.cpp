// NumPy's arrays, one (.npy) or several (.npz). They say nothing of places: values are 1 apart.
#include "npy_header.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/base/zip_file.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/own_names.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::reader::volumes
{

namespace
{

// A volume of an archive. Nothing, and `why`, for what others beside it do not need.
std::optional<NpyArray> parseMember(std::string_view bytes, std::string& why)
{
	try
	{
		std::optional<NpyArray> array = parseNpy(bytes);
		const bool is_volume = array && std::ranges::min(array->layout.points) > 1;
		why = array ? "it has no cells" : "not three axes";
		return is_volume ? array : std::nullopt;
	}
	catch (const UnreadNpyType& type)
	{
		why = type.what();
		return std::nullopt;
	}
}

} // namespace

void readNpy(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	const std::optional<NpyArray> array = parseNpy(file.text(), request.is_slice);
	if (!array)
		throw Refusal("nothing to slice: an array without three axes");
	const std::string name = std::filesystem::path(request.file).stem().string();
	manifest.setImaging({"rows-down"});
	manifest.addLone(
	    arrays::imageOf(arrays::arrayInFile(request, file, array->values, array->layout, name), array->layout.points));
}

// Volumes of one shape are arrays of one block.
void readNpz(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	vtkSmartPointer<vtkImageData> image;
	std::array<std::uint32_t, 3> points = {0, 0, 0};
	for (const ZipEntry& entry : zipEntries(file.text()))
	{
		if (!entry.name.ends_with(".npy"))
			continue;
		std::string name = entry.name.substr(0, entry.name.size() - 4);
		const std::string bytes = unpackEntry(entry);
		std::string why;
		const std::optional<NpyArray> array = parseMember(bytes, why);
		if (!array || (image && array->layout.points != points))
		{
			manifest.warn(fmt::format("the array {} is left out: {}", name,
			                          array ? "its shape is not that of the first volume" : why));
			continue;
		}
		if (image)
			name = manifest::ownName(image->GetPointData(), name, manifest);
		const auto values = arrays::arrayOf(array->values, array->layout, name);
		if (image)
			image->GetPointData()->AddArray(values);
		else
			image = arrays::imageOf(values, points = array->layout.points);
	}
	if (!image)
		throw Refusal("nothing to slice: no array with three axes");
	manifest.setImaging({"rows-down"});
	manifest.addLone(image);
}

} // namespace vp::reader::volumes
