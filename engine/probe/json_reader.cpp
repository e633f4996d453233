#include "probe/json_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vp::probe
{

namespace
{

// Largest deviation of a matrix from a rigid motion. Files have only a few digits.
constexpr double kRigid = 1e-5;
constexpr double kFarthest = 1e100;

std::string_view kindOfJson(const nlohmann::json& value)
{
	if (value.is_null())
		return "null";
	if (value.is_boolean())
		return "true or false";
	if (value.is_number())
		return "a number";
	if (value.is_string())
		return "a string";
	return value.is_array() ? "an array" : "an object";
}

} // namespace

void JsonReader::refuse(const std::string& reason) const
{
	throw SchemaError{fmt::format("{}: {}", path_.empty() ? "the document" : path_, reason)};
}

std::string JsonReader::shown() const
{
	return value_.is_number() ? value_.dump() : std::string(kindOfJson(value_));
}

void JsonReader::expectKeys(const std::vector<std::string_view>& keys) const
{
	if (!value_.is_object())
		refuse(fmt::format("{} where an object with {} belongs", shown(), fmt::join(keys, ", ")));
	for (const auto& [key, value] : value_.items())
		if (std::ranges::find(keys, key) == keys.end())
			throw SchemaError{fmt::format("{}/{}: unknown key; the keys here are {}", path_, pointerStep(key),
			                              fmt::join(keys, ", "))};
}

JsonReader JsonReader::operator[](const char* key) const
{
	if (!value_.contains(key))
		refuse(fmt::format("\"{}\" is missing; add it", key));
	return {value_.at(key), fmt::format("{}/{}", path_, key)};
}

JsonReader JsonReader::at(std::size_t index) const
{
	return {value_.at(index), fmt::format("{}/{}", path_, index)};
}

std::optional<JsonReader> JsonReader::find(const char* key) const
{
	if (!value_.contains(key))
		return std::nullopt;
	return (*this)[key];
}

double JsonReader::number() const
{
	if (!value_.is_number())
		refuse(fmt::format("{} where a number belongs", shown()));
	const double number = value_.get<double>();
	if (!std::isfinite(number))
		refuse("a number that is not finite; give one that is");
	return number;
}

double JsonReader::length() const
{
	const double length = number();
	if (std::abs(length) > kFarthest)
		refuse(fmt::format("{} is not between -{} and {}; give a number that is", length, kFarthest, kFarthest));
	return length;
}

int JsonReader::whole(int least, int most) const
{
	const double n = number();
	if (n != std::floor(n) || n < least || n > most)
		refuse(fmt::format("{} is not a whole number from {} to {}; give one", shown(), least, most));
	return static_cast<int>(n);
}

bool JsonReader::flag() const
{
	if (!value_.is_boolean())
		refuse(fmt::format("{} where true or false belongs", shown()));
	return value_.get<bool>();
}

std::string JsonReader::text() const
{
	if (!value_.is_string() || value_.get_ref<const std::string&>().empty())
		refuse(fmt::format("{} where a string that is not empty belongs", value_.is_string() ? "\"\"" : shown()));
	return value_.get<std::string>();
}

void JsonReader::expectArray(std::size_t least, std::size_t most, std::string_view of) const
{
	const std::string wanted =
	    least == most ? fmt::format("{} {}", least, of) : fmt::format("{} to {} {}", least, most, of);
	if (!value_.is_array())
		refuse(fmt::format("{} where an array of {} belongs", shown(), wanted));
	if (size() < least || size() > most)
		refuse(fmt::format("an array of {} where {} belong", size(), wanted));
}

std::string JsonReader::words() const
{
	return value_.is_string() && value_.get_ref<const std::string&>().empty() ? "" : text();
}

Vec3 JsonReader::vector() const
{
	expectArray(3, 3, "numbers");
	return {at(0).length(), at(1).length(), at(2).length()};
}

Vec3 JsonReader::direction() const
{
	expectArray(3, 3, "numbers");
	const Vec3 v{at(0).number(), at(1).number(), at(2).number()};
	if (v == Vec3(0.0))
		refuse("a zero vector is no direction; give three numbers that are not all zero");
	return v;
}

std::pair<double, double> JsonReader::ascending() const
{
	expectArray(2, 2, "numbers");
	const std::pair<double, double> pair(at(0).number(), at(1).number());
	if (!(pair.first < pair.second))
		refuse(fmt::format("{} is not below {}; give the lower number first", pair.first, pair.second));
	return pair;
}

Frame JsonReader::frame() const
{
	if (has("matrix"))
	{
		expectKeys({"matrix"});
		return (*this)["matrix"].frameOfMatrix();
	}
	expectKeys({"origin", "normal", "up", "matrix"});
	Frame frame;
	if (const auto origin = find("origin"))
		frame.origin = origin->vector();
	const auto normal = find("normal");
	const auto up = find("up");
	return makeFrame(frame.origin, normal ? normal->direction() : frame.normal, up ? up->direction() : frame.up);
}

// The matrix maps into the frame; the rows of its inverse are the frame's axes and origin.
Frame JsonReader::frameOfMatrix() const
{
	expectArray(4, 4, "rows of 4 numbers");
	Transform to;
	for (std::size_t r = 0; r < 4; ++r)
	{
		const JsonReader row = at(r);
		row.expectArray(4, 4, "numbers");
		to.row[r] = {row.at(0).length(), row.at(1).length(), row.at(2).length()};
		if (row.at(3).number() != (r == 3 ? 1.0 : 0.0))
			row.at(3).refuse("the last column is 0, 0, 0, 1: points are rows, and the bottom row is the translation; "
			                 "transpose the matrix");
	}
	const auto& [x, y, z, translation] = to.row;
	const double volume = glm::dot(x, glm::cross(y, z));
	if (std::abs(volume) <= 1e-12 * glm::length(x) * glm::length(y) * glm::length(z))
		refuse("a singular matrix; give a rotation and a translation");
	const glm::dmat3 rotation(x, y, z);
	const glm::dmat3 product = glm::transpose(rotation) * rotation;
	for (int i = 0; i < 3; ++i)
		for (int j = 0; j < 3; ++j)
			if (!(std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) <= kRigid))
				refuse("a matrix that scales or shears; give a rotation and a translation, and sizes as the window or "
				       "fx");
	if (volume < 0.0)
		refuse("a matrix that mirrors; give a rotation and a translation");
	const Transform from = inverse(to);
	return makeFrame(from.row[3], from.row[2], from.row[1]);
}

nlohmann::json toJson(const Vec3& v)
{
	return {v.x, v.y, v.z};
}

nlohmann::json toJson(const Frame& frame)
{
	return {{"origin", toJson(frame.origin)}, {"normal", toJson(frame.normal)}, {"up", toJson(frame.up)}};
}

} // namespace vp::probe
