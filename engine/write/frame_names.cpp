#include "write/frame_names.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

namespace vp::write
{

namespace
{

constexpr int kMaxDigits = 20;

} // namespace

Result<FrameNames> FrameNames::create(const std::string& pattern, const std::string& example)
{
	const std::string word = example.substr(0, example.find_first_of(":}"));
	const Error wrong{ErrorKind::usage, fmt::format("-o {}: {}s need names of their own; put {} into it", pattern,
	                                                word.substr(1), example)};
	FrameNames names;
	const std::size_t open = pattern.find(word);
	const std::size_t close = pattern.find('}', open);
	if (open == pattern.npos || close == pattern.npos)
		return wrong;
	const std::string_view format = std::string_view(pattern).substr(open + word.size(), close - open - word.size());
	if (!format.empty())
	{
		const char* end = format.data() + format.size();
		const auto [at, failed] = std::from_chars(format.data() + 1, end, names.digits_);
		if (format[0] != ':' || failed != std::errc() || at != end || names.digits_ < 1 || names.digits_ > kMaxDigits)
			return wrong;
	}
	names.before_ = pattern.substr(0, open);
	names.after_ = pattern.substr(close + 1);
	const std::filesystem::path folder = std::filesystem::path(names.of(0)).parent_path();
	if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
		return Error{ErrorKind::output,
		             fmt::format("{}: {} is no folder; choose another path", pattern, folder.string())};
	return names;
}

std::string FrameNames::of(int frame) const
{
	return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

} // namespace vp::write
