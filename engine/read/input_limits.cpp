#include "read/input_limits.h"

#include "base/file_pattern.h"
#include "read/formats.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include <unistd.h>

namespace vp::read
{

namespace
{

namespace fs = std::filesystem;

// The libraries of the readers map a quarter of a GiB before the first byte is read. Deflate packs up to 1032 bytes
// into one, so only small files are held to less than the machine has.
constexpr std::uint64_t kBaseMemory = std::uint64_t(2) << 30;
constexpr std::uint64_t kMemoryPerByte = 1032;
// The slowest reader measured, of ASCII XML, takes in 50 MB/s. A slow disk or a busy machine has 12 times as long.
constexpr std::chrono::seconds kBaseTime{15};
constexpr std::uint64_t kBytesPerSecond = 4u << 20;
// The most cells that a reader refines to take about four minutes.
constexpr std::chrono::seconds kMaxRefineTime{600};
// Largest number of files in a folder that are counted for an input that refers to others.
constexpr int kMaxFilesBeside = 10000;

std::uint64_t physicalMemory()
{
	const long pages = sysconf(_SC_PHYS_PAGES);
	const long page = sysconf(_SC_PAGESIZE);
	return pages > 0 && page > 0 ? std::uint64_t(pages) * std::uint64_t(page) : ~std::uint64_t(0);
}

// The files that belong to an input of this format, or, if there is none, to one of this name.
FormatFiles filesOf(const std::string& file, const std::string& name)
{
	const Format* format = name.empty() ? formatOfEnding(file) : findFormat(name);
	return format && format->files != FormatFiles::linked ? format->files : FormatFiles::alone;
}

std::uint64_t bytesBeside(const fs::path& file, FormatFiles files)
{
	const fs::path folder = fs::is_directory(file) ? file : file.has_parent_path() ? file.parent_path() : fs::path(".");
	std::uint64_t bytes = 0;
	std::error_code error;
	int left = kMaxFilesBeside;
	const auto options = fs::directory_options::skip_permission_denied;
	for (auto entry = fs::recursive_directory_iterator(folder, options, error);
	     !error && entry != fs::recursive_directory_iterator() && left > 0; entry.increment(error), --left)
	{
		// Pieces lie beside the file or one folder below; those of a case up to REGION/polyMesh in constant.
		if (entry.depth() > (files == FormatFiles::folder ? 2 : 0))
			entry.disable_recursion_pending();
		std::error_code ignored;
		if (entry->is_regular_file(ignored))
			bytes += entry->file_size(ignored);
	}
	return bytes;
}

Error inputError(const std::string& file, const std::string& reason)
{
	return {ErrorKind::input, fmt::format("{}: {}", file, reason)};
}

InputLimits limitsOf(std::uint64_t bytes)
{
	InputLimits limits;
	// Address space is more than memory: what the libraries map counts even where it is never touched.
	const std::uint64_t most = std::max(physicalMemory(), kBaseMemory);
	limits.memory = std::min(most, kBaseMemory + kMemoryPerByte * bytes);
	limits.follows_size = limits.memory < most;
	limits.time = kBaseTime + std::chrono::seconds(bytes / kBytesPerSecond);
	return limits;
}

Status checkPath(const std::string& file, const fs::file_status& status, const std::error_code& error)
{
	if (status.type() == fs::file_type::not_found)
		return inputError(file, "no such file; check the path");
	if (error)
		return inputError(file, fmt::format("cannot be opened: {}", error.message()));
	if (!fs::is_directory(status) && !fs::is_regular_file(status))
		return inputError(file, "not a regular file; copy its contents to one");
	if (access(file.c_str(), R_OK) != 0)
		return inputError(file, fmt::format("cannot be opened: {}", std::strerror(errno)));
	return Nothing{};
}

} // namespace

Result<InputLimits> stackLimits(const std::vector<std::string>& files)
{
	std::uint64_t bytes = 0;
	for (const std::string& file : files)
	{
		std::error_code error;
		const fs::file_status status = fs::status(file, error);
		if (Status can_be_read = checkPath(file, status, error); !can_be_read)
			return can_be_read.error();
		if (fs::is_directory(status))
			return inputError(file, "a folder among the slices of one volume; name the files in it");
		const std::uint64_t size = fs::file_size(file, error);
		if (error || size == 0)
			return inputError(file, "the file is empty");
		bytes += size;
	}
	return limitsOf(bytes);
}

InputLimits limitsWithoutFile()
{
	return {physicalMemory(), kMaxRefineTime, false};
}

Result<InputLimits> inputLimits(const std::string& file, const std::string& solution, const std::string& format)
{
	const FormatFiles files = filesOf(file, format);
	std::error_code error;
	const fs::file_status status = fs::status(file, error);
	if (isFilePattern(file))
		return filesOfPattern(file).empty()
		           ? Result<InputLimits>(inputError(file, "no file has such a name; check the path"))
		           : limitsOf(bytesBeside(file, FormatFiles::alone));
	if (Status can_be_read = checkPath(file, status, error); !can_be_read)
		return can_be_read.error();
	const bool is_folder = fs::is_directory(status); // a DICOM series or a Zarr store is a folder
	std::uint64_t bytes = is_folder ? bytesBeside(file, FormatFiles::folder) : fs::file_size(file, error);
	if (bytes == 0 && !is_folder && files != FormatFiles::folder)
		return inputError(file, "the file is empty");

	if (files != FormatFiles::alone && !is_folder)
		bytes = std::max(bytes, bytesBeside(file, files));
	if (const std::uint64_t more = solution.empty() ? 0 : fs::file_size(solution, error); !error)
		bytes += more;
	return limitsOf(bytes);
}

InputLimits refinedLimits(InputLimits limits, double refine)
{
	const std::uint64_t growth = std::uint64_t(1) << (3 * static_cast<int>(std::clamp(refine, 0.0, 10.0)));
	const std::uint64_t most = std::max(physicalMemory(), kBaseMemory);
	limits.follows_size = limits.follows_size && limits.memory <= most / growth;
	limits.memory = limits.memory > most / growth ? most : limits.memory * growth;
	limits.time = std::min(limits.time * static_cast<std::int64_t>(growth), std::max(limits.time, kMaxRefineTime));
	return limits;
}

} // namespace vp::read
