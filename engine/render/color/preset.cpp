#include "render/color/preset.h"

#include "base/control_letters.h"
#include "render/color/color_spaces.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace vp::render
{

namespace
{

using nlohmann::json;

constexpr std::size_t kMaxPresetNumbers = 400'000; // largest number of entries in a preset's list
constexpr std::size_t kMaxCategories = 1024;

Error badPreset(const std::string& what)
{
	return {ErrorKind::input, withEscapes(what)}; // words of the file may have several lines
}

// The numbers of a list in groups of `group`; none where the preset lacks it.
Result<std::vector<double>> numbersOf(const json& preset, const char* key, std::size_t group)
{
	std::vector<double> numbers;
	if (!preset.contains(key))
		return numbers;
	const json& list = preset[key];
	const bool fits = list.is_array() && list.size() % group == 0 && list.size() <= kMaxPresetNumbers &&
	                  std::all_of(list.begin(), list.end(), [](const json& n) { return n.is_number(); });
	if (!fits)
		return badPreset(fmt::format("{} must be a list of numbers, {} for each", key, group));
	for (const json& number : list)
		numbers.push_back(number.get<double>());
	if (!std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); }))
		return badPreset(fmt::format("{} must be finite numbers", key));
	return numbers;
}

// Returns true if all of `channels` numbers from `first` on, in groups of `group`, are from 0 to 1.
bool colorsAreParts(const std::vector<double>& numbers, std::size_t group, std::size_t first, std::size_t channels)
{
	for (std::size_t i = 0; i < numbers.size(); i += group)
		for (std::size_t c = first; c < first + channels; ++c)
			if (!(numbers[i + c] >= 0.0 && numbers[i + c] <= 1.0))
				return false;
	return true;
}

bool ascending(const std::vector<double>& numbers, std::size_t group)
{
	for (std::size_t i = group; i < numbers.size(); i += group)
		if (numbers[i] < numbers[i - group])
			return false;
	return true;
}

Result<ColorSpace> spaceOf(const json& preset)
{
	if (!preset.contains("ColorSpace"))
		return ColorSpace::rgb;
	const std::string name = preset["ColorSpace"].is_string() ? preset["ColorSpace"].get<std::string>() : std::string();
	if (name == "RGB")
		return ColorSpace::rgb;
	if (name == "HSV")
		return ColorSpace::hsv;
	if (name == "Lab" || name == "CIELAB" || name == "Lab/CIEDE2000")
		return ColorSpace::lab;
	if (name == "Diverging")
		return ColorSpace::diverging;
	if (name == "Step")
		return ColorSpace::step;
	return badPreset(fmt::format("ColorSpace '{}' is not known; write RGB, HSV, Lab, Diverging or Step", name));
}

// The last point at or before x, at most the last but one.
std::size_t intervalOf(const std::vector<double>& points, std::size_t group, double x)
{
	std::size_t i = 0;
	while ((i + 2) * group < points.size() && points[(i + 1) * group] <= x)
		++i;
	return i * group;
}

double partOf(double x, double from, double to)
{
	return to > from ? std::clamp((x - from) / (to - from), 0.0, 1.0) : 1.0;
}

Rgb presetColorAt(const std::vector<double>& points, double x, ColorSpace space)
{
	const double* a = &points[intervalOf(points, 4, x)];
	const double* b = a + 4;
	const double part = partOf(x, a[0], b[0]);
	// At a point, its own color: only behind it the step's next one begins.
	if (part == 0.0)
		return {a[1], a[2], a[3]};
	return between({a[1], a[2], a[3]}, {b[1], b[2], b[3]}, part, space);
}

bool isOff(const json& preset, const char* key)
{
	return preset.contains(key) && (preset[key] == false || preset[key] == 0);
}

bool isOn(const json& preset, const char* key)
{
	return preset.contains(key) && (preset[key] == true || preset[key] == 1);
}

Status setColors(const json& preset, ColorMap& map)
{
	auto points = numbersOf(preset, "RGBPoints", 4);
	if (!points)
		return points.error();
	if (points->size() < 8 || !ascending(*points, 4) || !colorsAreParts(*points, 4, 1, 3) ||
	    !((*points)[points->size() - 4] > points->front()))
		return badPreset("RGBPoints must be two or more points x, r, g, b, with ascending x and colors from 0 to 1");
	auto space = spaceOf(preset);
	if (!space)
		return space.error();
	auto opacities = isOff(preset, "EnableOpacityMapping") ? Result<std::vector<double>>(std::vector<double>())
	                                                       : numbersOf(preset, "Points", 4);
	if (!opacities)
		return opacities.error();
	if (!opacities->empty() &&
	    (opacities->size() < 8 || !ascending(*opacities, 4) || !colorsAreParts(*opacities, 4, 1, 3)))
		return badPreset(
		    "Points must be two or more points x, alpha, midpoint, sharpness, with ascending x and the others "
		    "from 0 to 1");
	const double lo = points->front();
	const double hi = (*points)[points->size() - 4];
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const double x = lo + (hi - lo) * i / (kColorMapSize - 1);
		map.colors[i] =
		    colorOf(presetColorAt(*points, x, *space), opacities->empty() ? 1.0 : presetOpacity(*opacities, x));
	}
	return Nothing{};
}

std::optional<double> number(const json& value)
{
	if (value.is_number())
		return value.get<double>();
	if (!value.is_string())
		return std::nullopt;
	const std::string text = value.get<std::string>();
	double parsed = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
	if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(parsed))
		return std::nullopt;
	return parsed;
}

// Colors are taken in turn, and again from the first where there are more annotations. Without annotations they stand
// for 0, 1, 2 …
Status setCategories(const json& preset, ColorMap& map)
{
	auto colors = numbersOf(preset, "IndexedColors", 3);
	if (!colors)
		return colors.error();
	if (colors->empty() || !colorsAreParts(*colors, 3, 0, 3))
		return badPreset("IndexedColors must be one or more colors r, g, b from 0 to 1");
	const std::size_t count = colors->size() / 3;
	const auto color = [&](std::size_t i)
	{
		const double* c = &(*colors)[3 * (i % count)];
		return colorOf({c[0], c[1], c[2]});
	};
	const json notes = preset.value("Annotations", json::array());
	if (!notes.is_array() || notes.size() % 2 != 0)
		return badPreset("Annotations must be a list of values and names in turn");
	for (std::size_t i = 0; i < notes.size() / 2; ++i)
	{
		const auto value = number(notes[2 * i]);
		if (!value || !notes[2 * i + 1].is_string())
			return badPreset(fmt::format("Annotations: entry {} must be a number and a name", i));
		const std::string name = oneLine(notes[2 * i + 1]);
		map.categories.push_back({*value, name.empty() ? fmt::format("{}", *value) : name, color(i)});
	}
	if (notes.empty())
		for (std::size_t i = 0; i < count; ++i)
			map.categories.push_back({double(i), fmt::format("{}", i), color(i)});
	if (map.categories.size() > kMaxCategories)
		return badPreset(fmt::format("{} categories are more than a legend takes; leave up to {}",
		                             map.categories.size(), kMaxCategories));
	std::sort(map.categories.begin(), map.categories.end(),
	          [](const Category& a, const Category& b) { return a.value < b.value; });
	const auto same = std::adjacent_find(map.categories.begin(), map.categories.end(),
	                                     [](const Category& a, const Category& b) { return a.value == b.value; });
	if (same != map.categories.end())
		return badPreset(fmt::format("Annotations name the value {} twice; leave one", same->value));
	for (int i = 0; i < kColorMapSize; ++i)
		map.colors[i] = map.categories[i % map.categories.size()].color;
	return Nothing{};
}

Status takeColor(const json& preset, const char* key, Color& to)
{
	auto numbers = numbersOf(preset, key, 3);
	if (!numbers)
		return numbers.error();
	if (numbers->empty())
		return Nothing{};
	if (numbers->size() != 3 || !colorsAreParts(*numbers, 3, 0, 3))
		return badPreset(fmt::format("{} must be three numbers from 0 to 1", key));
	to = colorOf({(*numbers)[0], (*numbers)[1], (*numbers)[2]});
	return Nothing{};
}

} // namespace

double presetOpacity(const std::vector<double>& points, double x)
{
	const double* a = &points[intervalOf(points, 4, x)];
	const double* b = a + 4;
	double s = partOf(x, a[0], b[0]);
	const double midpoint = std::clamp(a[2], 1e-5, 1.0 - 1e-5);
	s = s < midpoint ? 0.5 * s / midpoint : 0.5 + 0.5 * (s - midpoint) / (1.0 - midpoint);
	const double sharpness = a[3];
	if (sharpness > 0.99)
		return s < 0.5 ? a[1] : b[1];
	if (sharpness < 0.01)
		return (1.0 - s) * a[1] + s * b[1];
	const double power = 1.0 + 10.0 * sharpness;
	s = s < 0.5 ? 0.5 * std::pow(2.0 * s, power) : 1.0 - 0.5 * std::pow(2.0 * (1.0 - s), power);
	const double slope = (1.0 - sharpness) * (b[1] - a[1]);
	const double s2 = s * s;
	const double s3 = s2 * s;
	const double value = (2.0 * s3 - 3.0 * s2 + 1.0) * a[1] + (3.0 * s2 - 2.0 * s3) * b[1] +
	                     (s3 - 2.0 * s2 + s) * slope + (s3 - s2) * slope;
	return std::clamp(value, std::min(a[1], b[1]), std::max(a[1], b[1]));
}

std::string oneLine(const json& words)
{
	std::string text = words.is_string() ? words.get<std::string>() : std::string();
	std::replace_if(
	    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
	return text;
}

Result<ColorMap> colorMapOf(const json& preset)
{
	ColorMap map;
	const bool categories =
	    preset.contains("IndexedColors") && (!preset.contains("RGBPoints") || isOn(preset, "IndexedLookup"));
	if (!categories && !preset.contains("RGBPoints"))
		return badPreset("has neither RGBPoints nor IndexedColors; export the color map from ParaView again");
	if (Status set = categories ? setCategories(preset, map) : setColors(preset, map); !set)
		return set.error();
	if (Status set = takeColor(preset, "NanColor", map.nan); !set)
		return set.error();
	map.marks_below = isOn(preset, "UseBelowRangeColor");
	map.marks_above = isOn(preset, "UseAboveRangeColor");
	if (map.marks_below)
		if (Status set = takeColor(preset, "BelowRangeColor", map.below); !set)
			return set.error();
	if (map.marks_above)
		if (Status set = takeColor(preset, "AboveRangeColor", map.above); !set)
			return set.error();
	return map;
}

} // namespace vp::render
