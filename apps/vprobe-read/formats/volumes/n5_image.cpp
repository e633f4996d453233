// After https://github.com/saalfeldlab/n5, and the attributes that its users agree on: those of n5-viewer,
// BigDataViewer and Paintera (downsamplingFactors, pixelResolution, resolution, offset), and those of COSEM
// (transform).
#include "n5_image.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "zarr_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

namespace fs = std::filesystem;

using Numbers = std::vector<double>;

constexpr std::size_t kMaxLevelsOfN5 = 64;
constexpr const char* kAttributes = "attributes.json";

json attributesOfN5(const fs::path& folder)
{
	std::error_code ignored;
	return fs::is_regular_file(folder / kAttributes, ignored) ? zarrJson(folder / kAttributes) : json::object();
}

json memberOfN5(const json& object, const char* key)
{
	return object.is_object() ? object.value(key, json()) : json();
}

// A list of numbers, one for each side, or for those in space alone. Nothing if there is no such list.
std::optional<Numbers> numbersOfN5(const json& given, std::size_t sides, double otherwise)
{
	if (!given.is_array() || given.empty() || given.size() > sides ||
	    !std::all_of(given.begin(), given.end(), [](const json& one) { return one.is_number(); }))
		return std::nullopt;
	auto numbers = given.get<Numbers>();
	if (!std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); }))
		return std::nullopt;
	numbers.resize(sides, otherwise);
	return numbers;
}

std::vector<std::string> textsOfN5(const json& given, std::size_t sides)
{
	if (!given.is_array() || given.size() != sides ||
	    !std::all_of(given.begin(), given.end(), [](const json& one) { return one.is_string(); }))
		return {};
	return given.get<std::vector<std::string>>();
}

// The names of the sides. Many write them as NumPy has the sides, the fastest last.
std::vector<std::string> namesOfN5(const json& about, const json& of_group, std::size_t sides)
{
	for (const json& given :
	     {memberOfN5(about, "axes"), memberOfN5(of_group, "axes"), memberOfN5(memberOfN5(about, "transform"), "axes")})
		if (auto names = textsOfN5(given, sides); !names.empty())
		{
			if (names.front() != "x" && names.back() == "x")
				std::ranges::reverse(names);
			return names;
		}
	std::vector<std::string> names = {"x", "y", "z"};
	while (names.size() < sides)
		names.push_back(fmt::format("{}", names.size() + 1));
	names.resize(sides);
	return names;
}

std::string typeOfSide(const std::string& name, std::size_t side, bool is_told)
{
	if (isOneOf(name, {"c", "channel"}))
		return "channel";
	if (isOneOf(name, {"t", "time"}))
		return "time";
	return isOneOf(name, {"x", "y", "z"}) || (!is_told && side < 3) ? "space" : "index";
}

// The distance of values, by what a data set or its group says.
std::optional<Numbers> resolutionOf(const json& about, std::size_t sides)
{
	const json pixels = memberOfN5(about, "pixelResolution");
	const json& given = pixels.is_object() ? memberOfN5(pixels, "dimensions") : pixels;
	for (const json& one : {given, memberOfN5(about, "resolution")})
		if (auto numbers = numbersOfN5(one, sides, 1.0))
			return numbers;
	return std::nullopt;
}

void takeUnitsOfN5(OmeZarr& image, const json& about)
{
	const json unit = memberOfN5(memberOfN5(about, "pixelResolution"), "unit");
	const json units = memberOfN5(about, "units");
	const auto many = textsOfN5(units, image.axes.size());
	for (std::size_t side = 0; side < image.axes.size(); ++side)
		if (OmeZarr::Axis& axis = image.axes[side]; axis.unit.empty() && axis.type == "space")
			axis.unit = !many.empty()       ? many[side]
			            : unit.is_string()  ? unit.get<std::string>()
			            : units.is_string() ? units.get<std::string>()
			                                : std::string();
}

// COSEM's words for a place, by the names of the axes. Returns false if there are none.
bool takeTransform(OmeZarr& image, OmeZarr::Level& level, const json& about)
{
	const json given = memberOfN5(about, "transform");
	const std::size_t sides = image.axes.size();
	const auto names = textsOfN5(memberOfN5(given, "axes"), sides);
	const auto scale = numbersOfN5(memberOfN5(given, "scale"), names.size(), 1.0);
	const auto translation = numbersOfN5(memberOfN5(given, "translate"), names.size(), 0.0);
	const auto units = textsOfN5(memberOfN5(given, "units"), sides);
	if (names.empty() || !scale)
		return false;
	for (std::size_t side = 0; side < sides; ++side)
		for (std::size_t i = 0; i < sides; ++i)
			if (names[i] == image.axes[side].name)
			{
				level.scale[side] = (*scale)[i];
				level.translation[side] = translation ? (*translation)[i] : 0.0;
				if (!units.empty())
					image.axes[side].unit = units[i];
			}
	return true;
}

// A level as it says itself, and as its group and the finest level say.
struct LevelOfN5
{
	json about, of_group, finest;
	std::size_t number = 0;

	std::size_t sides() const { return memberOfN5(about, "dimensions").size(); }
	std::optional<Numbers> factors() const
	{
		if (auto own = numbersOfN5(memberOfN5(about, "downsamplingFactors"), sides(), 1.0))
			return own;
		for (const char* key : {"downsamplingFactors", "scales"})
			if (const json all = memberOfN5(of_group, key); all.is_array() && number < all.size())
				if (auto factors = numbersOfN5(all[number], sides(), 1.0))
					return factors;
		return std::nullopt;
	}
	// Where nobody tells a level's factors, the numbers of its values do.
	double ratio(std::size_t side) const
	{
		const json all = memberOfN5(finest, "dimensions"), own = memberOfN5(about, "dimensions");
		if (side >= all.size() || !all[side].is_number() || !own[side].is_number() || own[side].get<double>() <= 0.0)
			return 1.0;
		return std::max(1.0, std::round(all[side].get<double>() / own[side].get<double>()));
	}
};

Numbers scaleOf(const LevelOfN5& level)
{
	const std::size_t sides = level.sides();
	const std::optional<Numbers> own = resolutionOf(level.about, sides), factors = level.factors();
	if (own && !factors)
		return *own;
	Numbers scale(sides, 1.0);
	for (const auto& given : {own, resolutionOf(level.of_group, sides), resolutionOf(level.finest, sides)})
		if (given)
		{
			scale = *given;
			break;
		}
	for (std::size_t side = 0; side < sides; ++side)
		scale[side] *= factors ? (*factors)[side] : level.ratio(side);
	return scale;
}

// A folder with a data set, or with levels, that is somewhere below.
std::string someImageBelow(const fs::path& folder)
{
	constexpr int kMaxFolders = 1000;
	std::deque<fs::path> open{folder};
	std::error_code ignored;
	for (int count = 0; !open.empty() && count < kMaxFolders; ++count, open.pop_front())
	{
		std::vector<fs::path> below;
		for (const auto& entry : fs::directory_iterator(open.front(), ignored))
			if (entry.is_directory(ignored) && !entry.is_symlink(ignored))
				below.push_back(entry.path());
		std::ranges::sort(below);
		for (const fs::path& path : below)
			if (isOfN5(attributesOfN5(path)) || isOfN5(attributesOfN5(path / "s0")))
				return path.lexically_relative(folder).generic_string();
		open.insert(open.end(), below.begin(), below.end());
	}
	return {};
}

} // namespace

OmeZarr n5Image(const fs::path& folder)
{
	LevelOfN5 level;
	level.of_group = attributesOfN5(folder);
	const bool is_lone = isOfN5(level.of_group);
	level.finest = is_lone ? level.of_group : attributesOfN5(folder / "s0");
	if (!isOfN5(level.finest))
	{
		const std::string other = someImageBelow(folder);
		throw Refusal(other.empty() ? std::string("a group of N5 without data sets")
		                            : fmt::format("a group of N5; name an image in it, such as {}", other));
	}
	OmeZarr image;
	image.images = 1;
	const std::size_t sides = memberOfN5(level.finest, "dimensions").size();
	const std::vector<std::string> names = namesOfN5(level.finest, level.of_group, sides);
	const bool is_told = std::count_if(names.begin(), names.end(),
	                                   [](const std::string& name) {
		                                   return isOneOf(name, {"x", "y", "z"});
	                                   }) > 1;
	for (std::size_t side = 0; side < sides; ++side)
		image.axes.push_back({names[side], typeOfSide(names[side], side, is_told), ""});
	std::optional<Numbers> offset = numbersOfN5(memberOfN5(level.finest, "offset"), sides, 0.0);
	if (!offset)
		offset = numbersOfN5(memberOfN5(level.of_group, "offset"), sides, 0.0);
	for (level.about = level.finest; isOfN5(level.about) && level.number < kMaxLevelsOfN5;)
	{
		if (level.sides() != sides)
			throw damaged(fmt::format("its level s{} has other sides than s0", level.number));
		OmeZarr::Level made{is_lone ? "." : fmt::format("s{}", level.number), scaleOf(level), Numbers(sides, 0.0)};
		const bool is_placed = takeTransform(image, made, level.about);
		if (!is_placed && level.number == 0)
			made.translation = offset.value_or(made.translation);
		else if (!is_placed)
			image.alignEdges(made);
		if (std::any_of(made.scale.begin(), made.scale.end(), [](double scale) { return !(scale > 0.0); }))
			throw damaged("its attributes have a resolution that is not above 0");
		image.levels.push_back(made);
		++level.number;
		level.about = is_lone ? json::object() : attributesOfN5(folder / fmt::format("s{}", level.number));
	}
	takeUnitsOfN5(image, level.finest);
	takeUnitsOfN5(image, level.of_group);
	image.orderAxes();
	return image;
}

} // namespace vp::reader::volumes
