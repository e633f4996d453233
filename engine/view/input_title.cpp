#include "view/input_title.h"

#include "base/file_pattern.h"

#include <fmt/format.h>

#include <filesystem>

namespace vp::view
{

std::string inputTitle(const std::vector<std::string>& inputs)
{
	if (inputs.empty())
		return {};
	const std::string& first = inputs.front();
	const std::filesystem::path path = first;
	std::string name = first.starts_with("demo:") ? first : path.filename().string();
	if (name.empty() || isFilePattern(first)) // "slices/" and "slices/*.tif"
		name = (path.parent_path().filename() / name).string();
	return inputs.size() == 1 ? name : fmt::format("{} and {} more", name, inputs.size() - 1);
}

} // namespace vp::view
