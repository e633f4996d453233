#include "probe/path_file.h"

#include "probe/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace vp::probe
{

namespace
{

using nlohmann::json;

constexpr std::array<std::string_view, 6> kNames{"translate", "rotate", "spin", "revolve", "profile", "keyframes"};

PathKind kindOfPath(const JsonReader& reader)
{
	const std::string name = reader.text();
	const std::optional<PathKind> kind = pathKind(name);
	if (!kind)
		reader.refuse(fmt::format("no path of this name; use {}", fmt::join(kNames, ", ")));
	return *kind;
}

// Besides those that all have.
std::vector<std::string_view> ownKeys(PathKind kind)
{
	switch (kind)
	{
	case PathKind::translate:
		return {"length", "axis"};
	case PathKind::rotate:
		return {"length", "axis", "through", "degrees"};
	case PathKind::spin:
		return {"length", "degrees"};
	case PathKind::revolve:
		return {"length", "vanes"};
	case PathKind::profile:
		return {"length"};
	case PathKind::keyframes:
		return {"length", "loop", "keys"};
	}
	return {};
}

TimeUnit unitOf(const JsonReader& reader)
{
	const std::string unit = reader.text();
	if (unit != "frames" && unit != "seconds")
		reader.refuse("no unit of time; use \"frames\" or \"seconds\"");
	return unit == "frames" ? TimeUnit::frames : TimeUnit::seconds;
}

double lengthOf(const JsonReader& reader)
{
	const double length = reader.number();
	if (!(length > 0.0 && length <= kMaxFrames))
		reader.refuse(fmt::format("{} is not above 0 and up to {}; give a length that is", length, kMaxFrames));
	return length;
}

std::vector<Key> keysOf(const JsonReader& reader)
{
	reader.expectArray(2, kMaxKeys, "keys");
	std::vector<Key> keys;
	for (std::size_t k = 0; k < reader.size(); ++k)
	{
		const JsonReader item = reader.at(k);
		item.expectKeys({"at", "to_probe"});
		const JsonReader at = item["at"];
		keys.push_back({at.number(), item["to_probe"].frame()});
		if (k > 0 && !(keys[k].at > keys[k - 1].at))
			at.refuse(
			    fmt::format("{} does not come after {}; put the keys in order of time", keys[k].at, keys[k - 1].at));
		if (!(keys[k].at - keys[0].at <= kMaxFrames))
			at.refuse(
			    fmt::format("{} is more than {} after the first key; give an earlier time", keys[k].at, kMaxFrames));
	}
	return keys;
}

// The length of a film of keyframes follows from the keys, but for the way back to the first in a loop.
void checkLoop(const Path& path, const JsonReader& reader)
{
	if (path.kind != PathKind::keyframes)
		return;
	if (path.loop && path.there_and_back)
		reader["loop"].refuse("there_and_back is a loop by itself; remove one of the two");
	if (!path.loop && path.length)
		reader["length"].refuse("the keys say how long the path is; remove it, or add \"loop\": true");
	const double keyed = path.keys.back().at - path.keys.front().at;
	if (path.loop && !(reader["length"].number() > keyed))
		reader["length"].refuse(fmt::format(
		    "{} leaves no time to return to the first key; give more than the {} the keys take", *path.length, keyed));
}

Path pathOf(const JsonReader& reader)
{
	if (!reader.isObject())
		reader.expectKeys({"path"});
	Path path;
	path.kind = kindOfPath(reader["path"]);
	std::vector<std::string_view> keys = ownKeys(path.kind);
	keys.insert(keys.begin(), {"$schema", "path", "there_and_back", "unit"});
	reader.expectKeys(keys);

	if (const auto axis = reader.find("axis"))
		path.axis = axis->direction();
	if (const auto through = reader.find("through"))
		path.through = through->vector();
	if (const auto degrees = reader.find("degrees"))
		path.degrees = degrees->number();
	if (const auto vanes = reader.find("vanes"))
		path.vanes = vanes->whole(1, static_cast<int>(kMaxSheets));
	if (const auto there_and_back = reader.find("there_and_back"))
		path.there_and_back = there_and_back->flag();
	if (const auto loop = reader.find("loop"))
		path.loop = loop->flag();
	if (const auto unit = reader.find("unit"))
		path.unit = unitOf(*unit);
	if (const auto length = reader.find("length"))
		path.length = lengthOf(*length);
	if (path.kind == PathKind::keyframes)
		path.keys = keysOf(reader["keys"]);
	checkLoop(path, reader);
	return path;
}

} // namespace

std::string_view nameOf(PathKind kind)
{
	return kNames[static_cast<std::size_t>(kind)];
}

std::optional<PathKind> pathKind(std::string_view name)
{
	const auto found = std::ranges::find(kNames, name);
	if (found == kNames.end())
		return std::nullopt;
	return static_cast<PathKind>(found - kNames.begin());
}

Result<Path> pathFromJson(const json& value, const std::string& source, const std::string& path)
{
	return readDocument<Path>(value, source, path, pathOf);
}

Result<Path> parsePath(std::string_view text, const std::string& source)
{
	const Result<json> document = parseJson(text, source);
	if (!document)
		return document.error();
	return pathFromJson(*document, source, "");
}

Result<Path> readPath(const std::string& file)
{
	return readFile<Path>(file, parsePath);
}

json toJson(const Path& path)
{
	const Path standard;
	json value{{"path", nameOf(path.kind)}};
	if (path.axis)
		value["axis"] = toJson(*path.axis);
	if (path.through)
		value["through"] = toJson(*path.through);
	if (path.degrees != standard.degrees)
		value["degrees"] = path.degrees;
	if (path.vanes)
		value["vanes"] = *path.vanes;
	if (path.there_and_back)
		value["there_and_back"] = true;
	if (path.loop)
		value["loop"] = true;
	if (path.unit == TimeUnit::seconds)
		value["unit"] = "seconds";
	if (path.length)
		value["length"] = *path.length;
	for (const Key& key : path.keys)
		value["keys"].push_back({{"at", key.at}, {"to_probe", toJson(key.frame)}});
	return value;
}

std::string pathText(const Path& path)
{
	return jsonText(toJson(path));
}

} // namespace vp::probe
