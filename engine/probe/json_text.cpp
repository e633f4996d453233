#include "probe/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

namespace vp::probe
{

namespace
{

using nlohmann::json;

// A probe or a path of thousands of keys is a hundredth of it.
constexpr std::size_t kMaxText = 16 << 20;
constexpr std::size_t kMaxDepth = 32;

// Knows where in a document the parser is.
class Whereabouts
{
public:
	void see(json::parse_event_t event, const json& parsed)
	{
		using Event = json::parse_event_t;
		if (event == Event::object_start || event == Event::array_start)
		{
			if (levels_.size() == kMaxDepth)
				throw SchemaError{fmt::format("nested more than {} deep; no probe or path is", kMaxDepth)};
			levels_.push_back({event == Event::array_start, 0, {}, {}});
		}
		else if (event == Event::key)
			seeKey(parsed.get_ref<const std::string&>());
		else
		{
			if (event != Event::value)
				levels_.pop_back();
			if (!levels_.empty())
				++levels_.back().index;
		}
	}
	std::string pointer() const
	{
		std::string pointer;
		for (const Level& level : levels_)
		{
			pointer += '/';
			pointer += level.is_array ? fmt::to_string(level.index) : pointerStep(level.key);
		}
		return pointer.empty() ? "the document" : pointer;
	}

private:
	struct Level
	{
		bool is_array;
		std::size_t index;
		std::string key;
		std::set<std::string> keys;
	};

	void seeKey(const std::string& key)
	{
		Level& level = levels_.back();
		level.key = key;
		if (!level.keys.insert(key).second)
			throw SchemaError{fmt::format("{}: a key given twice; remove one", pointer())};
	}

	std::vector<Level> levels_;
};

std::string place(std::string_view text, std::size_t byte)
{
	const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
	const auto line = std::ranges::count(before, '\n') + 1;
	const std::size_t start = before.rfind('\n');
	const std::size_t column = start == std::string_view::npos ? before.size() + 1 : before.size() - start;
	return fmt::format("line {}, column {}", line, column);
}

// Names may come from files in any encoding: bytes that are no UTF-8 are replaced.
std::string dumped(const json& value)
{
	return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

void append(std::string& text, const json& value, std::size_t depth)
{
	if (!value.is_structured() || value.empty())
	{
		text += dumped(value);
		return;
	}
	const bool flat = value.is_array() && std::ranges::none_of(value, &json::is_structured);
	std::string line_end(flat ? 0 : depth + 1, '\t');
	if (!flat)
		line_end.front() = '\n';
	const char* separator = flat ? ", " : ",";
	text += value.is_array() ? '[' : '{';
	bool first = true;
	for (const auto& [key, item] : value.items())
	{
		if (!first)
			text += separator;
		first = false;
		text += line_end;
		if (!flat)
			text += '\t';
		if (value.is_object())
			text += dumped(key) + ": ";
		append(text, item, depth + 1);
	}
	text += line_end;
	text += value.is_array() ? ']' : '}';
}

} // namespace

std::string pointerStep(std::string_view key)
{
	std::string step;
	for (const char c : key)
		if (c == '~')
			step += "~0";
		else if (c == '/')
			step += "~1";
		else
			step += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
	return step;
}

Result<json> parseJson(std::string_view text, const std::string& source)
{
	const auto unusable = [&](const std::string& reason) {
		return Error{ErrorKind::input, fmt::format("{}: {}", source, reason)};
	};
	Whereabouts at;
	try
	{
		return json::parse(text,
		                   [&](int, json::parse_event_t event, const json& parsed)
		                   {
			                   at.see(event, parsed);
			                   return true;
		                   });
	}
	catch (const SchemaError& unfit)
	{
		return unusable(unfit.message);
	}
	catch (const json::parse_error& error)
	{
		return unusable(fmt::format("{}: this is no JSON; mend it (docs/PROBES.md shows how such a file looks)",
		                            place(text, error.byte)));
	}
	catch (const json::out_of_range&)
	{
		return unusable(fmt::format("{}: a number that is not finite; give one that is", at.pointer()));
	}
}

Result<std::string> readText(const std::string& file, InputKind kind)
{
	const auto unusable = [&](const char* reason) {
		return Error{ErrorKind::input, fmt::format("{}: {}", file, reason)};
	};
	std::error_code error;
	if (!std::filesystem::exists(file, error))
		return unusable("no such file; check the name");
	if (std::filesystem::is_directory(file, error))
		return unusable("a folder; name a JSON file");
	noteInput(file, kind);
	std::ifstream stream(file, std::ios::binary);
	std::string text(kMaxText + 1, '\0');
	stream.read(text.data(), static_cast<std::streamsize>(text.size()));
	text.resize(static_cast<std::size_t>(stream.gcount()));
	if (!stream.eof() && text.size() <= kMaxText)
		return unusable("cannot be read; check its permissions");
	if (text.size() > kMaxText)
		return unusable("larger than 16 MiB; name a JSON file that describes a probe or a path");
	return text;
}

std::string jsonText(const json& document)
{
	std::string text;
	append(text, document, 0);
	return text + "\n";
}

} // namespace vp::probe
