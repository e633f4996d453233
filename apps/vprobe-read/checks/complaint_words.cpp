#include "complaint_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <optional>

namespace vp::reader::checks
{

namespace
{

constexpr std::size_t kMaxName = 120;

std::string lowered(std::string_view text)
{
	std::string small(text);
	std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
	return small;
}

bool holdsOne(std::string_view text, std::initializer_list<std::string_view> signs)
{
	return std::ranges::any_of(signs, [&](std::string_view sign) { return text.find(sign) != text.npos; });
}

// Returns the number behind a word, as in "line 12".
std::optional<std::string> numberAfter(std::string_view text, std::string_view word)
{
	const std::size_t at = text.find(word);
	if (at == text.npos)
		return std::nullopt;
	std::string_view rest = text.substr(at + word.size());
	const auto end = std::ranges::find_if_not(rest, [](unsigned char c) { return std::isdigit(c) != 0; });
	const auto digits = static_cast<std::size_t>(end - rest.begin());
	return digits > 0 && digits < 12 ? std::optional(std::string(rest.substr(0, digits))) : std::nullopt;
}

// Returns the first word that is a path.
std::string pathIn(std::string_view text)
{
	for (std::size_t at = text.find('/'); at != text.npos; at = text.find('/', at + 1))
	{
		const std::size_t begin = text.find_last_of(" \"'(", at);
		const std::size_t from = begin == text.npos ? 0 : begin + 1;
		std::string_view word = text.substr(from, text.find_first_of(" \"')", at) - from);
		while (!word.empty() && (word.back() == ':' || word.back() == '.' || word.back() == ',' || word.back() == '!'))
			word.remove_suffix(1);
		if (word.size() > 1 && word.size() <= 4096)
			return std::string(word);
	}
	return {};
}

// Returns the text between double quotes, which is mostly the name of an array.
std::string quotedIn(std::string_view text)
{
	const std::size_t begin = text.find('"');
	const std::size_t end = begin == text.npos ? begin : text.find('"', begin + 1);
	return end == text.npos ? std::string() : std::string(text.substr(begin + 1, std::min(end - begin - 1, kMaxName)));
}

struct Meaning
{
	std::string_view sign; // in small letters
	std::string_view words;
};

// The most specific meanings come first.
constexpr std::array kMeanings = {
    Meaning{"don't match", "a field has another size than the mesh"},
    Meaning{"do not match", "two of its parts that belong together have different sizes"},
    Meaning{"mismatch", "two of its parts that belong together have different sizes"},
    Meaning{"may lose precision", "its numbers of cells and points are too large to be read"},
    Meaning{"compress", "what is packed in it cannot be unpacked"},
    Meaning{"decod", "what is packed in it cannot be unpacked"},
    Meaning{"end of file", "it ends too early"},
    Meaning{"eof", "it ends too early"},
    Meaning{"premature", "it ends too early"},
    Meaning{"too short", "one of its arrays is shorter than it should be"},
    Meaning{"binary data", "the bytes of one of its arrays are missing"},
    Meaning{"ascii data", "a number is missing, or something else stands in its place"},
    Meaning{"file operation failed", "it ends too early"},
    Meaning{"data type", "one of its arrays has an unknown type of numbers"},
    Meaning{"points", "its points cannot be read"},
    Meaning{"connectivity", "its cells cannot be read"},
    Meaning{"cell", "its cells cannot be read"},
    Meaning{"extent", "the size of its grid is missing, or fits nothing"},
    Meaning{"header", "its header cannot be followed"},
    Meaning{"version", "its version is unknown"},
};

std::string meaningOf(std::string_view complaint)
{
	const std::string small = lowered(complaint);
	const std::string path = pathIn(complaint);
	const bool opens = holdsOne(small, {"cannot open", "can't open", "could not open", "couldn't open", "not be opened",
	                                    "unable to open", "failed to open", "error opening", "does not exist",
	                                    "no such file", "not found", "cannot be found", "can't find"});
	if (opens && holdsOne(small, {"file", "director", "folder", "open"}))
		return path.empty() ? "a file or folder that belongs to it is missing or cannot be opened"
		                    : fmt::format("{} is missing or cannot be opened", path);
	if (small.find("xml") != small.npos && numberAfter(small, "line "))
		return "its XML is not well-formed";
	const std::string array = quotedIn(complaint);
	if (!array.empty() && small.find("array") != small.npos)
		return fmt::format("its array {} cannot be read", array);
	const auto known =
	    std::ranges::find_if(kMeanings, [&](const Meaning& meaning) { return small.find(meaning.sign) != small.npos; });
	return known != kMeanings.end() ? std::string(known->words) : "its contents do not follow its format";
}

} // namespace

bool tellsOfMemory(std::string_view complaint)
{
	return holdsOne(lowered(complaint), {"allocat", "out of memory", "bad_alloc", "insufficient memory"});
}

std::string inOurWords(std::string_view complaint)
{
	std::string words = meaningOf(complaint);
	if (const auto line = numberAfter(lowered(complaint), "line "))
	{
		const std::string path = pathIn(complaint);
		words += path.empty() || words.find(path) != words.npos ? fmt::format(", at line {}", *line)
		                                                        : fmt::format(", at line {} of {}", *line, path);
	}
	return words;
}

} // namespace vp::reader::checks
