#include "slice_files.h"

#include "base/file_pattern.h"
#include "vprobe-read/base/is_one_of.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace vp::reader::checks
{

namespace fs = std::filesystem;

std::vector<std::string> sliceFiles(const std::string& path)
{
	std::error_code error;
	const bool is_folder = fs::is_directory(path, error);
	if (!is_folder && !isFilePattern(path))
		return {};
	std::vector<std::string> slices;
	for (const std::string& file : filesOfPattern(path))
	{
		std::string ending = fs::path(file).extension().string();
		std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
		if (is_folder && isOneOf(ending, {"", ".dcm", ".ima"}))
			return {};
		if (isPictureName(file))
			slices.push_back(file);
	}
	return slices;
}

} // namespace vp::reader::checks
