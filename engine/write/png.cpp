#include "write/png.h"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::write
{

namespace
{

// Takes the bytes of the file. An error of it must not pass through libpng, which is C, so it is kept here.
struct ByteSink
{
	std::function<void(std::string_view)> take;
	std::exception_ptr error = nullptr;
};

bool isOpaque(const render::Picture& picture)
{
	for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
		if (picture.rgba[i] != 255)
			return false;
	return true;
}

// A message that is cut short needs no memory.
using PngMessage = std::array<char, 200>;

void keepMessage(png_structp png, png_const_charp message)
{
	auto& kept = *static_cast<PngMessage*>(png_get_error_ptr(png));
	*fmt::format_to_n(kept.data(), kept.size() - 1, "{}", message).out = '\0';
	png_longjmp(png, 1);
}

void dropMessage(png_structp, png_const_charp) {}

void writePngBytes(png_structp png, png_bytep bytes, png_size_t size)
{
	auto& sink = *static_cast<ByteSink*>(png_get_io_ptr(png));
	try
	{
		sink.take({reinterpret_cast<const char*>(bytes), size});
	}
	catch (...)
	{
		sink.error = std::current_exception();
	}
	if (sink.error)
		png_error(png, "its bytes cannot be kept");
}

void flushNothing(png_structp) {}

// False and the reason where libpng refuses. Objects with destructors stay outside: its errors jump over this frame.
bool encode(const render::Picture& picture, bool opaque, std::vector<std::uint8_t>& row, ByteSink& sink,
            PngMessage& error)
{
	png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, keepMessage, dropMessage);
	png_infop info = png ? png_create_info_struct(png) : nullptr;
	if (!info || setjmp(png_jmpbuf(png)))
	{
		png_destroy_write_struct(&png, &info);
		return false;
	}
	png_set_write_fn(png, &sink, writePngBytes, flushNothing);
	png_set_IHDR(png, info, picture.width, picture.height, 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
	             PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
	png_set_compression_level(png, 6);
	png_write_info(png, info);
	for (std::uint32_t y = 0; y < picture.height; ++y)
	{
		const std::uint8_t* from = &picture.rgba[std::size_t(4) * picture.width * y];
		if (opaque)
			for (std::uint32_t x = 0; x < picture.width; ++x)
				std::memcpy(&row[std::size_t(3) * x], from + std::size_t(4) * x, 3);
		else
			std::memcpy(row.data(), from, std::size_t(4) * picture.width);
		png_write_row(png, row.data());
	}
	png_write_end(png, nullptr);
	png_destroy_write_struct(&png, &info);
	return true;
}

} // namespace

namespace
{

Status encodeInto(const render::Picture& picture, const std::string& path, ByteSink sink)
{
	std::vector<std::uint8_t> row(std::size_t(4) * picture.width);
	PngMessage reason{};
	const bool is_encoded = encode(picture, isOpaque(picture), row, sink, reason);
	if (sink.error)
		std::rethrow_exception(sink.error);
	if (!is_encoded)
		return Error{ErrorKind::output, fmt::format("{}: cannot be encoded as PNG: {}", path, reason.data())};
	return Nothing{};
}

} // namespace

Status encodePng(const render::Picture& picture, const std::string& path, AtomicFile& file)
{
	return encodeInto(picture, path, {[&](std::string_view bytes) { file.write(bytes); }});
}

Result<std::string> pngBytes(const render::Picture& picture)
{
	std::string all;
	if (Status encoded = encodeInto(picture, "the picture", {[&](std::string_view bytes) { all += bytes; }}); !encoded)
		return encoded.error();
	return all;
}

Status writePng(const render::Picture& picture, const std::string& path)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	if (Status encoded = encodePng(picture, path, *file); !encoded)
		return encoded;
	return file->commit();
}

} // namespace vp::write
