#include "zarr_check.h"

#include "refusal.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>

using nlohmann::json;

namespace
{

namespace fs = std::filesystem;

// "<f8" has 8 bytes.
std::uint64_t widthOf(const std::string& type)
{
	std::uint64_t width = 0;
	if (type.size() > 2)
		std::from_chars(type.data() + 2, type.data() + type.size(), width);
	return width;
}

// The netCDF library takes packed, big-endian and Fortran-ordered chunks as if they were plain: it gives other numbers,
// and no error.
void refuseUnknownChunks(const json& about, const std::string& name)
{
	constexpr const char* remedy = "write it with compressor=None, or as netCDF with xarray's to_netcdf";
	const json compressor = about.value("compressor", json()), filters = about.value("filters", json());
	if (!compressor.is_null())
		throw Refusal(fmt::format("the chunks of {} are packed ({}), which is not read; {}", name,
		                          compressor.value("id", "in some way"), remedy));
	if (filters.is_array() && !filters.empty())
		throw Refusal(fmt::format("the chunks of {} went through the filter {}, which is not read; {}", name,
		                          filters[0].value("id", ""), remedy));
	if (about.value("order", "C") != "C")
		throw Refusal(fmt::format(
		    "the chunks of {} have the order of Fortran, which is not read; write them with order='C'", name));
	if (const json& type = about.at("dtype"); type.is_string() && type.get<std::string>().starts_with('>'))
		throw Refusal(
		    fmt::format("{} is big-endian, which is not read in Zarr; write it as little-endian ('<')", name));
}

void checkChunks(const fs::path& array)
{
	json about;
	try
	{
		about = json::parse(std::ifstream(array / ".zarray"));
		refuseUnknownChunks(about, array.filename().string());
		std::uint64_t bytes = widthOf(about.at("dtype").get<std::string>());
		for (const json& side : about.at("chunks"))
			if (__builtin_mul_overflow(bytes, side.get<std::uint64_t>(), &bytes) || bytes > std::uint64_t(1) << 40)
				throw damaged(fmt::format("{} has chunks larger than can be", array.filename().string()));
		for (const auto& chunk : fs::directory_iterator(array))
			if (std::isdigit(static_cast<unsigned char>(chunk.path().filename().string()[0])) &&
			    chunk.is_regular_file() && chunk.file_size() != bytes)
				throw damaged(fmt::format("chunk {} of {} has {} bytes where {} are wanted",
				                          chunk.path().filename().string(), array.filename().string(),
				                          chunk.file_size(), bytes));
	}
	catch (const json::exception&)
	{
		throw damaged(fmt::format("the .zarray of {} cannot be followed", array.filename().string()));
	}
}

} // namespace

void refuseShortChunks(const std::string& folder)
{
	for (const auto& entry : fs::directory_iterator(folder))
		if (entry.is_directory() && fs::exists(entry.path() / ".zarray"))
			checkChunks(entry.path());
}
