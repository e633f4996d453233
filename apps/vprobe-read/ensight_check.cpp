#include "ensight_check.h"

#include "ensight_case.h"
#include "ensight_cursor.h"
#include "text_end.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace
{

// Along one axis of a block; EnSight counts with 32 bits.
constexpr std::int64_t kMaxAxisPoints = std::int64_t(1) << 31;

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

void walkBlock(EnSightCursor& file, const std::string& options, Part& part)
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
	const auto product = [&](std::int64_t less)
	{
		std::int64_t product = 1;
		for (const std::int64_t each : n)
			product = file.product(product, std::max<std::int64_t>(each - less, 1));
		return product;
	};
	if (std::ranges::any_of(n, [](std::int64_t each) { return each < 1 || each > kMaxAxisPoints; }))
		file.endsEarly();
	part.points = product(0);
	part.cells = product(1);
	const bool rectilinear = options.find("rectilinear") != options.npos;
	const bool uniform = options.find("uniform") != options.npos;
	if (options.find("ghost") != options.npos || options.find("range") != options.npos)
		throw NotUnderstood();
	file.skip(rectilinear ? n[0] + n[1] + n[2] : uniform ? 6 : file.product(3, part.points));
	if (options.find("iblanked") != options.npos)
		file.skip(part.points);
}

void walkElements(EnSightCursor& file, const std::string& type, bool with_ids, Part& part)
{
	const std::int64_t count = file.count();
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
		file.skip(file.product(count, nodesOf(type)), count);
}

Parts walkGeometry(EnSightCursor& file)
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
				part.points = file.count();
				file.skip(file.product(node_ids ? 4 : 3, part.points));
			}
			else
				walkElements(file, words[0], element_ids, part);
		}
	}
	if (!line.empty())
		throw NotUnderstood();
	return parts;
}

void walkVariable(EnSightCursor& file, const Parts& parts, bool per_node, std::int64_t components)
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
				file.skip(file.product(components, part.points));
			else if (words[0] == "block")
				file.skip(file.product(components, part.cells));
			else if (const auto count = part.elements.find(words[0]); count != part.elements.end())
				file.skip(file.product(components, count->second));
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
		const EnSightCase about = readEnSightCase(case_file);
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
		EnSightCursor geometry = EnSightCursor::ofGeometry(geometry_file);
		ends_inside |= !geometry.binary() && endsInsideALine(geometry_file);
		const Parts parts = walkGeometry(geometry);
		for (const EnSightCase::Entry& variable : about.variables)
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
					EnSightCursor values(file, geometry.binary());
					ends_inside |= !geometry.binary() && endsInsideALine(file);
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
