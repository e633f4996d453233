#include "view/file_places.h"

#include <filesystem>

namespace vp::view
{

namespace fs = std::filesystem;

namespace
{

bool isBuiltIn(const std::string& input)
{
	return input.starts_with("demo:");
}

fs::path folderOf(const fs::path& file)
{
	std::error_code failed;
	const fs::path folder = fs::absolute(file, failed).parent_path();
	const fs::path real = fs::weakly_canonical(folder, failed);
	return failed ? folder : real;
}

} // namespace

std::string relativeTo(const std::string& state, const std::string& input)
{
	if (isBuiltIn(input))
		return input;
	return (folderOf(input) / fs::path(input).filename()).lexically_relative(folderOf(state)).string();
}

std::string fromState(const std::string& state, const std::string& input)
{
	if (isBuiltIn(input))
		return input;
	return (fs::path(state).parent_path() / input).string();
}

} // namespace vp::view
