#include "write/png.h"

#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <vector>

namespace vp::write
{

namespace
{

bool isOpaque(const render::Picture& picture)
{
	for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
		if (picture.rgba[i] != 255)
			return false;
	return true;
}

void keepMessage(png_structp png, png_const_charp message)
{
	*static_cast<std::string*>(png_get_error_ptr(png)) = message;
	png_longjmp(png, 1);
}

void dropMessage(png_structp, png_const_charp) {}

// What went wrong, empty where nothing did. Objects with destructors stay outside: libpng's errors jump over this
// frame.
bool encode(const render::Picture& picture, bool opaque, std::vector<std::uint8_t>& row, std::FILE* file,
            std::string& error)
{
	png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, keepMessage, dropMessage);
	png_infop info = png ? png_create_info_struct(png) : nullptr;
	if (!info || setjmp(png_jmpbuf(png)))
	{
		png_destroy_write_struct(&png, &info);
		return false;
	}
	png_init_io(png, file);
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

Error cannotWrite(const std::string& path, const std::string& reason)
{
	return {ExitCode::output, fmt::format("{}: cannot be written ({}); give another place with -o", path, reason)};
}

} // namespace

Status writePng(const render::Picture& picture, const std::string& path)
{
	const bool to_stdout = path == "-";
	const std::string name = to_stdout ? "standard output" : path;
	const std::string temporary = fmt::format("{}.{}.part", path, static_cast<long>(getpid()));
	std::FILE* file = to_stdout ? stdout : std::fopen(temporary.c_str(), "wb");
	if (!file)
		return cannotWrite(name, std::strerror(errno));

	std::vector<std::uint8_t> row(std::size_t(4) * picture.width);
	std::string reason;
	errno = 0;
	bool written = encode(picture, isOpaque(picture), row, file, reason);
	if (std::fflush(file) != 0)
		written = false;
	if (errno != 0 && !written)
		reason = std::strerror(errno);
	if (to_stdout)
		return written ? Status(Nothing{}) : cannotWrite(name, reason);

	if (std::fclose(file) != 0)
	{
		written = false;
		reason = std::strerror(errno);
	}
	if (written && std::rename(temporary.c_str(), path.c_str()) != 0)
	{
		written = false;
		reason = std::strerror(errno);
	}
	if (!written)
	{
		std::remove(temporary.c_str());
		return cannotWrite(name, reason);
	}
	return Nothing{};
}

} // namespace vp::write
