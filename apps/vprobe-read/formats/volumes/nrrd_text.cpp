#include "nrrd_axes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

namespace vp::reader::volumes
{

namespace
{

// Takes a line off the text.
std::string_view nextLine(std::string_view& text)
{
	const std::size_t end = std::min(text.find('\n'), text.size());
	std::string_view line = text.substr(0, end);
	text.remove_prefix(std::min(end + 1, text.size()));
	if (line.ends_with('\r'))
		line.remove_suffix(1);
	return line;
}

// "Data File: x" gives "datafile" and "x".
std::pair<std::string, std::string_view> fieldOf(std::string_view line)
{
	const std::size_t colon = line.find(':');
	if (colon == line.npos || line.starts_with('#') || line.substr(colon).starts_with(":="))
		return {};
	std::string key;
	for (const char c : line.substr(0, colon))
		if (c != ' ')
			key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
	std::string_view value = line.substr(colon + 1);
	while (value.starts_with(' ') || value.starts_with('\t'))
		value.remove_prefix(1);
	while (value.ends_with(' ') || value.ends_with('\t'))
		value.remove_suffix(1);
	return {key, value};
}

std::size_t skipOf(std::string_view value)
{
	std::size_t skip = 0;
	std::from_chars(value.data(), value.data() + value.size(), skip);
	return skip;
}

std::string_view skipped(std::string_view text, std::size_t lines, std::size_t bytes)
{
	for (std::size_t i = 0; i < lines && !text.empty(); ++i)
		nextLine(text);
	return text.substr(std::min(bytes, text.size()));
}

} // namespace

std::optional<std::string> nrrdText(const std::string& file)
{
	const MappedText mapped(file);
	std::string_view rest = mapped.text();
	std::vector<std::string> names;
	std::size_t lines = 0, bytes = 0;
	bool is_detached = false;
	while (!rest.empty())
	{
		const std::string_view line = nextLine(rest);
		if (line.empty())
			break;
		const auto [key, value] = fieldOf(line);
		if (key == "lineskip")
			lines = skipOf(value);
		else if (key == "byteskip")
			bytes = skipOf(value);
		else if (key != "datafile")
			continue;
		else if (value.find('%') != value.npos)
			return std::nullopt;
		else if (is_detached = true; value.starts_with("LIST"))
			while (!rest.empty())
				names.emplace_back(nextLine(rest));
		else
			names.emplace_back(value);
	}
	if (!is_detached)
		return std::string(skipped(rest, lines, bytes));
	std::string text;
	for (const std::string& name : names)
		if (!name.empty())
			text += fmt::format(
			    "{}\n",
			    skipped(MappedText((std::filesystem::path(file).parent_path() / name).string()).text(), lines, bytes));
	return text;
}

} // namespace vp::reader::volumes
