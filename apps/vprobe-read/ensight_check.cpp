#include "ensight_check.h"

#include "refusal.h"
#include "text_end.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace
{

// A structure that this check does not know; not an error.
struct NotUnderstood
{
};

using Words = std::vector<std::string>;

Words wordsOf(const std::string& line)
{
	std::istringstream in(line);
	Words words;
	for (std::string word; in >> word;)
		words.push_back(word);
	return words;
}

// Walks through a text or C binary file. Whatever lies past the end throws, but for a line that may be missing.
class Cursor
{
public:
	explicit Cursor(const std::string& file, bool is_geometry)
	    : name_(std::filesystem::path(file).filename().string()), in_(file, std::ios::binary)
	{
		std::error_code none;
		size_ = std::filesystem::file_size(file, none);
		if (!in_ || none)
			throw Refusal(fmt::format("its file {} cannot be opened; keep them together", name_));
		if (!is_geometry)
			return;
		std::array<char, 80> head = {};
		in_.read(head.data(), head.size());
		const std::string_view text(head.data(), head.size());
		binary_ = text.starts_with("C Binary");
		if (text.starts_with("Fortran Binary"))
			throw NotUnderstood();
		in_.clear();
		in_.seekg(binary_ ? 80 : 0);
	}

	bool binary() const { return binary_; }
	void setBinary(bool binary) { binary_ = binary; }

	// Empty at the end.
	std::string line()
	{
		std::string text;
		if (binary_)
		{
			const std::uint64_t left = size_ - std::min<std::uint64_t>(size_, static_cast<std::uint64_t>(in_.tellg()));
			if (left == 0)
				return {};
			text.resize(80);
			if (left < 80 || !in_.read(text.data(), 80))
				endsEarly();
			return text.substr(0, std::min(text.find('\0'), text.size()));
		}
		while (std::getline(in_, text))
			if (const auto start = text.find_first_not_of(" \t\r"); start != text.npos && text[start] != '#')
				return text;
		return {};
	}

	std::int64_t integer()
	{
		if (!binary_)
		{
			const Words words = wordsOf(line());
			if (words.empty())
				endsEarly();
			return std::atoll(words[0].c_str());
		}
		std::uint32_t value = 0;
		if (!in_.read(reinterpret_cast<char*>(&value), 4))
			endsEarly();
		// Either byte order; counts are smaller than the file.
		return value <= size_ ? value : __builtin_bswap32(value);
	}

	// So many numbers, which in text stand on so many lines.
	void skip(std::int64_t numbers, std::int64_t lines)
	{
		if (numbers < 0 || lines < 0 || static_cast<std::uint64_t>(numbers) > size_)
			endsEarly();
		if (binary_)
		{
			in_.seekg(numbers * 4, std::ios::cur);
			if (!in_ || static_cast<std::uint64_t>(in_.tellg()) > size_)
				endsEarly();
			return;
		}
		for (; lines > 0; --lines)
			if (line().empty())
				endsEarly();
	}
	void skip(std::int64_t numbers) { skip(numbers, numbers); }

	std::int64_t sumOf(std::int64_t count)
	{
		std::int64_t sum = 0;
		for (std::int64_t i = 0; i < count; ++i)
			sum += integer();
		return sum;
	}

	[[noreturn]] void endsEarly() const { throw damaged(fmt::format("{} ends early", name_)); }

private:
	std::string name_;
	std::ifstream in_;
	std::uint64_t size_ = 0;
	bool binary_ = false;
};

struct Part
{
	std::int64_t points = 0;
	std::int64_t cells = 0; // of a block
	std::map<std::string, std::int64_t> elements;
};

using Parts = std::map<std::int64_t, Part>;

int nodesOf(const std::string& type)
{
	static const std::map<std::string, int> nodes = {{"point", 1},    {"bar2", 2},     {"bar3", 3},       {"tria3", 3},
	                                                 {"tria6", 6},    {"quad4", 4},    {"quad8", 8},      {"tetra4", 4},
	                                                 {"tetra10", 10}, {"pyramid5", 5}, {"pyramid13", 13}, {"hexa8", 8},
	                                                 {"hexa20", 20},  {"penta6", 6},   {"penta15", 15}};
	const auto found = nodes.find(type);
	if (found == nodes.end())
		throw NotUnderstood();
	return found->second;
}

void walkBlock(Cursor& file, const std::string& options, Part& part)
{
	std::array<std::int64_t, 3> n;
	if (file.binary())
		for (std::int64_t& each : n)
			each = file.integer();
	else
	{
		std::istringstream words(file.line());
		if (!(words >> n[0] >> n[1] >> n[2]))
			file.endsEarly();
	}
	part.points = n[0] * n[1] * n[2];
	part.cells =
	    std::max<std::int64_t>(n[0] - 1, 1) * std::max<std::int64_t>(n[1] - 1, 1) * std::max<std::int64_t>(n[2] - 1, 1);
	const bool rectilinear = options.find("rectilinear") != options.npos;
	const bool uniform = options.find("uniform") != options.npos;
	if (options.find("ghost") != options.npos || options.find("range") != options.npos)
		throw NotUnderstood();
	file.skip(rectilinear ? n[0] + n[1] + n[2] : uniform ? 6 : 3 * part.points);
	if (options.find("iblanked") != options.npos)
		file.skip(part.points);
}

void walkElements(Cursor& file, const std::string& type, bool with_ids, Part& part)
{
	const std::int64_t count = file.integer();
	part.elements[type] += count;
	if (with_ids)
		file.skip(count);
	if (type == "nsided")
		file.skip(file.sumOf(count), count);
	else if (type == "nfaced")
	{
		const std::int64_t faces = file.sumOf(count);
		file.skip(file.sumOf(faces), faces);
	}
	else
		file.skip(count * nodesOf(type), count);
}

Parts walkGeometry(Cursor& file)
{
	Parts parts;
	if (const std::string first = file.line(); first.starts_with("BEGIN TIME STEP"))
		throw NotUnderstood();
	file.line();
	const auto has_ids = [](const std::string& line)
	{ return line.find("given") != line.npos || line.find("ignore") != line.npos; };
	const bool node_ids = has_ids(file.line());
	const bool element_ids = has_ids(file.line());
	std::string line = file.line();
	if (line.starts_with("extents"))
	{
		file.skip(6, 3);
		line = file.line();
	}
	while (line.starts_with("part"))
	{
		Part& part = parts[file.integer()];
		file.line();
		for (line = file.line(); !line.empty() && !line.starts_with("part"); line = file.line())
		{
			const Words words = wordsOf(line);
			if (words.empty())
				throw NotUnderstood();
			if (words[0] == "block")
				walkBlock(file, line, part);
			else if (words[0] == "coordinates")
			{
				part.points = file.integer();
				file.skip((node_ids ? 4 : 3) * part.points);
			}
			else
				walkElements(file, words[0], element_ids, part);
		}
	}
	if (!line.empty())
		throw NotUnderstood();
	return parts;
}

void walkVariable(Cursor& file, const Parts& parts, bool per_node, std::int64_t components)
{
	if (file.line().starts_with("BEGIN TIME STEP"))
		throw NotUnderstood();
	std::string line = file.line();
	const bool any_part = line.starts_with("part");
	while (line.starts_with("part"))
	{
		std::set<std::string> seen;
		const auto found = parts.find(file.integer());
		if (found == parts.end())
			throw NotUnderstood();
		const Part& part = found->second;
		line = file.line();
		if (line.empty())
			file.endsEarly();
		for (; !line.empty() && !line.starts_with("part"); line = file.line())
		{
			const Words words = wordsOf(line);
			if (words.size() != 1)
				throw NotUnderstood(); // undef and partial
			if (words[0] == "coordinates" || (words[0] == "block" && per_node))
				file.skip(components * part.points);
			else if (words[0] == "block")
				file.skip(components * part.cells);
			else if (const auto count = part.elements.find(words[0]); count != part.elements.end())
				file.skip(components * count->second);
			else if (file.line().empty())
				file.endsEarly(); // within this word
			else
				throw NotUnderstood();
			seen.insert(words[0]);
		}
		for (const auto& [type, count] : part.elements)
			if (!per_node && count > 0 && !seen.contains(type) && line.empty())
				file.endsEarly();
	}
	if (line.empty() && !any_part)
		file.endsEarly();
	if (!line.empty() && file.line().empty())
		file.endsEarly();
}

// The case file: its geometry and variables, and the time sets that number their files.
struct Case
{
	struct Entry
	{
		std::string kind;
		Words words;
	};
	Entry geometry;
	std::vector<Entry> variables;
	struct TimeSet
	{
		std::vector<double> numbers; // of the files
		std::vector<double> times;
		double start = 0.0;
		double increment = 1.0;
	};
	std::map<std::string, TimeSet> sets;
};

Case readCase(const std::string& name)
{
	Case about;
	std::ifstream in(name);
	std::string section, set, key;
	for (std::string line; std::getline(in, line);)
	{
		const auto colon = line.find(':');
		const Words words = wordsOf(colon == line.npos ? line : line.substr(colon + 1));
		if (line.starts_with("#") || wordsOf(line).empty())
			continue;
		if (colon == line.npos && words.size() == 1 && std::isupper(static_cast<unsigned char>(line[0])))
			section = words[0];
		if (colon != line.npos)
			key = fmt::format("{}", fmt::join(wordsOf(line.substr(0, colon)), " "));
		if (section == "FORMAT" && key == "type" && (words.size() < 2 || words[1] != "gold"))
			throw NotUnderstood();
		if (section == "GEOMETRY" && key == "model" && colon != line.npos)
			about.geometry = {key, words};
		if (section == "VARIABLE" && colon != line.npos)
			about.variables.push_back({key, words});
		if (section != "TIME" || (colon == line.npos && words[0] == "TIME"))
			continue;
		if (key == "time set")
			set = words.empty() ? "" : words[0];
		Case::TimeSet& times = about.sets[set];
		for (const std::string& word : words)
		{
			const double value = std::atof(word.c_str());
			if (key == "time values")
				times.times.push_back(value);
			else if (key == "filename numbers")
				times.numbers.push_back(value);
			else if (key == "filename start number")
				times.start = value;
			else if (key == "filename increment")
				times.increment = value;
		}
	}
	return about;
}

std::string fileAt(const Case& about, std::string name, const std::string& set, std::optional<double> time)
{
	const auto star = name.find('*');
	if (star == name.npos)
		return name;
	const auto found = about.sets.find(set);
	if (found == about.sets.end() || !time || found->second.times.empty())
		throw NotUnderstood();
	const Case::TimeSet& times = found->second;
	std::size_t step = 0;
	while (step + 1 < times.times.size() && static_cast<float>(times.times[step + 1]) <= static_cast<float>(*time))
		++step;
	const double number =
	    step < times.numbers.size() ? times.numbers[step] : times.start + static_cast<double>(step) * times.increment;
	const auto width = std::min(name.find_first_not_of('*', star), name.size()) - star;
	return name.replace(star, width, fmt::format("{:0{}}", static_cast<long>(number), width));
}

std::int64_t componentsOf(const std::string& kind)
{
	if (kind.find("tensor asym") != kind.npos)
		return 9;
	if (kind.find("tensor") != kind.npos)
		return 6;
	return kind.find("vector") != kind.npos ? 3 : 1;
}

} // namespace

bool refuseShortEnSight(const std::string& case_file, std::optional<double> time)
{
	bool ends_inside = endsInsideALine(case_file);
	try
	{
		const Case about = readCase(case_file);
		const auto folder = std::filesystem::path(case_file).parent_path();
		const auto setOf = [](const Words& words, std::size_t least) {
			return words.size() > least && std::isdigit(static_cast<unsigned char>(words[0][0])) ? words[0]
			                                                                                     : std::string();
		};
		Words words = about.geometry.words;
		std::erase(words, "change_coords_only");
		if (words.empty())
			return ends_inside;
		const std::string geometry_file = (folder / fileAt(about, words.back(), setOf(words, 1), time)).string();
		Cursor geometry(geometry_file, true);
		ends_inside |= !geometry.binary() && endsInsideALine(geometry_file);
		const Parts parts = walkGeometry(geometry);
		for (const Case::Entry& variable : about.variables)
		{
			const bool per_node = variable.kind.ends_with("per node");
			const bool is_complex = variable.kind.starts_with("complex");
			const std::size_t files = is_complex ? 2 : 1;
			if ((!per_node && !variable.kind.ends_with("per element")) ||
			    variable.words.size() < files + 1 + is_complex)
				continue;
			for (std::size_t i = 0; i < files; ++i)
				try
				{
					const std::string& name = variable.words[variable.words.size() - files - is_complex + i];
					const std::string set = setOf(variable.words, files + 1 + is_complex);
					const std::string file = (folder / fileAt(about, name, set, time)).string();
					Cursor values(file, false);
					ends_inside |= !geometry.binary() && endsInsideALine(file);
					values.setBinary(geometry.binary());
					walkVariable(values, parts, per_node, componentsOf(variable.kind));
				}
				catch (const NotUnderstood&)
				{
				}
		}
	}
	catch (const NotUnderstood&)
	{
	}
	return ends_inside;
}
