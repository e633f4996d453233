// After https://ngff.openmicroscopy.org/0.5/ and the versions before it.
#include "ome_zarr.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

Refusal attributesNotFollowed(const std::string& what)
{
	return damaged(fmt::format("its OME-Zarr attributes cannot be followed: {}", what));
}

std::string textIn(const json& object, const char* key)
{
	const json value = object.is_object() ? object.value(key, json()) : json();
	return value.is_string() ? value.get<std::string>() : std::string();
}

json listIn(const json& object, const char* key)
{
	json value = object.is_object() ? object.value(key, json()) : json();
	return value.is_array() ? value : json::array();
}

// Versions before 0.4 give names alone, those before 0.3 nothing.
std::vector<OmeZarr::Axis> axesOf(const json& given)
{
	std::vector<OmeZarr::Axis> axes;
	for (const json& one : given.empty() ? json::array({"t", "c", "z", "y", "x"}) : given)
	{
		OmeZarr::Axis axis;
		axis.name = one.is_string() ? one.get<std::string>() : textIn(one, "name");
		axis.type = textIn(one, "type");
		axis.unit = textIn(one, "unit");
		if (axis.type.empty())
			axis.type = axis.name == "t" ? "time" : axis.name == "c" ? "channel" : "space";
		axes.push_back(axis);
	}
	return axes;
}

std::vector<double> numbersIn(const json& given, const char* key, std::size_t count)
{
	std::vector<double> numbers;
	for (const json& one : listIn(given, key))
		if (one.is_number())
			numbers.push_back(one.get<double>());
	const bool are_finite = std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); });
	if (numbers.size() != count || !are_finite)
		throw attributesNotFollowed(fmt::format("a {} without a number for each axis", key));
	return numbers;
}

// Carries out transformations in their order. Returns true if one of them is a translation.
bool transform(OmeZarr::Level& level, const json& transformations)
{
	bool is_placed = false;
	for (const json& one : transformations)
	{
		const std::string type = textIn(one, "type");
		if (type == "identity")
			continue;
		if (!isOneOf(type, {"scale", "translation"}) || one.contains("path"))
			throw Refusal(fmt::format("its places are given by {}, which is not read; write a scale and a translation",
			                          one.contains("path") ? "an array"
			                          : type.empty()       ? "nothing"
			                                               : type.substr(0, 40)));
		const std::vector<double> numbers = numbersIn(one, type.c_str(), level.scale.size());
		for (std::size_t i = 0; i < numbers.size(); ++i)
			if (type == "scale")
			{
				level.scale[i] *= numbers[i];
				level.translation[i] *= numbers[i];
			}
			else
				level.translation[i] += numbers[i];
		is_placed = is_placed || type == "translation";
	}
	if (std::any_of(level.scale.begin(), level.scale.end(), [](double scale) { return !(scale > 0.0); }))
		throw attributesNotFollowed("a scale that is not above 0");
	return is_placed;
}

// A path within the group: the files of others are none of an image's.
std::string pathOf(const json& dataset)
{
	const std::string path = textIn(dataset, "path");
	for (const std::filesystem::path& step : std::filesystem::path(path))
		if (step == ".." || step == "/")
			throw Refusal(fmt::format("its level {} lies outside of it; keep them together", path.substr(0, 80)));
	if (path.empty())
		throw attributesNotFollowed("a level without a path");
	return path;
}

void takeChannels(OmeZarr& image, const json& channels)
{
	for (const json& channel : channels)
		image.channels.push_back(textIn(channel, "label"));
	const json window = channels.empty() || !channels[0].is_object() ? json() : channels[0].value("window", json());
	if (!window.is_object())
		return;
	const json low = window.value("start", json()), high = window.value("end", json());
	if (low.is_number() && high.is_number() && low.get<double>() < high.get<double>())
		image.window = {low.get<double>(), high.get<double>()};
}

} // namespace

std::optional<OmeZarr> OmeZarr::of(const ZarrGroup& group)
{
	const json own = group.attributes.value("ome", json());
	const json& about = own.is_object() ? own : group.attributes;
	if (about.contains("plate"))
		throw Refusal("a plate of OME-Zarr; name an image in one of its wells, such as A/1/0");
	const json images = listIn(about, "multiscales");
	if (images.empty())
		return std::nullopt;
	OmeZarr image;
	image.images = images.size();
	image.axes = axesOf(listIn(images[0], "axes"));
	for (const json& dataset : listIn(images[0], "datasets"))
	{
		Level level{pathOf(dataset), std::vector<double>(image.axes.size(), 1.0),
		            std::vector<double>(image.axes.size(), 0.0)};
		const bool is_placed = transform(level, listIn(dataset, "coordinateTransformations"));
		if (!is_placed && !image.levels.empty())
			image.alignEdges(level);
		image.levels.push_back(level);
	}
	for (Level& level : image.levels)
		transform(level, listIn(images[0], "coordinateTransformations"));
	if (image.levels.empty())
		throw attributesNotFollowed("no levels");
	image.orderAxes();
	takeChannels(image, listIn(about.value("omero", json()), "channels"));
	image.labels = about.contains("image-label");
	return image;
}

void OmeZarr::alignEdges(Level& level) const
{
	for (std::size_t i = 0; i < axes.size(); ++i)
		if (axes[i].type == "space")
			level.translation[i] = levels[0].translation[i] + (level.scale[i] - levels[0].scale[i]) / 2.0;
}

void OmeZarr::orderAxes()
{
	const std::size_t space = spaceAxes();
	if (space < 2 || space > 3)
		throw Refusal(fmt::format("its image has {} axes in space where 2 or 3 are wanted", space));
	order.resize(axes.size());
	std::iota(order.begin(), order.end(), 0);
	std::stable_partition(order.begin(), order.end(), [&](std::size_t axis) { return axes[axis].type != "space"; });
	const auto first = order.end() - static_cast<std::ptrdiff_t>(space);
	// Other names say nothing of the order.
	const auto isNamed = [&](std::size_t axis) { return isOneOf(axes[axis].name, {"x", "y", "z"}); };
	if (std::all_of(first, order.end(), isNamed))
		std::stable_sort(first, order.end(), [&](std::size_t a, std::size_t b) { return axes[a].name > axes[b].name; });
	const auto turn = [&](auto& given)
	{
		auto turned = given;
		for (std::size_t i = 0; i < order.size(); ++i)
			turned[i] = given[order[i]];
		given = std::move(turned);
	};
	turn(axes);
	for (Level& level : levels)
	{
		turn(level.scale);
		turn(level.translation);
	}
}

std::optional<std::size_t> OmeZarr::axisOf(const std::string& type) const
{
	const auto found = std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) { return axis.type == type; });
	return found == axes.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - axes.begin()));
}

std::size_t OmeZarr::spaceAxes() const
{
	const auto count = std::count_if(axes.begin(), axes.end(), [](const Axis& axis) { return axis.type == "space"; });
	return static_cast<std::size_t>(count);
}

} // namespace vp::reader::volumes
