#include "view/input_title.h"

#include <fmt/format.h>

#include <filesystem>

namespace vp::view
{

std::string inputTitle(const std::vector<std::string>& inputs)
{
	if (inputs.empty())
		return {};
	const std::string& first = inputs.front();
	const std::string name = first.starts_with("demo:") ? first : std::filesystem::path(first).filename().string();
	return inputs.size() == 1 ? name : fmt::format("{} and {} more", name, inputs.size() - 1);
}

} // namespace vp::view
