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

void checkChunks(const fs::path& array)
{
	json about;
	try
	{
		about = json::parse(std::ifstream(array / ".zarray"));
		std::uint64_t bytes = widthOf(about.at("dtype").get<std::string>());
		for (const json& side : about.at("chunks"))
			if (__builtin_mul_overflow(bytes, side.get<std::uint64_t>(), &bytes) || bytes > std::uint64_t(1) << 40)
				throw damaged(fmt::format("{} has chunks larger than can be", array.filename().string()));
		if (about.value("compressor", json()).is_null() && about.value("filters", json()).is_null())
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
