// Stacks of TIFF pages through libtiff: VTK's readers know neither ImageJ's nor OME's times, and turn pages over.
#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "tiff_layout.h"
#include "time_choice.h"
#include "value_image.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <memory>

#include <tiffio.h>

using vp::grid::NumberType;

namespace
{

std::string first_error;

void keepError(const char*, const char* format, va_list arguments)
{
	std::array<char, 200> text;
	std::vsnprintf(text.data(), text.size(), format, arguments);
	if (first_error.empty())
		first_error = text.data();
}

void refuseOnError()
{
	if (!first_error.empty())
		throw damaged(first_error);
}

struct TiffCloser
{
	void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffPointer = std::unique_ptr<TIFF, TiffCloser>;

template <class Number>
Number tag(TIFF* tiff, std::uint32_t which, Number otherwise)
{
	Number value = otherwise;
	return TIFFGetFieldDefaulted(tiff, which, &value) ? value : otherwise;
}

NumberType typeOf(TIFF* tiff)
{
	const auto bits = tag<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
	const auto kind = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
	const auto is = [&](int wanted, std::uint16_t format) { return bits == wanted && kind == format; };
	if (is(8, SAMPLEFORMAT_UINT))
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
	if (is(32, SAMPLEFORMAT_IEEEFP))
		return NumberType::float32;
	if (is(64, SAMPLEFORMAT_IEEEFP))
		return NumberType::float64;
	if (bits == 16 && kind == SAMPLEFORMAT_IEEEFP)
		throw Refusal("floats of 16 bits, which are not read; save it with floats of 32 bits");
	throw Refusal(
	    fmt::format("values of {} bits and TIFF sample format {}; save it with 8, 16 or 32 bits", bits, kind));
}

// What all pages of a stack have in common.
struct PageKind
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	std::uint16_t samples = 1;
	NumberType type = NumberType::uint8;

	bool operator==(const PageKind&) const = default;
	std::size_t rowBytes() const { return std::size_t(width) * samples * byteSize(type); }
};

PageKind kindOf(TIFF* tiff)
{
	PageKind kind;
	kind.width = tag<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
	kind.height = tag<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
	kind.samples = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
	kind.type = typeOf(tiff);
	if (tag<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) != PLANARCONFIG_CONTIG && kind.samples > 1)
		throw Refusal("pages with a plane for each sample; save it with samples side by side");
	return kind;
}

void readTiles(TIFF* tiff, const PageKind& kind, char* to)
{
	const auto width = tag<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0);
	const auto height = tag<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0);
	const std::size_t pixel = kind.rowBytes() / kind.width;
	std::vector<char> tile(static_cast<std::size_t>(std::max<tmsize_t>(TIFFTileSize(tiff), 0)));
	if (width == 0 || height == 0 || tile.size() < std::size_t(width) * height * pixel)
		throw damaged("its tiles have no size");
	for (std::uint32_t y = 0; y < kind.height; y += height)
		for (std::uint32_t x = 0; x < kind.width; x += width)
		{
			if (TIFFReadTile(tiff, tile.data(), x, y, 0, 0) < 0)
				return;
			const std::size_t bytes = std::min(width, kind.width - x) * pixel;
			for (std::uint32_t row = 0; row < std::min(height, kind.height - y); ++row)
				std::copy_n(tile.data() + std::size_t(row) * width * pixel, bytes,
				            to + (y + row) * kind.rowBytes() + x * pixel);
		}
}

void readPage(TIFF* tiff, const PageKind& kind, char* to)
{
	if (TIFFIsTiled(tiff))
		readTiles(tiff, kind, to);
	else if (TIFFScanlineSize(tiff) != static_cast<tmsize_t>(kind.rowBytes()))
		throw Refusal("pages whose colors are packed; save it as plain values");
	else
		for (std::uint32_t row = 0; row < kind.height; ++row, to += kind.rowBytes())
			if (TIFFReadScanline(tiff, to, row) < 0)
				break;
	refuseOnError();
}

// The pages that belong to the stack, by their numbers in the file: those like the first. Previews are not.
std::vector<std::uint32_t> pagesLike(TIFF* tiff, const PageKind& first, std::uint32_t& others)
{
	std::vector<std::uint32_t> pages;
	std::uint32_t number = 0;
	do
	{
		if (tag<std::uint32_t>(tiff, TIFFTAG_SUBFILETYPE, 0) & FILETYPE_REDUCEDIMAGE)
			++others;
		else if (kindOf(tiff) == first)
			pages.push_back(number);
		else
			++others;
		++number;
	} while (TIFFReadDirectory(tiff));
	refuseOnError();
	return pages;
}

} // namespace

void readTiff(const Request& request, ManifestWriter& manifest)
{
	TIFFSetErrorHandler(keepError);
	TIFFSetWarningHandler(nullptr); // about tags that are not known
	const TiffPointer tiff(TIFFOpen(request.file.c_str(), "r"));
	refuseOnError();
	if (!tiff)
		throw damaged("libtiff cannot open it");
	const PageKind kind = kindOf(tiff.get());
	const char* text = tag<const char*>(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, "");
	const std::string description = text ? text : "";
	const std::array<double, 2> resolution = {tag<float>(tiff.get(), TIFFTAG_XRESOLUTION, 0.0f),
	                                          tag<float>(tiff.get(), TIFFTAG_YRESOLUTION, 0.0f)};
	std::uint32_t others = 0;
	const std::vector<std::uint32_t> pages = pagesLike(tiff.get(), kind, others);
	const TiffLayout layout = tiffLayout(description, pages.size(), kind.samples, resolution);
	if (layout.pages() > pages.size())
		throw damaged(fmt::format("it has {} pages where its description asks for {}", pages.size(), layout.pages()));
	if (others > 0)
		manifest.warn(fmt::format("{} pages unlike the first one, or previews, are left out", others));

	std::vector<double> times;
	for (std::uint32_t t = 0; layout.times > 1 && t < layout.times; ++t)
		times.push_back(t * layout.time_step);
	const std::optional<double> time = chooseIfAny(times, request);
	const auto step =
	    time ? static_cast<std::uint32_t>(std::find(times.begin(), times.end(), *time) - times.begin()) : 0u;

	ValueLayout values{{kind.width, kind.height, layout.slices}, kind.samples, kind.type};
	const std::uint64_t bytes = values.byteCount();
	vtkSmartPointer<vtkImageData> image;
	for (std::uint32_t channel = 0; channel < layout.channels; ++channel)
	{
		std::string read(bytes, '\0');
		for (std::uint32_t slice = 0; slice < layout.slices; ++slice)
		{
			const std::uint64_t page = layout.pageOf(channel, slice, step);
			if (!TIFFSetDirectory(tiff.get(), static_cast<tdir_t>(pages[page])))
				throw damaged("a page cannot be found again");
			readPage(tiff.get(), kind, read.data() + slice * (bytes / layout.slices));
		}
		const auto array = arrayOf(read, values, layout.channels > 1 ? fmt::format("channel {}", channel) : "values");
		if (image)
			image->GetPointData()->AddArray(array);
		else
			image = imageOf(array, values.points);
	}
	image->SetSpacing(layout.spacing.data());
	manifest.setLengthUnits(layout.length_units);
	manifest.addLone(image);
	manifest.offerTimes(std::move(times));
}
