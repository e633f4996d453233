#include "length_units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace vp::reader::text
{

namespace
{

struct LengthUnit
{
	std::string_view name;
	double meters;
	std::string_view sign; // empty: the name
};

// This includes the signs of OME's schema. Upper and lower case differ.
constexpr std::array kLengthSigns = {
    LengthUnit{"m", 1.0, ""},
    LengthUnit{"dm", 1e-1, ""},
    LengthUnit{"cm", 1e-2, ""},
    LengthUnit{"mm", 1e-3, ""},
    LengthUnit{"um", 1e-6, "µm"},
    LengthUnit{"nm", 1e-9, ""},
    LengthUnit{"pm", 1e-12, ""},
    LengthUnit{"fm", 1e-15, ""},
    LengthUnit{"am", 1e-18, ""},
    LengthUnit{"zm", 1e-21, ""},
    LengthUnit{"ym", 1e-24, ""},
    LengthUnit{"dam", 1e1, ""},
    LengthUnit{"hm", 1e2, ""},
    LengthUnit{"km", 1e3, ""},
    LengthUnit{"Mm", 1e6, ""},
    LengthUnit{"Gm", 1e9, ""},
    LengthUnit{"Tm", 1e12, ""},
    LengthUnit{"Pm", 1e15, ""},
    LengthUnit{"Em", 1e18, ""},
    LengthUnit{"Zm", 1e21, ""},
    LengthUnit{"Ym", 1e24, ""},
    LengthUnit{"A", 1e-10, "Å"},
    LengthUnit{"in", 0.0254, ""},
    LengthUnit{"\"", 0.0254, "in"},
    LengthUnit{"li", 0.0254 / 12, ""},
    LengthUnit{"thou", 2.54e-5, ""},
    LengthUnit{"mil", 2.54e-5, "thou"},
    LengthUnit{"pt", 0.0254 / 72, ""},
    LengthUnit{"ft", 0.3048, ""},
    LengthUnit{"yd", 0.9144, ""},
    LengthUnit{"mi", 1609.344, ""},
    LengthUnit{"ua", 149597870700.0, "au"},
    LengthUnit{"au", 149597870700.0, ""},
    LengthUnit{"AU", 149597870700.0, "au"},
    LengthUnit{"ly", 9460730472580800.0, ""},
    LengthUnit{"pc", 3.0856775814913673e16, ""},
    LengthUnit{"kpc", 3.0856775814913673e19, ""},
    LengthUnit{"Mpc", 3.0856775814913673e22, ""},
};

// Words in small letters, without a plural s.
constexpr std::array kLengthWords = {
    LengthUnit{"inch", 0.0254, "in"},   LengthUnit{"inche", 0.0254, "in"},
    LengthUnit{"foot", 0.3048, "ft"},   LengthUnit{"feet", 0.3048, "ft"},
    LengthUnit{"yard", 0.9144, "yd"},   LengthUnit{"mile", 1609.344, "mi"},
    LengthUnit{"micron", 1e-6, "µm"},   LengthUnit{"mu", 1e-6, "µm"},
    LengthUnit{"angstrom", 1e-10, "Å"}, LengthUnit{"ang", 1e-10, "Å"},
    LengthUnit{"mmeter", 1e-3, "mm"},   LengthUnit{"lightyear", 9.4607304725808e15, "ly"},
};

// Prefixes of "meter" and "metre".
constexpr std::array kPrefixes = {
    LengthUnit{"", 1.0, "m"},        LengthUnit{"deci", 1e-1, "dm"},   LengthUnit{"centi", 1e-2, "cm"},
    LengthUnit{"milli", 1e-3, "mm"}, LengthUnit{"micro", 1e-6, "µm"},  LengthUnit{"nano", 1e-9, "nm"},
    LengthUnit{"pico", 1e-12, "pm"}, LengthUnit{"femto", 1e-15, "fm"}, LengthUnit{"deca", 1e1, "dam"},
    LengthUnit{"hecto", 1e2, "hm"},  LengthUnit{"kilo", 1e3, "km"},    LengthUnit{"mega", 1e6, "Mm"},
};

template <std::size_t count>
const LengthUnit* find(const std::array<LengthUnit, count>& units, std::string_view name)
{
	const auto found = std::find_if(units.begin(), units.end(), [&](const LengthUnit& u) { return u.name == name; });
	return found == units.end() ? nullptr : &*found;
}

// Replaces characters that are not ASCII, in any spelling, by "u" and "A".
std::string inAscii(std::string_view unit)
{
	constexpr std::array<std::pair<std::string_view, char>, 13> spellings = {{{"\xC2\xB5", 'u'},
	                                                                          {"\xCE\xBC", 'u'},
	                                                                          {"\xC3\x85", 'A'},
	                                                                          {"\xC3\xA5", 'a'},
	                                                                          {"\xE2\x84\xAB", 'A'},
	                                                                          {"A\xCC\x8A", 'A'},
	                                                                          {"\xC3\xB6", 'o'},
	                                                                          {"\\u00B5", 'u'},
	                                                                          {"\\u00b5", 'u'},
	                                                                          {"\\u00C5", 'A'},
	                                                                          {"\xB5", 'u'},
	                                                                          {"\xC5", 'A'},
	                                                                          {"\xF6", 'o'}}};
	std::string ascii;
	while (!unit.empty())
	{
		const auto* spelling =
		    std::find_if(spellings.begin(), spellings.end(), [&](const auto& s) { return unit.starts_with(s.first); });
		const bool is_odd = spelling != spellings.end();
		ascii += is_odd ? spelling->second : unit.front();
		unit.remove_prefix(is_odd ? spelling->first.size() : 1);
	}
	return ascii;
}

std::string_view trimmedUnit(std::string_view unit)
{
	constexpr std::string_view around = " \t\r\n\v\f";
	const auto first = unit.find_first_not_of(around);
	return first == unit.npos ? std::string_view() : unit.substr(first, unit.find_last_not_of(around) - first + 1);
}

const LengthUnit* unitNamed(std::string_view name)
{
	std::string unit = inAscii(trimmedUnit(name));
	if (const LengthUnit* sign = find(kLengthSigns, unit))
		return sign;
	std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
	if (unit.size() > 2 && unit.ends_with('s'))
		unit.pop_back();
	if (const LengthUnit* word = find(kLengthWords, unit))
		return word;
	for (const std::string_view meter : {"meter", "metre"})
		if (unit.ends_with(meter))
			return find(kPrefixes, std::string_view(unit).substr(0, unit.size() - meter.size()));
	// This finds signs that are all in capital letters, such as "MM".
	return unit.size() == 2 && unit != "mi" ? find(kLengthSigns, unit) : nullptr;
}

bool isNoLength(std::string_view unit)
{
	std::string word(trimmedUnit(unit));
	std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
	return word.empty() || word == "pixel" || word == "pixels" || word == "voxel" || word == "px" ||
	       word == "reference frame" || word == "none" || word == "unknown" || word == "?";
}

} // namespace

std::optional<double> metersOf(std::string_view unit)
{
	const LengthUnit* known = unitNamed(unit);
	return known ? std::optional(known->meters) : std::nullopt;
}

std::string lengthSign(std::string_view unit)
{
	if (const LengthUnit* known = unitNamed(unit))
		return std::string(known->sign.empty() ? known->name : known->sign);
	return isNoLength(unit) ? std::string() : std::string(trimmedUnit(unit));
}

OneLengthUnit oneLengthUnit(const std::array<std::string, 3>& units)
{
	OneLengthUnit one;
	const std::array<std::string, 3> signs = {lengthSign(units[0]), lengthSign(units[1]), lengthSign(units[2])};
	if (signs[0] == signs[1] && signs[1] == signs[2])
	{
		one.sign = signs[0];
		return one;
	}
	std::array<std::optional<double>, 3> meters;
	for (std::size_t axis = 0; axis < 3; ++axis)
		meters[axis] = metersOf(units[axis]);
	if (!meters[0] || !meters[1] || !meters[2])
	{
		one.differ = true;
		return one;
	}
	one.sign = signs[0];
	for (std::size_t axis = 1; axis < 3; ++axis)
		one.factors[axis] = *meters[axis] / *meters[0];
	return one;
}

std::string unitsDiffer(const std::array<std::string, 3>& units)
{
	std::vector<std::string> words;
	for (const std::string& unit : units)
		words.push_back(trimmedUnit(unit).empty() ? "none" : unit);
	return fmt::format("the units of its axes ({}) cannot be converted into one; lengths are shown as they are",
	                   fmt::join(words, ", "));
}

} // namespace vp::reader::text
