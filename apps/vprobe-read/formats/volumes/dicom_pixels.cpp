#include "dicom_pixels.h"

#include "dicom_item.h"
#include "jpeg2000_parts.h"
#include "parts/part_bytes.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/printed_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace vp::reader::volumes
{

namespace
{

using gdcm::Tag;

const Tag kPixelData(0x7fe0, 0x0010);

// GDCM makes up the rest of pixels that a file does not have. Pixels have a length of their own, or end with a mark.
void refuseShortPixels(const std::string& file, const std::string& name)
{
	constexpr std::string_view tag("\xE0\x7F\x10\x00", 4);
	constexpr std::string_view end_mark("\xFE\xFF\xDD\xE0", 4);
	const MappedText mapped(file);
	const std::string_view text = mapped.text();
	for (std::size_t at = text.find(tag, 132); at != text.npos; at = text.find(tag, at))
	{
		at += tag.size();
		const std::string_view type = text.substr(at, 2);
		if (type == "OW" || type == "OB" || type == "UN")
			at += 4;
		std::uint32_t length = 0;
		if (text.size() - at >= sizeof length)
			length = numberAt<std::uint32_t>(text.data() + at);
		at = std::min(at + sizeof length, text.size());
		const bool has_mark = length == ~std::uint32_t(0);
		const std::size_t end = has_mark ? text.find(end_mark, at) : at + length;
		if (end == text.npos || length == 0 || end > text.size())
			throw damaged(fmt::format("{} ends within its pixels", name));
		at = end;
	}
}

// GDCM has turned round each pair of bytes of type OW, whatever the width of the values.
std::string inOwnOrder(std::string_view given, unsigned bits, bool in_pairs)
{
	std::string bytes(given);
	if (bits <= 8)
		return bytes;
	const auto numbers = std::as_writable_bytes(std::span(bytes));
	if (in_pairs)
		parts::swapNumbers(numbers, 2); // back
	parts::swapNumbers(numbers, bits == 16 ? 2 : bits == 32 ? 4 : 8);
	return bytes;
}

// Only the bits that belong to the value, with its sign.
template <class Stored>
std::vector<double> fromBits(std::string_view bytes, const DicomPixelForm& form)
{
	std::vector<double> values(bytes.size() / sizeof(Stored));
	const unsigned shift = form.high_bit + 1 - form.stored;
	const std::uint32_t mask = form.stored == 32 ? ~std::uint32_t(0) : (std::uint32_t(1) << form.stored) - 1;
	const std::int64_t sign = form.is_signed ? std::int64_t(1) << (form.stored - 1) : 0;
	for (std::size_t i = 0; i < values.size(); ++i)
	{
		const auto word = numberAt<Stored>(bytes.data() + i * sizeof(Stored));
		const std::int64_t value = (std::uint32_t(word) >> shift) & mask;
		values[i] = static_cast<double>((value ^ sign) - sign);
	}
	return values;
}

std::vector<double> interleaved(const std::vector<double>& planes, std::size_t samples)
{
	std::vector<double> values(planes.size());
	const std::size_t pixels = planes.size() / samples;
	for (std::size_t s = 0; s < samples; ++s)
		for (std::size_t p = 0; p < pixels; ++p)
			values[p * samples + s] = planes[s * pixels + p];
	return values;
}

std::vector<double> ofOneBit(std::string_view bytes, std::size_t first, std::size_t count)
{
	std::vector<double> values(count);
	for (std::size_t i = 0; i < count; ++i)
		values[i] = (static_cast<unsigned char>(bytes[(first + i) / 8]) >> ((first + i) % 8)) & 1;
	return values;
}

gdcm::TransferSyntax syntaxOf(const gdcm::Reader& reader)
{
	return reader.GetFile().GetHeader().GetDataSetTransferSyntax();
}

} // namespace

DicomPixels::DicomPixels(const std::string& file) : name_(std::filesystem::path(file).filename().string())
{
	reader_.SetFileName(file.c_str());
	if (!reader_.Read())
		throw damaged(fmt::format("GDCM cannot read {}", name_));
	if (syntaxOf(reader_) != gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian)
		refuseShortPixels(file, name_);
	form_ = pixelFormOf(DicomItem(reader_.GetFile().GetDataSet()));
	findPixels();
	if (packed_)
	{
		findFragments();
		return;
	}
	const std::size_t bits = form_.valuesOfFrame() * form_.allocated; // in each of at most 2^32 frames
	if (bits / 8 > plain_.size() || (bits * form_.frames + 7) / 8 > plain_.size())
		throw damaged(fmt::format("{} has {} bytes of pixels where {} are wanted", name_, plain_.size(),
		                          (bits * form_.frames + 7) / 8));
}

void DicomPixels::findPixels()
{
	const DicomItem root(reader_.GetFile().GetDataSet());
	const Tag reals(0x7fe0, form_.allocated == 32 ? 0x0008 : 0x0009);
	if (!root.data().FindDataElement(form_.is_real ? reals : kPixelData))
		throw damaged(fmt::format("{} has no pixels", name_));
	if (form_.is_real)
	{
		plain_ = root.bytes(reals); // GDCM turns them round by their type
		return;
	}
	const gdcm::DataElement& element = root.data().GetDataElement(kPixelData);
	plain_ = root.bytes(kPixelData);
	packed_ = element.GetSequenceOfFragments();
	const gdcm::TransferSyntax syntax = syntaxOf(reader_);
	if (!packed_ && (syntax == gdcm::TransferSyntax::ExplicitVRBigEndian ||
	                 syntax == gdcm::TransferSyntax::ImplicitVRBigEndianPrivateGE))
	{
		swapped_ = inOwnOrder(plain_, form_.allocated, element.GetVR() == gdcm::VR::OW);
		plain_ = swapped_;
	}
	if (!packed_)
		return;
	if (form_.allocated == 1 || form_.is_by_plane || form_.high_bit + 1 != form_.stored)
		throw Refusal(form_.is_by_plane ? "packed pixels with a plane for each color; convert it with gdcmconv --raw"
		                                : "packed pixels whose bits are not the lowest ones; convert it with "
		                                  "gdcmconv --raw");
}

// A frame is one fragment, or it is told by the table of offsets, or by the end marks of JPEG.
void DicomPixels::findFragments()
{
	const std::size_t count = packed_->GetNumberOfFragments();
	const std::size_t frames = form_.frames;
	if (count < frames)
		throw damaged(fmt::format("{} has {} packed frames where {} are wanted", name_, count, frames));
	if (count == frames || frames == 1)
	{
		for (std::size_t f = 0; f < frames; ++f)
			of_frame_.emplace_back(f, frames == 1 ? count : f + 1);
		return;
	}
	const gdcm::ByteValue* table = packed_->GetTable().GetByteValue();
	std::vector<double> offsets;
	if (table)
		offsets = numbersInBytes<std::uint32_t>({table->GetPointer(), table->GetLength()});
	double offset = 0.0;
	std::size_t begin = 0;
	for (std::size_t i = 0; i < count; ++i)
	{
		const gdcm::ByteValue* bytes = packed_->GetFragment(i).GetByteValue();
		if (!bytes)
			throw damaged(fmt::format("{} has an empty piece of pixels", name_));
		const std::string_view text(bytes->GetPointer(), bytes->GetLength());
		offset += 8.0 + static_cast<double>(text.size());
		const std::size_t next = of_frame_.size() + 1;
		const auto last = text.find_last_not_of('\0');
		const bool is_end = offsets.size() == frames
		                        ? next == frames ? i + 1 == count : offset == offsets[next]
		                        : last != text.npos && last > 0 && text.substr(last - 1, 2) == "\xFF\xD9";
		if (!is_end)
			continue;
		of_frame_.emplace_back(begin, i + 1);
		begin = i + 1;
	}
	if (of_frame_.size() != frames || begin != count)
		throw damaged(fmt::format("{} has {} packed pieces that do not make {} frames", name_, count, frames));
}

std::string DicomPixels::packedBytes(std::size_t index) const
{
	std::string all;
	for (std::size_t i = of_frame_[index].first; i < of_frame_[index].second; ++i)
		if (const gdcm::ByteValue* bytes = packed_->GetFragment(i).GetByteValue())
			all.append(bytes->GetPointer(), bytes->GetLength());
	return all;
}

// Returns false if a part is missing, which GDCM makes up without a word. Without the mark of the end it may search in
// JPEG forever.
bool DicomPixels::isWhole(std::size_t index) const
{
	constexpr std::size_t kMaxBehind = 64; // bytes that some writers add
	const gdcm::TransferSyntax syntax = syntaxOf(reader_);
	if (syntax == gdcm::TransferSyntax::JPEG2000Lossless || syntax == gdcm::TransferSyntax::JPEG2000)
		return isWholeJpeg2000(packedBytes(index), form_.columns, form_.rows, form_.samples);
	if (syntax < gdcm::TransferSyntax::JPEGBaselineProcess1 || syntax > gdcm::TransferSyntax::JPEGLSNearLossless)
		return true;
	const std::string bytes = packedBytes(index);
	const auto mark = bytes.rfind("\xFF\xD9");
	return mark != bytes.npos && bytes.size() - mark <= kMaxBehind;
}

std::string DicomPixels::unpacked(std::size_t index) const
{
	gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
	for (std::size_t i = of_frame_[index].first; i < of_frame_[index].second; ++i)
		fragments->AddFragment(packed_->GetFragment(i));
	gdcm::DataElement element(kPixelData);
	element.SetVR(gdcm::VR::OB);
	element.SetValue(*fragments);

	gdcm::Image image;
	image.SetTransferSyntax(syntaxOf(reader_));
	image.SetNumberOfDimensions(2);
	image.SetDimension(0, form_.columns);
	image.SetDimension(1, form_.rows);
	const auto bits = [](unsigned count) { return static_cast<unsigned short>(count); };
	image.SetPixelFormat(gdcm::PixelFormat(bits(form_.samples), bits(form_.allocated), bits(form_.stored),
	                                       bits(form_.high_bit), form_.is_signed ? 1 : 0));
	image.SetPhotometricInterpretation(form_.samples > 1 ? gdcm::PhotometricInterpretation::RGB
	                                                     : gdcm::PhotometricInterpretation::MONOCHROME2);
	image.SetPlanarConfiguration(0);
	image.SetDataElement(element);
	std::string bytes(form_.valuesOfFrame() * (form_.allocated / 8), '\0');
	const PrintedText printed; // libjpeg fills up what is missing, and only says so
	if (!isWhole(index) || image.GetBufferLength() != bytes.size() || !image.GetBuffer(bytes.data()) ||
	    printed.text().find("Corrupt JPEG data") != std::string::npos ||
	    printed.text().find("Premature end of JPEG") != std::string::npos)
		throw damaged(fmt::format("the pixels of {} do not unpack", name_));
	return bytes;
}

std::vector<double> DicomPixels::storedValues(std::size_t index) const
{
	const std::size_t count = form_.valuesOfFrame();
	if (form_.allocated == 1) // frames follow each other without a gap
		return ofOneBit(plain_, index * count, count);
	const std::size_t size = count * (form_.allocated / 8);
	const std::string own = packed_ ? unpacked(index) : std::string();
	const std::string_view bytes = packed_ ? std::string_view(own) : plain_.substr(index * size, size);
	if (form_.is_real)
		return form_.allocated == 32 ? numbersInBytes<float>(bytes) : numbersInBytes<double>(bytes);
	if (form_.allocated == 8)
		return fromBits<std::uint8_t>(bytes, form_);
	return form_.allocated == 16 ? fromBits<std::uint16_t>(bytes, form_) : fromBits<std::uint32_t>(bytes, form_);
}

std::vector<double> DicomPixels::frame(std::size_t index)
{
	std::vector<double> values = storedValues(index);
	if (form_.is_by_plane)
		values = interleaved(values, form_.samples);
	const double low = form_.padding.first;
	const double high = form_.padding.second;
	if (low <= high)
		padded_ += static_cast<std::size_t>(
		    std::count_if(values.begin(), values.end(), [&](double value) { return value >= low && value <= high; }));
	if (form_.table) // past its ends, its first or last value
		for (double& value : values)
			value = (*form_.table)[static_cast<std::size_t>(
			    std::clamp(value - form_.table_first, 0.0, static_cast<double>(form_.table->size() - 1)))];
	return values;
}

} // namespace vp::reader::volumes
