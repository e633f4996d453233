#include "write/plane_picture.h"

#include "render/annotate/valid_utf8.h"
#include "render/flat/cairo_library.h"
#include "write/atomic_file.h"
#include "write/png.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace vp::write
{

namespace
{

using render::cairo;

constexpr double kPointsPerPixel = 0.75;

struct SurfaceDeleter
{
	void operator()(cairo_surface_t* surface) const { cairo().surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

cairo_status_t writeCairoBytes(void* file, const unsigned char* bytes, unsigned size)
{
	static_cast<AtomicFile*>(file)->write({reinterpret_cast<const char*>(bytes), size}); // failures: see commit()
	return CAIRO_STATUS_SUCCESS;
}

// A build that is to give the same bytes again sets the date of its files (reproducible-builds.org,
// SOURCE_DATE_EPOCH): seconds since 1970. Nothing if it is not set, or no number.
std::optional<std::string> dateOfBuild()
{
	const char* text = std::getenv("SOURCE_DATE_EPOCH");
	if (!text)
		return std::nullopt;
	std::int64_t seconds = 0;
	const char* end = text + std::strlen(text);
	constexpr std::int64_t kLast = 253402300799; // the year 9999 ends
	if (const auto [stop, failed] = std::from_chars(text, end, seconds);
	    stop != end || failed != std::errc() || seconds < 0 || seconds > kLast)
		return std::nullopt;
	return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

Surface surfaceFor(const render::Look& look, PictureFormat format, AtomicFile& file)
{
	const int width = static_cast<int>(look.width);
	const int height = static_cast<int>(look.height);
	switch (format)
	{
	case PictureFormat::png:
		return Surface(cairo().image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
	case PictureFormat::svg:
	{
		Surface surface(cairo().svg_surface_create_for_stream(writeCairoBytes, &file, width, height));
		cairo().svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
		return surface;
	}
	case PictureFormat::pdf:
	{
		Surface surface(cairo().pdf_surface_create_for_stream(writeCairoBytes, &file, kPointsPerPixel * width,
		                                                      kPointsPerPixel * height));
		cairo().pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE,
		                                 render::validUtf8(look.title).c_str());
		if (const auto date = dateOfBuild())
			cairo().pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, date->c_str());
		return surface;
	}
	}
	return nullptr;
}

// From cairo's words of alpha and colors multiplied by it.
render::Picture pictureOf(cairo_surface_t* surface)
{
	cairo().surface_flush(surface);
	render::Picture picture;
	picture.width = static_cast<std::uint32_t>(cairo().image_surface_get_width(surface));
	picture.height = static_cast<std::uint32_t>(cairo().image_surface_get_height(surface));
	picture.rgba.resize(std::size_t(4) * picture.width * picture.height);
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
		{
			std::uint32_t word;
			std::memcpy(&word,
			            cairo().image_surface_get_data(surface) +
			                std::size_t(cairo().image_surface_get_stride(surface)) * y + std::size_t(4) * x,
			            4);
			const std::uint32_t alpha = word >> 24;
			std::uint8_t* to = &picture.rgba[4 * (std::size_t(y) * picture.width + x)];
			for (int c = 0; c < 3; ++c)
			{
				const std::uint32_t part = word >> (16 - 8 * c) & 0xFFu;
				to[c] = static_cast<std::uint8_t>(alpha ? std::min(255u, (255u * part + alpha / 2) / alpha) : 0u);
			}
			to[3] = static_cast<std::uint8_t>(alpha);
		}
	return picture;
}

Status draw(const render::FlatScene& flat, const std::string& path, AtomicFile& file)
{
	const PictureFormat format = *pictureFormatOf(path);
	const Surface surface = surfaceFor(flat.scene.look, format, file);
	cairo_t* context = cairo().create(surface.get());
	if (format == PictureFormat::pdf)
		cairo().scale(context, kPointsPerPixel, kPointsPerPixel);
	render::drawFlat(flat, context);
	cairo_status_t status = cairo().status(context);
	cairo().destroy(context);
	if (status == CAIRO_STATUS_SUCCESS && format == PictureFormat::png)
		return encodePng(pictureOf(surface.get()), path, file);
	cairo().surface_finish(surface.get());
	if (status == CAIRO_STATUS_SUCCESS)
		status = cairo().surface_status(surface.get());
	if (status != CAIRO_STATUS_SUCCESS)
		return Error{ErrorKind::output, fmt::format("{}: cannot be drawn: {}; choose a smaller `size`", path,
		                                            cairo().status_to_string(status))};
	return Nothing{};
}

} // namespace

std::optional<PictureFormat> pictureFormatOf(const std::string& path)
{
	std::string ending = std::filesystem::path(path).extension().string();
	std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
	if (ending == ".png")
		return PictureFormat::png;
	if (ending == ".svg")
		return PictureFormat::svg;
	if (ending == ".pdf")
		return PictureFormat::pdf;
	return std::nullopt;
}

int colorSteps(PictureFormat format)
{
	constexpr int kOfPolygons = 64; // hardly to be told from more; a quarter of the file
	return format == PictureFormat::png ? render::kColorMapSize : kOfPolygons;
}

Status writePlanePictures(std::span<const render::FlatScene> flats, std::span<const std::string> paths)
{
	if (Status loaded = render::loadCairo(); !loaded)
		return loaded;
	std::vector<AtomicFile> files;
	files.reserve(flats.size()); // cairo keeps their places
	for (std::size_t i = 0; i < flats.size(); ++i)
	{
		Result<AtomicFile> file = AtomicFile::create(paths[i]);
		if (!file)
			return file.error();
		files.push_back(std::move(*file));
		if (Status drawn = draw(flats[i], paths[i], files.back()); !drawn)
			return drawn;
	}
	for (AtomicFile& file : files)
		if (Status written = file.commit(); !written)
			return written;
	return Nothing{};
}

} // namespace vp::write
