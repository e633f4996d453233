#include "report/sample_points.h"

#include "base/input_files.h"
#include "base/real_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <optional>
#include <string_view>
#include <utility>

namespace vp::app
{

namespace
{

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // which some programs write before text

std::string_view trimmed(std::string_view text)
{
	text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
	return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

// The words of a line without a header: separated by blanks, or by one comma or semicolon.
std::vector<std::string_view> wordsOf(std::string_view line)
{
	constexpr std::string_view kSeparators = " \t\r\v\f,;";
	std::vector<std::string_view> words;
	for (bool is_open = true; is_open;)
	{
		line = trimmed(line);
		const std::size_t end = std::min(line.find_first_of(kSeparators), line.size());
		words.push_back(line.substr(0, end)); // empty between two commas, and behind the last one
		line = trimmed(line.substr(end));
		is_open = !line.empty();
		if (is_open && (line[0] == ',' || line[0] == ';'))
			line.remove_prefix(1);
	}
	return words;
}

// The cells of a line, at each separator that does not stand between quotation marks.
std::vector<std::string_view> cellsOf(std::string_view line, char separator)
{
	std::vector<std::string_view> cells;
	bool is_quoted = false;
	std::size_t begin = 0;
	for (std::size_t at = 0; at <= line.size(); ++at)
	{
		if (at < line.size() && line[at] == '"')
			is_quoted = !is_quoted;
		if (at < line.size() && (is_quoted || line[at] != separator))
			continue;
		std::string_view cell = trimmed(line.substr(begin, at - begin));
		if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
			cell = cell.substr(1, cell.size() - 2);
		cells.push_back(cell);
		begin = at + 1;
	}
	return cells;
}

// Without what stands behind a #.
std::string_view withoutComment(std::string_view line)
{
	bool is_quoted = false;
	for (std::size_t at = 0; at < line.size(); ++at)
	{
		is_quoted ^= line[at] == '"';
		if (line[at] == '#' && !is_quoted)
			return trimmed(line.substr(0, at));
	}
	return trimmed(line);
}

bool namesAxis(std::string_view cell, std::size_t axis)
{
	std::string name(cell.substr(0, cell.find_first_of(" [(")));
	std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
	return name == std::string(1, "xyz"[axis]) || name == fmt::format("points:{}", axis) || // as ParaView writes it
	       name == fmt::format("points_{}", axis);
}

// Which columns hold the coordinates.
class PointColumns
{
public:
	// Takes the first line if it is a header: it has columns x, y and z, or three words that are no numbers.
	bool takeHeader(std::string_view line)
	{
		for (const char separator : {';', ',', '\t'})
			if (line.find(separator) != std::string_view::npos && !separator_)
				separator_ = separator;
		const std::vector<std::string_view> cells = partsOf(line);
		const auto isNumber = [](std::string_view cell) { return parseReal(cell).has_value(); };
		if (cells[0].empty() || isNumber(cells[0]))
			return false;
		std::size_t found = 0;
		for (std::size_t axis = 0; axis < 3; ++axis)
			for (std::size_t c = cells.size(); c-- > 0;)
				if (namesAxis(cells[c], axis))
				{
					found |= std::size_t(1) << axis;
					columns_[axis] = c;
				}
		has_names_ = found == 7;
		if (!has_names_ && (cells.size() != 3 || std::any_of(cells.begin(), cells.end(), isNumber)))
			return false;
		if (!has_names_)
			columns_ = {0, 1, 2};
		is_header_ = true;
		return true;
	}

	// What is wrong with the line, or nothing.
	std::optional<std::string> parse(std::string_view line, Vec3& point) const
	{
		const std::vector<std::string_view> cells = is_header_ ? partsOf(line) : wordsOf(line);
		if (has_names_ ? cells.size() <= *std::max_element(columns_.begin(), columns_.end()) : cells.size() != 3)
			return has_names_ ? "its header names more columns" : kNoPoint;
		for (int axis = 0; axis < 3; ++axis)
		{
			const std::string_view cell = cells[columns_[static_cast<std::size_t>(axis)]];
			const std::optional<double> number = parseReal(cell);
			if (!number)
				return kNoPoint;
			if (!std::isfinite(*number))
				return fmt::format("{} is no place; leave such a point out, or write three numbers that are finite",
				                   cell);
			point[axis] = *number;
		}
		return std::nullopt;
	}

private:
	static constexpr const char* kNoPoint =
	    "no point; write three numbers, separated by blanks, commas or semicolons, or a header with x, y and z first";

	std::vector<std::string_view> partsOf(std::string_view line) const
	{
		return separator_ ? cellsOf(line, *separator_) : wordsOf(line);
	}

	std::optional<char> separator_; // none: blanks
	bool is_header_ = false;
	bool has_names_ = false;
	std::array<std::size_t, 3> columns_ = {0, 1, 2};
};

Result<std::vector<Vec3>> parsePoints(std::istream& stream, const std::string& name)
{
	std::vector<Vec3> points;
	PointColumns columns;
	bool is_first = true;
	std::string text;
	for (std::size_t number = 1; std::getline(stream, text); ++number)
	{
		std::string_view line = text;
		if (number == 1 && line.starts_with(kByteOrderMark))
			line.remove_prefix(kByteOrderMark.size());
		line = withoutComment(line);
		if (line.empty() || (std::exchange(is_first, false) && columns.takeHeader(line)))
			continue;
		Vec3 point;
		if (const std::optional<std::string> wrong = columns.parse(line, point))
			return Error{ErrorKind::input, fmt::format("{}, line {}: {}", name, number, *wrong)};
		points.push_back(point);
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
