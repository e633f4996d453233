#include "read/formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace vp::read
{

namespace
{

constexpr auto alone = FormatFiles::alone;
constexpr auto linked = FormatFiles::linked;
constexpr auto beside = FormatFiles::beside;
constexpr auto folder = FormatFiles::folder;

constexpr bool base = false;
constexpr bool more = true;

constexpr Format kFormats[] = {
#define VP_FORMAT(NAME, ENDINGS, WHAT, READ, BY, FILES, SIGN, PROGRAM, ROOM, FUNCTION)                                 \
	{NAME, ENDINGS, WHAT, READ, BY, FILES, PROGRAM},
#include "read/format_table.inl"
#undef VP_FORMAT
};

// Calls `use` with each ending until it returns true; returns whether it did.
template <class Use>
bool anyEnding(std::string_view endings, Use&& use)
{
	while (!endings.empty())
	{
		const std::size_t end = std::min(endings.find(' '), endings.size());
		if (use(endings.substr(0, end)))
			return true;
		endings.remove_prefix(std::min(end + 1, endings.size()));
	}
	return false;
}

std::string inSmallLetters(std::string_view text)
{
	std::string name(text);
	std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
	return name;
}

// name: in small letters.
bool suits(const Format& format, std::string_view name)
{
	return anyEnding(format.endings, [&](std::string_view ending) { return name.ends_with(ending); });
}

} // namespace

std::span<const Format> formats()
{
	return kFormats;
}

const Format* findFormat(std::string_view name)
{
	const auto found = std::ranges::find(kFormats, name, &Format::name);
	return found == std::end(kFormats) ? nullptr : found;
}

const Format* formatOfEnding(std::string_view file)
{
	const std::string name = inSmallLetters(file);
	const auto found = std::ranges::find_if(kFormats, [&](const Format& f) { return suits(f, name); });
	return found == std::end(kFormats) ? nullptr : found;
}

bool mayNameFiles(std::string_view file)
{
	const std::string name = inSmallLetters(file);
	return !formatOfEnding(name) || std::ranges::any_of(kFormats, [&](const Format& format)
	                                                    { return format.files != alone && suits(format, name); });
}

std::string formatNames()
{
	std::string names;
	for (const Format& format : kFormats)
		names.append(names.empty() ? "" : " ").append(format.name);
	return names;
}

std::string readableEndings()
{
	std::set<std::string_view> known;
	std::string endings;
	for (const Format& format : kFormats)
		anyEnding(format.endings,
		          [&](std::string_view ending)
		          {
			          if (known.insert(ending).second)
				          endings.append(endings.empty() ? "" : " ").append(ending);
			          return false;
		          });
	return endings;
}

} // namespace vp::read
