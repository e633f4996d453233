#include "render/color/color_map_file.h"

#include "base/input_files.h"
#include "render/color/preset.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vp::render
{

namespace
{

using nlohmann::json;

// Presets are a few kilobytes; a file of data given by mistake is not read to its end.
constexpr std::uintmax_t kLargestFile = std::uintmax_t(16) << 20;
// No preset is nested more deeply, and millions of levels would fill the stack. What lies deeper is left out.
constexpr int kMaxDepth = 32;

Error badColorMap(const std::string& file, const std::string& what)
{
	return {ErrorKind::input, fmt::format("`colormap` {}: {}", file, what)};
}

std::string nameOf(const json& preset)
{
	return preset.is_object() && preset.contains("Name") ? oneLine(preset["Name"]) : std::string();
}

Result<json> choosePreset(json document, const std::string& file, const std::string& name)
{
	if (document.is_object())
		document = json::array({document});
	if (!document.is_array() || document.empty())
		return badColorMap(file, "holds no color map; export one from ParaView (Color Map Editor, Export)");
	if (name.empty() && document.size() == 1)
		return document[0];
	std::string names;
	std::size_t told = 0;
	for (const json& preset : document)
	{
		if (!name.empty() && nameOf(preset) == name)
			return preset;
		if (told++ < 5)
			names += (names.empty() ? "" : ", ") + nameOf(preset);
	}
	if (told > 5)
		names += " …";
	return name.empty() ? badColorMap(file, fmt::format("holds {} color maps; choose one as {}:NAME of {}",
	                                                    document.size(), file, names))
	                    : badColorMap(file, fmt::format("holds no color map '{}'; take one of {}", name, names));
}

// A name of ours or a file's map, as it stands there.
Result<ColorMap> named(const std::string& text)
{
	const auto ending = text.rfind(".json");
	if (ending == std::string::npos)
		return makeColorMap(text);
	const std::string file = text.substr(0, ending + 5);
	const std::string rest = text.substr(ending + 5);
	if (rest.empty())
		return readColorMap(file);
	if (rest.front() == ':')
		return readColorMap(file, rest.substr(1));
	return makeColorMap(text);
}

} // namespace

Result<ColorMap> parseColorMap(std::string_view text, const std::string& file, const std::string& preset)
{
	const auto is_shallow = [](int depth, json::parse_event_t, const json&) { return depth <= kMaxDepth; };
	json document = json::parse(text, is_shallow, false);
	if (document.is_discarded())
		return badColorMap(file, "is not JSON; export the color map from ParaView again");
	auto chosen = choosePreset(std::move(document), file, preset);
	if (!chosen)
		return chosen.error();
	if (!chosen->is_object())
		return badColorMap(file, "a color map must be an object with RGBPoints or IndexedColors");
	auto made = colorMapOf(*chosen);
	if (!made)
		return badColorMap(file, made.error().message);
	made->name = !nameOf(*chosen).empty() ? nameOf(*chosen) : std::filesystem::path(file).stem().string();
	return made;
}

Result<ColorMap> readColorMap(const std::string& file, const std::string& preset)
{
	std::error_code error;
	const auto size = std::filesystem::file_size(file, error);
	if (error)
		return badColorMap(file, "cannot be read; check the name");
	if (size > kLargestFile)
		return badColorMap(file, "is too large for a color map; give a JSON file of ParaView's presets");
	noteInput(file);
	std::ifstream stream(file, std::ios::binary);
	const std::string text{std::istreambuf_iterator<char>(stream), {}};
	if (!stream && text.empty())
		return badColorMap(file, "cannot be read; check its permissions");
	return parseColorMap(text, file, preset);
}

Result<ColorMap> chooseColorMap(const std::string& text)
{
	auto as_it_stands = named(text);
	if (as_it_stands || !text.ends_with("_r"))
		return as_it_stands;
	auto forward = named(text.substr(0, text.size() - 2));
	if (!forward)
		return forward.error().kind == ErrorKind::usage ? as_it_stands.error() : forward.error();
	ColorMap map = reversed(std::move(*forward));
	map.name += "_r";
	return map;
}

} // namespace vp::render
