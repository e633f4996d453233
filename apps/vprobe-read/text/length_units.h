#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace vp::reader::text
{

// Returns the meters in a unit of length, by any name that programs write: "mm", "Millimeters", "micron", "nm", and µm
// and Å with either character that looks so (U+00B5, U+03BC; U+00C5, U+212B), in UTF-8, Latin-1 or as "\u00B5". For
// signs, upper and lower case differ (Mm is not mm); for words they do not. Returns nothing for other words, such as
// pixels.
std::optional<double> metersOf(std::string_view unit);

// Returns the usual sign: "µm" for microns. Empty if the word does not say a length (pixels). Other words stay as they
// are.
std::string lengthSign(std::string_view unit);

// One unit for the lengths along three axes: their common unit, or else the unit of the first axis.
struct OneLengthUnit
{
	std::string sign;                             // empty: not known
	std::array<double, 3> factors{1.0, 1.0, 1.0}; // what lengths in the axes' own units are multiplied with
	bool differ = false;                          // the units differ and cannot be converted; the factors are 1
};
OneLengthUnit oneLengthUnit(const std::array<std::string, 3>& units);

// Returns the warning for units that differ.
std::string unitsDiffer(const std::array<std::string, 3>& units);

} // namespace vp::reader::text
