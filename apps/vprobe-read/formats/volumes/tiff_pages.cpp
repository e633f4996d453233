#include "tiff_pages.h"

#include "parts/part_bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <span>

#include <tiffio.h>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

// libtiff tells them without saying of which file, so each thread has its own.
thread_local std::string first_tiff_error;
thread_local bool reads_values = false;

void keepTiffError(const char*, const char* format, va_list arguments)
{
	std::array<char, 200> text;
	std::vsnprintf(text.data(), text.size(), format, arguments);
	if (first_tiff_error.empty())
		first_tiff_error = text.data();
}

// Warnings at a header are about unknown tags. Warnings at values are about values that are made up.
void keepTiffWarning(const char* module, const char* format, va_list arguments)
{
	if (reads_values)
		keepTiffError(module, format, arguments);
}

void refuseOnTiffError(bool has_failed = false)
{
	if (!first_tiff_error.empty() || has_failed)
		throw damaged(reads_values ? "a page cannot be read or unpacked" : "the list of its pages cannot be followed");
}

class ReadingValues
{
public:
	ReadingValues() { reads_values = true; }
	~ReadingValues() { reads_values = false; }
};

template <class Number>
Number tag(TIFF* tiff, std::uint32_t which, Number otherwise)
{
	Number value = otherwise;
	return TIFFGetFieldDefaulted(tiff, which, &value) ? value : otherwise;
}

bool isPlanar(TIFF* tiff)
{
	return tag<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE &&
	       tag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1) > 1;
}

TiffPageKind kindOfPage(TIFF* tiff)
{
	TiffPageKind kind;
	kind.width = tag<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
	kind.height = tag<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
	kind.samples = std::max<std::uint16_t>(tag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1), 1);
	kind.bits = tag<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
	kind.format = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
	if (kind.format == SAMPLEFORMAT_VOID)
		kind.format = SAMPLEFORMAT_UINT;
	return kind;
}

// Puts pixels of a row, as libtiff gives them, to their places.
void putPixels(const char* from, const TiffPageKind& kind, std::uint32_t count, bool is_planar, char* to)
{
	const std::size_t width = byteSize(kind.type());
	if (kind.bits == 1)
		for (std::uint32_t i = 0; i < count * (is_planar ? 1u : kind.samples); ++i)
			to[is_planar ? std::size_t(i) * kind.samples : i] = static_cast<char>(from[i / 8] >> (7 - i % 8) & 1);
	else if (is_planar)
		for (std::uint32_t i = 0; i < count; ++i)
			std::copy_n(from + i * width, width, to + std::size_t(i) * kind.samples * width);
	else
		std::copy_n(from, std::size_t(count) * kind.samples * width, to);
}

} // namespace

NumberType TiffPageKind::type() const
{
	const auto is = [&](int wanted, std::uint16_t as) { return bits == wanted && format == as; };
	if (is(8, SAMPLEFORMAT_UINT) || is(1, SAMPLEFORMAT_UINT))
		return NumberType::uint8;
	if (is(8, SAMPLEFORMAT_INT))
		return NumberType::int8;
	if (is(16, SAMPLEFORMAT_UINT))
		return NumberType::uint16;
	if (is(16, SAMPLEFORMAT_INT))
		return NumberType::int16;
	if (is(32, SAMPLEFORMAT_UINT))
		return NumberType::uint32;
	if (is(32, SAMPLEFORMAT_INT))
		return NumberType::int32;
	if (is(64, SAMPLEFORMAT_UINT))
		return NumberType::uint64;
	if (is(64, SAMPLEFORMAT_INT))
		return NumberType::int64;
	if (is(32, SAMPLEFORMAT_IEEEFP))
		return NumberType::float32;
	if (is(64, SAMPLEFORMAT_IEEEFP))
		return NumberType::float64;
	if (is(16, SAMPLEFORMAT_IEEEFP))
		throw Refusal("floats of 16 bits, which are not read; save it with floats of 32 bits");
	if (format == SAMPLEFORMAT_COMPLEXIEEEFP || format == SAMPLEFORMAT_COMPLEXINT)
		throw Refusal("complex values, which are not read; save their magnitude or parts as floats of 32 bits");
	throw Refusal(
	    fmt::format("values of {} bits and TIFF sample format {}; save it with 8, 16 or 32 bits", bits, format));
}

std::uint64_t TiffPageKind::bytes() const
{
	std::uint64_t bytes = std::uint64_t(samples) * byteSize(type());
	if (__builtin_mul_overflow(bytes, width, &bytes) || __builtin_mul_overflow(bytes, height, &bytes) ||
	    bytes > std::uint64_t(1) << 48)
		throw damaged("a page of more values than there can be");
	return bytes;
}

TiffPages::TiffPages(const std::string& file) : file_(file)
{
	first_tiff_error.clear();
	TIFFSetErrorHandler(keepTiffError);
	TIFFSetWarningHandler(keepTiffWarning);
	TIFF* tiff = TIFFOpen(file.c_str(), "r");
	tiff_ = tiff;
	if (!tiff)
		throw damaged("its first page cannot be found");
	do
	{
		if (tag<std::uint32_t>(tiff, TIFFTAG_IMAGEDEPTH, 1) > 1)
			throw Refusal("pages that are volumes (ImageDepth); save each slice as a page");
		pages_.push_back({kindOfPage(tiff),
		                  (tag<std::uint32_t>(tiff, TIFFTAG_SUBFILETYPE, 0) & FILETYPE_REDUCEDIMAGE) != 0,
		                  TIFFCurrentDirOffset(tiff)});
	} while (TIFFReadDirectory(tiff));
	refuseOnTiffError();
}

TiffPages::~TiffPages()
{
	if (tiff_)
		TIFFClose(static_cast<TIFF*>(tiff_));
}

void TiffPages::refuseImpossible(std::uint64_t page)
{
	// Codecs of pictures pack an even page a thousandfold and more.
	const std::uint64_t most_packing = isPlain(page) ? 1 : 1 << 17;
	std::error_code error;
	if (kind(page).bytes() / most_packing > std::filesystem::file_size(file_, error))
		throw damaged("a page has more values than the file can hold");
}

void TiffPages::select(std::uint64_t page)
{
	if (page >= pages_.size() || !TIFFSetSubDirectory(static_cast<TIFF*>(tiff_), pages_[page].place))
		throw damaged("a page cannot be found again");
}

std::string TiffPages::description()
{
	select(0);
	const char* text = tag<const char*>(static_cast<TIFF*>(tiff_), TIFFTAG_IMAGEDESCRIPTION, "");
	return text ? text : "";
}

std::array<double, 2> TiffPages::resolution()
{
	select(0);
	auto* tiff = static_cast<TIFF*>(tiff_);
	return {tag<float>(tiff, TIFFTAG_XRESOLUTION, 0.0f), tag<float>(tiff, TIFFTAG_YRESOLUTION, 0.0f)};
}

std::string TiffPages::resolutionUnit()
{
	select(0);
	std::uint16_t unit = RESUNIT_NONE; // without the default, which is the inch
	if (!TIFFGetField(static_cast<TIFF*>(tiff_), TIFFTAG_RESOLUTIONUNIT, &unit))
		return "";
	return unit == RESUNIT_INCH ? "in" : unit == RESUNIT_CENTIMETER ? "cm" : "";
}

bool TiffPages::isPlain(std::uint64_t page)
{
	select(page);
	auto* tiff = static_cast<TIFF*>(tiff_);
	return tag<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_NONE && !TIFFIsTiled(tiff) &&
	       !isPlanar(tiff) && kind(page).bits >= 8 && TIFFNumberOfStrips(tiff) >= 1;
}

std::optional<std::uint64_t> TiffPages::plainBegin(std::uint64_t page)
{
	auto* tiff = static_cast<TIFF*>(tiff_);
	if (!isPlain(page) || tag<std::uint16_t>(tiff, TIFFTAG_FILLORDER, FILLORDER_MSB2LSB) != FILLORDER_MSB2LSB)
		return std::nullopt;
	const std::uint64_t begin = TIFFGetStrileOffset(tiff, 0), row_bytes = kind(page).bytes() / kind(page).height;
	const auto rows = tag<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, 0);
	for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(tiff); ++strip)
		if (TIFFGetStrileOffset(tiff, strip) != begin + strip * std::uint64_t(rows) * row_bytes)
			return std::nullopt;
	refuseOnTiffError();
	return begin;
}

bool TiffPages::isSwapped() const
{
	return TIFFIsByteSwapped(static_cast<TIFF*>(tiff_)) != 0;
}

std::array<std::uint32_t, 2> TiffPages::blockSize(std::uint64_t page)
{
	select(page);
	auto* tiff = static_cast<TIFF*>(tiff_);
	const TiffPageKind& of_page = kind(page);
	std::array<std::uint32_t, 2> size = {of_page.width, of_page.height};
	if (TIFFIsTiled(tiff))
		size = {tag<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0), tag<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0)};
	else
		size[1] = std::min(size[1], tag<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, size[1]));
	if (size[0] == 0 || size[1] == 0)
		throw damaged("its strips or tiles have no size");
	return size;
}

void TiffPages::readBlock(std::uint64_t page, std::uint64_t across, std::uint64_t down, char* to)
{
	const std::array<std::uint32_t, 2> size = blockSize(page);
	beginValues();
	auto* tiff = static_cast<TIFF*>(tiff_);
	const TiffPageKind& of_page = kind(page);
	const bool planar = isPlanar(tiff), tiled = TIFFIsTiled(tiff);
	const std::size_t number = byteSize(of_page.type()), pixel = number * of_page.samples;
	const std::size_t row_bytes = (std::uint64_t(size[0]) * of_page.bits * (planar ? 1u : of_page.samples) + 7) / 8;
	const std::uint64_t x = across * size[0], y = down * size[1];
	if (x >= of_page.width || y >= of_page.height)
		throw damaged("a page has fewer tiles than are asked for");
	const std::uint64_t rows = std::min<std::uint64_t>(size[1], of_page.height - y);
	const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(size[0], of_page.width - x));
	std::vector<char> block(row_bytes * size[1]);
	const ReadingValues reading;
	for (std::uint16_t sample = 0; sample < (planar ? of_page.samples : 1); ++sample)
	{
		const auto x32 = static_cast<std::uint32_t>(x), y32 = static_cast<std::uint32_t>(y);
		const std::uint32_t place =
		    tiled ? TIFFComputeTile(tiff, x32, y32, 0, sample) : TIFFComputeStrip(tiff, y32, sample);
		const auto room = static_cast<tmsize_t>(tiled ? block.size() : row_bytes * rows);
		const tmsize_t read = tiled ? TIFFReadEncodedTile(tiff, place, block.data(), room)
		                            : TIFFReadEncodedStrip(tiff, place, block.data(), room);
		refuseOnTiffError(read != room);
		for (std::uint64_t row = 0; row < rows; ++row)
			putPixels(block.data() + row * row_bytes, of_page, count, planar,
			          to + row * size[0] * pixel + sample * number);
	}
	refuseOnTiffError();
}

void TiffPages::readTiles(const TiffPageKind& kind, char* to)
{
	auto* tiff = static_cast<TIFF*>(tiff_);
	const auto width = tag<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0);
	const auto height = tag<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0);
	const bool planar = isPlanar(tiff);
	const std::size_t pixel = byteSize(kind.type()) * kind.samples;
	const std::uint64_t row_bits = std::uint64_t(width) * kind.bits * (planar ? 1u : kind.samples);
	const std::size_t row_bytes = (row_bits + 7) / 8;
	std::vector<char> tile(static_cast<std::size_t>(std::max<tmsize_t>(TIFFTileSize(tiff), 0)));
	if (width == 0 || height == 0 || tile.size() < row_bytes * height)
		throw damaged("its tiles have no size");
	for (std::uint16_t plane = 0; plane < (planar ? kind.samples : 1); ++plane)
		for (std::uint64_t y = 0; y < kind.height; y += height)
			for (std::uint64_t x = 0; x < kind.width; x += width)
			{
				refuseOnTiffError(TIFFReadTile(tiff, tile.data(), static_cast<std::uint32_t>(x),
				                               static_cast<std::uint32_t>(y), 0, plane) < 0);
				const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(width, kind.width - x));
				for (std::uint64_t row = 0; row < std::min<std::uint64_t>(height, kind.height - y); ++row)
					putPixels(tile.data() + row * row_bytes, kind, count, planar,
					          to + ((y + row) * kind.width + x) * pixel + plane * byteSize(kind.type()));
			}
}

void TiffPages::readRows(const TiffPageKind& kind, char* to)
{
	auto* tiff = static_cast<TIFF*>(tiff_);
	const bool planar = isPlanar(tiff);
	const std::uint64_t row_bits = std::uint64_t(kind.width) * kind.bits * (planar ? 1u : kind.samples);
	const std::size_t row_bytes = (row_bits + 7) / 8;
	if (TIFFScanlineSize(tiff) != static_cast<tmsize_t>(row_bytes))
		throw Refusal("pages whose colors are packed; save it as plain values");
	std::vector<char> line(row_bytes);
	for (std::uint16_t plane = 0; plane < (planar ? kind.samples : 1); ++plane)
		for (std::uint32_t row = 0; row < kind.height; ++row)
		{
			refuseOnTiffError(TIFFReadScanline(tiff, line.data(), row, plane) < 0);
			putPixels(line.data(), kind, kind.width, planar,
			          to + (std::uint64_t(row) * kind.width * kind.samples + plane) * byteSize(kind.type()));
		}
}

// Refuses values of the selected page that cannot be unpacked.
void TiffPages::beginValues()
{
	auto* tiff = static_cast<TIFF*>(tiff_);
	const auto compression = tag<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
	if (!TIFFIsCODECConfigured(compression))
		throw Refusal(fmt::format("pages packed by TIFF compression {}, which libtiff cannot unpack here; save it with "
		                          "deflate or LZW",
		                          compression));
	if (compression == COMPRESSION_JPEG &&
	    tag<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) == PHOTOMETRIC_YCBCR)
		TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
}

void TiffPages::read(std::uint64_t page, char* to)
{
	select(page);
	auto* tiff = static_cast<TIFF*>(tiff_);
	beginValues();
	const ReadingValues reading;
	if (TIFFIsTiled(tiff))
		readTiles(kind(page), to);
	else
		readRows(kind(page), to);
	refuseOnTiffError();
}

void TiffPages::readBehindFirst(std::uint64_t plane, char* to)
{
	select(0);
	auto* tiff = static_cast<TIFF*>(tiff_);
	const std::uint64_t bytes = kind(0).bytes(), begin = TIFFGetStrileOffset(tiff, 0);
	const MappedText mapped(file_);
	if (begin > mapped.text().size() || (mapped.text().size() - begin) / bytes <= plane)
		throw damaged(fmt::format("it ends before the values of image {}", plane));
	mapped.text().copy(to, bytes, begin + plane * bytes);
	const std::size_t width = byteSize(kind(0).type());
	if (TIFFIsByteSwapped(tiff) && width > 1)
		parts::swapNumbers(std::as_writable_bytes(std::span(to, bytes)), width);
}

} // namespace vp::reader::volumes
