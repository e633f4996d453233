// MRC and CCP4 maps (MRC2014). By a parser of our own: VTK 9.1 turns only the first row of a big-endian file, takes
// mode 6 for two components, and leaves the order of the axes out.
#include "mrc_header.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/base/half_float.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>

#include <fmt/format.h>

#include <algorithm>

namespace vp::reader::volumes
{

namespace
{

vtkSmartPointer<vtkDataArray> floatsOfHalfs(vtkDataArray* halfs)
{
	auto floats = vtkSmartPointer<vtkFloatArray>::New();
	floats->SetName(halfs->GetName());
	floats->SetNumberOfTuples(halfs->GetNumberOfTuples());
	const auto* from = static_cast<const std::uint16_t*>(halfs->GetVoidPointer(0));
	std::transform(from, from + halfs->GetNumberOfTuples(), floats->GetPointer(0), fromHalf);
	return floats;
}

// The first of two values stands in the lower half of its byte.
std::string unpackedHalfBytes(std::string_view packed, std::uint32_t columns)
{
	const std::size_t row_bytes = columns / 2 + columns % 2;
	std::string values;
	values.reserve(packed.size() / row_bytes * columns);
	for (std::size_t row = 0; row < packed.size(); row += row_bytes)
		for (std::uint32_t column = 0; column < columns; ++column)
		{
			const auto byte = static_cast<unsigned char>(packed[row + column / 2]);
			values += static_cast<char>(column % 2 ? byte >> 4 : byte & 15);
		}
	return values;
}

} // namespace

void readMrc(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	const MrcHeader header(file.text());
	const std::uint64_t bytes = header.bytesOfVolume();
	std::uint64_t all = 0;
	if (__builtin_mul_overflow(bytes, std::uint64_t(header.volumes()), &all))
		throw damaged("it says that it has more values than there can be");
	const std::string_view values = file.text().substr(header.valuesBegin());
	if (values.size() < all)
		throw damaged(fmt::format("{} bytes of values where {} are wanted", values.size(), all));
	std::vector<double> times;
	for (std::uint32_t volume = 0; header.volumes() > 1 && volume < header.volumes(); ++volume)
		times.push_back(volume);
	const auto volume = static_cast<std::uint64_t>(manifest::chooseIfAny(times, request).value_or(0.0));
	std::string unpacked;
	std::string_view wanted = values.substr(volume * bytes, bytes);
	if (header.isPacked())
		wanted = unpacked = unpackedHalfBytes(wanted, header.layout().points[0]);
	const MrcHeader::Place place = header.place();
	vtkNew<vtkMatrix3x3> direction;
	direction->DeepCopy(place.direction.data());
	const bool may_stay = !header.isPacked() && !header.isHalf() && cells::isAxisAligned(direction);
	auto density = may_stay ? arrays::arrayInFile(request, file, wanted, header.layout(), "density")
	                        : arrays::arrayOf(wanted, header.layout(), "density");
	if (header.isHalf())
		density = floatsOfHalfs(density);
	const auto image = arrays::imageOf(density, header.layout().points);
	image->SetSpacing(place.spacing.data());
	image->SetOrigin(place.origin.data());
	image->SetDirectionMatrix(direction);
	manifest.setLengthUnits("Å");
	manifest.setImaging({"", true});
	manifest.addLone(image);
	manifest.offerTimes(std::move(times));
	if (header.volumes() > 1)
		manifest.warn(fmt::format("its {} volumes are shown as times, numbered from 0", header.volumes()));
}

} // namespace vp::reader::volumes
