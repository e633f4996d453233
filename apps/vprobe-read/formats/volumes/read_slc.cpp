// Volumes of VolVis, by a parser of our own: VTK's writes past its arrays where a plane unpacks to too many values.
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

// By their numbers in the header.
constexpr std::array<const char*, 5> kSlcUnits = {"m", "mm", "µm", "ft", "in"};

// Runs of values: a byte whose upper bit says whether so many values follow, or one that is repeated; 0 ends a plane.
void unpackSlcPlane(std::string_view packed, std::uint64_t wanted, std::string& values)
{
	const std::size_t end = values.size() + wanted;
	while (!packed.empty())
	{
		const auto head = static_cast<unsigned char>(packed[0]);
		const std::size_t count = head & 0x7F;
		packed.remove_prefix(1);
		if (count == 0)
			break;
		const std::size_t taken = head & 0x80 ? count : 1;
		if (packed.size() < taken || end - values.size() < count)
			throw damaged("a plane unpacks to another number of values");
		if (head & 0x80)
			values += packed.substr(0, count);
		else
			values.append(count, packed[0]);
		packed.remove_prefix(taken);
	}
	if (values.size() != end)
		throw damaged("a plane unpacks to too few values");
}

// "NUMBER X", and the byte after the X.
std::string_view takeSlcBytes(text::Cursor& at, std::string_view file, std::int64_t count)
{
	const std::size_t start = at.place();
	if (count < 0 || static_cast<std::uint64_t>(count) > file.size() - start)
		at.endsEarly();
	at.moveTo(start + static_cast<std::size_t>(count));
	return file.substr(start, static_cast<std::size_t>(count));
}

void passSlcMark(text::Cursor& at, std::string_view file)
{
	while (at.place() < file.size() && (file[at.place()] == ' ' || file[at.place()] == '\n'))
		at.moveTo(at.place() + 1);
	if (takeSlcBytes(at, file, 1) != "X")
		throw damaged("no X where its values should begin");
}

} // namespace

void readSlc(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	text::Cursor at(file.text());
	at.integer(); // 11111
	arrays::ValueLayout layout;
	for (std::uint32_t& side : layout.points)
	{
		const std::int64_t points = at.integer();
		if (points < 1 || points > 1 << 20)
			throw damaged("its size cannot be");
		side = static_cast<std::uint32_t>(points);
	}
	if (const std::int64_t bits = at.integer(); bits != 8)
		throw Refusal(fmt::format("values of {} bits; only those of 8 bits are read", bits));
	std::array<double, 3> spacing;
	for (double& length : spacing)
		if (length = at.real(); !(length > 0.0) || !std::isfinite(length))
			throw damaged("its voxels have no size");
	const std::int64_t units = at.integer();
	at.integer(); // where it comes from
	at.integer(); // how it was changed
	const std::int64_t compression = at.integer();
	if (compression != 0 && compression != 1)
		throw Refusal(fmt::format("values packed in way {}, which is not read", compression));
	const std::int64_t width = at.integer();
	const std::int64_t height = at.integer();
	if (width < 0 || height < 0 || width > 1 << 16 || height > 1 << 16)
		throw damaged("its icon has a size that cannot be");
	passSlcMark(at, file.text());
	takeSlcBytes(at, file.text(), 3 * width * height); // the icon: red, green, blue

	const std::uint64_t plane = layout.byteCount() / layout.points[2];
	// A byte that is repeated 127 times takes two.
	if (layout.byteCount() / 64 > file.text().size())
		throw damaged("it has fewer bytes than its values need");
	std::string values;
	values.reserve(layout.byteCount());
	for (std::uint32_t k = 0; k < layout.points[2]; ++k)
		if (compression == 0)
			values += takeSlcBytes(at, file.text(), static_cast<std::int64_t>(plane));
		else
		{
			const std::int64_t bytes = at.integer();
			passSlcMark(at, file.text());
			unpackSlcPlane(takeSlcBytes(at, file.text(), bytes), plane, values);
		}
	const auto image = arrays::imageOf(arrays::arrayOf(values, layout, "SLCImage"), layout.points);
	image->SetSpacing(spacing.data());
	if (units >= 0 && units < static_cast<std::int64_t>(kSlcUnits.size()))
		manifest.setLengthUnits(kSlcUnits[static_cast<std::size_t>(units)]);
	manifest.addLone(image);
}

} // namespace vp::reader::volumes
