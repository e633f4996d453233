#include "dicom_form.h"

#include "dicom_item.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

using gdcm::Tag;

// A number of 16 bits that has the sign of the pixels, whatever the type that was written.
double withSign(double number, bool is_signed)
{
	const double positive = number < 0.0 ? number + 65536.0 : number;
	return is_signed && positive >= 32768.0 && positive < 65536.0 ? positive - 65536.0 : positive;
}

void readTable(const DicomItem& root, DicomPixelForm& form)
{
	const auto item = root.item(Tag(0x0028, 0x3000));
	if (!item)
		return;
	const auto about = item->exactly(3, Tag(0x0028, 0x3002));
	if (about.empty())
		throw damaged("its ModalityLUTSequence has no LUTDescriptor");
	const double count = withSign(about[0], false);
	const std::size_t entries = count == 0.0 ? 65536 : static_cast<std::size_t>(std::clamp(count, 1.0, 65536.0));
	const std::string_view bytes = item->bytes(Tag(0x0028, 0x3006));
	const std::size_t width = bytes.size() >= 2 * entries ? 2 : 1;
	if (bytes.size() < entries)
		throw damaged(fmt::format("its ModalityLUTSequence has {} bytes of {} values", bytes.size(), entries));
	std::vector<double> table(entries);
	for (std::size_t i = 0; i < entries; ++i)
	{
		const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
		table[i] = width == 1 ? byte(i) : byte(2 * i) + 256 * byte(2 * i + 1);
	}
	form.table_first = withSign(about[1], form.is_signed);
	form.table = std::make_shared<const std::vector<double>>(std::move(table));
}

void readPadding(const DicomItem& root, DicomPixelForm& form)
{
	const auto value = root.number(Tag(0x0028, 0x0120));
	if (!value || form.is_real || form.allocated > 16)
		return;
	const double first = withSign(*value, form.is_signed);
	const double last = withSign(root.number(Tag(0x0028, 0x0121)).value_or(*value), form.is_signed);
	form.padding = std::minmax(first, last);
}

void refuseColors(const DicomPixelForm& form, const std::string& colors)
{
	const bool is_gray = colors.empty() || colors == "MONOCHROME1" || colors == "MONOCHROME2";
	if (colors == "PALETTE COLOR")
		throw Refusal("pixels that are numbers of colors in a palette (PALETTE COLOR), which have no value");
	if (!is_gray && colors != "RGB")
		throw Refusal(fmt::format("pixels of the color model {}; convert it to RGB, with dcmdjpeg or gdcmconv",
		                          colors.substr(0, 32)));
	if (form.samples != (is_gray ? 1u : 3u))
		throw damaged(
		    fmt::format("its pixels have {} samples, and are {}", form.samples, is_gray ? "gray" : "of colors"));
}

void refuseBits(const DicomPixelForm& form)
{
	const unsigned bits = form.allocated;
	if (form.is_real)
		return;
	if (bits != 1 && bits != 8 && bits != 16 && bits != 32)
		throw Refusal(fmt::format("pixels of {} bits, which are not read; convert it with gdcmconv", bits));
	if (form.stored < 1 || form.stored > bits || form.high_bit >= bits || form.high_bit + 1 < form.stored)
		throw damaged(fmt::format("BitsStored is {} and HighBit {} where {} bits are allocated", form.stored,
		                          form.high_bit, bits));
}

} // namespace

std::pair<double, double> DicomPixelForm::range() const
{
	if (table)
	{
		const auto [low, high] = std::minmax_element(table->begin(), table->end());
		return {*low, *high};
	}
	const double count = std::ldexp(1.0, static_cast<int>(stored));
	return is_signed ? std::pair(-count / 2, count / 2 - 1) : std::pair(0.0, count - 1);
}

DicomPixelForm pixelFormOf(const DicomItem& root)
{
	const auto number = [&](std::uint16_t element, double missing)
	{ return static_cast<unsigned>(std::clamp(root.number(Tag(0x0028, element)).value_or(missing), 0.0, 4e9)); };
	DicomPixelForm form;
	form.samples = number(0x0002, 1);
	form.frames = std::max(1u, number(0x0008, 1));
	form.rows = number(0x0010, 0);
	form.columns = number(0x0011, 0);
	if (form.rows < 1 || form.columns < 1 || form.rows > 65535 || form.columns > 65535)
		throw damaged(fmt::format("it has {} rows and {} columns", form.rows, form.columns));
	form.allocated = number(0x0100, 0);
	// Float pixels have no bits that are stored.
	form.is_real = form.allocated >= 32 && !root.has(Tag(0x0028, 0x0101));
	form.stored = number(0x0101, form.allocated);
	form.high_bit = number(0x0102, form.stored - 1.0);
	form.is_signed = number(0x0103, 0) == 1;
	form.is_by_plane = number(0x0006, 0) == 1 && form.samples > 1;
	refuseColors(form, root.text(Tag(0x0028, 0x0004)));
	refuseBits(form);
	readTable(root, form);
	readPadding(root, form);
	return form;
}

} // namespace vp::reader::volumes
