#include "report/sample_points.h"

#include "base/input_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <string_view>

namespace vp::app
{

namespace
{

constexpr std::string_view kBlanks = " \t\r\v\f";

void skipBlanks(std::string_view& text)
{
	text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
}

std::optional<double> takeNumber(std::string_view& text)
{
	skipBlanks(text);
	if (text.size() > 1 && text[0] == '+' && text[1] != '-')
		text.remove_prefix(1);
	double number = 0.0;
	const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
	if (failure != std::errc() || !std::isfinite(number))
		return std::nullopt;
	text.remove_prefix(static_cast<std::size_t>(end - text.data()));
	// What follows is another word, so "1-2" is no two numbers.
	if (!text.empty() && text[0] != ',' && kBlanks.find(text[0]) == std::string_view::npos)
		return std::nullopt;
	return number;
}

std::optional<Vec3> parsePoint(std::string_view line)
{
	Vec3 point;
	for (int axis = 0; axis < 3; ++axis)
	{
		const std::optional<double> number = takeNumber(line);
		if (!number)
			return std::nullopt;
		point[axis] = *number;
		skipBlanks(line);
		if (axis < 2 && !line.empty() && line[0] == ',')
			line.remove_prefix(1);
	}
	return line.empty() ? std::optional(point) : std::nullopt;
}

Result<std::vector<Vec3>> parsePoints(std::istream& stream, const std::string& name)
{
	std::vector<Vec3> points;
	std::string line;
	for (std::size_t number = 1; std::getline(stream, line); ++number)
	{
		if (line.find_first_not_of(kBlanks) == std::string::npos)
			continue;
		const std::optional<Vec3> point = parsePoint(line);
		if (!point)
			return Error{
			    ErrorKind::input,
			    fmt::format("{}, line {}: no point; write three numbers, parted by blanks or commas", name, number)};
		points.push_back(*point);
	}
	if (stream.bad())
		return Error{ErrorKind::input, fmt::format("{}: cannot be read; name a text file of points", name)};
	return points;
}

} // namespace

Result<std::vector<Vec3>> readPoints(const std::string& path)
{
	if (path == "-")
		return parsePoints(std::cin, "standard input");
	noteInput(path);
	std::ifstream file(path);
	if (!file)
		return Error{ErrorKind::input, fmt::format("{}: cannot be opened; name a text file of points", path)};
	return parsePoints(file, path);
}

Result<std::vector<Vec3>> pointsOnLine(const std::vector<double>& numbers)
{
	constexpr double kMaxPoints = 1e7;
	for (const double number : numbers)
		if (!std::isfinite(number))
			return Error{ErrorKind::usage, fmt::format("--line: {} is not a finite number", number)};
	const Vec3 from(numbers[0], numbers[1], numbers[2]);
	const Vec3 to(numbers[3], numbers[4], numbers[5]);
	const double count = numbers[6];
	if (!(count >= 2.0 && count <= kMaxPoints) || count != std::floor(count))
		return Error{ErrorKind::usage, fmt::format("--line: {} points cannot be; give a whole number from 2, both ends "
		                                           "counted, to {:.0f}",
		                                           count, kMaxPoints)};
	if (from == to)
		return Error{ErrorKind::usage, "--line: begins where it ends; give it a length"};
	std::vector<Vec3> points;
	for (double i = 0.0; i < count; ++i)
		points.push_back(glm::mix(from, to, i / (count - 1.0)));
	return points;
}

} // namespace vp::app
