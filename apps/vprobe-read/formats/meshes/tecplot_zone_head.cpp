#include "tecplot_zone_head.h"

#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace vp::reader::meshes
{

namespace
{

std::string inCapitals(std::string_view text)
{
	std::string word(text);
	std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
	return word;
}

// "[1-3,7,10-20:2]", with or without its brackets, as numbers from 0.
std::vector<std::size_t> numbersInSet(std::string_view list, std::size_t end)
{
	std::vector<std::size_t> numbers;
	std::string words(list);
	std::replace_if(
	    words.begin(), words.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
	text::Cursor at(words);
	while (!at.atEnd())
	{
		const std::string_view word = at.word();
		const auto dash = word.find('-');
		const auto colon = std::min(word.find(':'), word.size());
		const std::int64_t first = text::Cursor(word.substr(0, std::min(dash, colon))).integer();
		const std::int64_t last =
		    dash == word.npos ? first : text::Cursor(word.substr(dash + 1, colon - dash - 1)).integer();
		const std::int64_t step = colon == word.size() ? 1 : text::Cursor(word.substr(colon + 1)).integer();
		if (first < 1 || last > static_cast<std::int64_t>(end) || step < 1)
			throw damaged(fmt::format("\"{}\" names variables that it does not have", word.substr(0, 20)));
		for (std::int64_t n = first; n <= last; n += std::min(step, last))
		{
			if (numbers.size() == end)
				throw damaged(fmt::format("\"{}\" names variables more than once", list.substr(0, 20)));
			numbers.push_back(static_cast<std::size_t>(n - 1));
		}
	}
	return numbers;
}

struct Item
{
	std::string_view name; // a word, or a set without its brackets
	std::string_view value;
};

// The items of a list such as "[1-3]=1,[4,5]=2", "NODAL,CELLCENTERED" or "3*NODAL".
std::vector<Item> itemsIn(std::string_view list)
{
	const auto skipBlanks = [&]
	{
		while (!list.empty() && (list[0] == ',' || std::isspace(static_cast<unsigned char>(list[0]))))
			list.remove_prefix(1);
	};
	const auto take = [&](std::string_view ends)
	{
		const std::size_t end = std::min(list.find_first_of(ends), list.size());
		const std::string_view word = list.substr(0, end);
		list.remove_prefix(end);
		return word;
	};
	std::vector<Item> items;
	for (skipBlanks(); !list.empty(); skipBlanks())
	{
		Item item;
		if (list[0] == '[')
		{
			list.remove_prefix(1);
			item.name = take("]");
			if (list.empty())
				throw damaged("a list without its brackets");
			list.remove_prefix(1);
		}
		else
			item.name = take(", =\t\r\n");
		skipBlanks();
		if (!list.empty() && list[0] == '=')
		{
			list.remove_prefix(1);
			skipBlanks();
			item.value = take(", \t\r\n");
		}
		items.push_back(item);
	}
	return items;
}

class HeadReader
{
public:
	HeadReader(TecplotLexer& at, const TecplotFile& file) : at_(at), file_(file)
	{
		head_.passive.resize(file.variables.size());
		head_.zone.title = fmt::format("zone {}", file.zones.size() + 1);
	}

	TecplotZoneHead read()
	{
		while (!at_.atEnd() && !at_.isNumber())
		{
			TecplotLexer ahead = at_;
			const std::string key = ahead.word();
			if (isTecplotRecord(key) && !ahead.isNext('=')) // all of this zone is shared
				break;
			at_ = ahead;
			if (key == "AUXDATA")
				at_.word();
			if (key.empty() || !at_.take('='))
				throw damaged(fmt::format("\"{}\" in the head of a zone", key.substr(0, 20)));
			readKey(key);
		}
		finish();
		return std::move(head_);
	}

private:
	void readKey(const std::string& key)
	{
		TecplotZone& zone = head_.zone;
		const std::size_t variables = file_.variables.size();
		if (key == "T")
			zone.title = at_.text();
		else if (key == "I" || key == "J" || key == "K")
		{
			zone.points[static_cast<std::size_t>(key[0] - 'I')] = side();
			has_sides_ = true;
		}
		else if (key == "N" || key == "NODES")
		{
			zone.nodes = count();
			head_.names_nodes = true;
		}
		else if (key == "E" || key == "ELEMENTS")
			zone.elements = count();
		else if (key == "ET" || key == "ZONETYPE")
			readType(at_.word());
		else if (key == "F" || key == "DATAPACKING")
			readPacking(at_.word());
		else if (key == "FACES")
			head_.faces = count();
		else if (key == "TOTALNUMFACENODES")
			head_.face_corners = count();
		else if (key == "NUMCONNECTEDBOUNDARYFACES" || key == "TOTALNUMBOUNDARYCONNECTIONS")
			head_.has_outer_neighbors |= count() > 0;
		else if (key == "FACENEIGHBORCONNECTIONS")
			head_.has_neighbors = count() > 0;
		else if (key == "SOLUTIONTIME")
			zone.time = at_.real();
		else if (key == "STRANDID")
			is_static_ = at_.integer() == 0;
		else if (key == "VARLOCATION")
			readPlaces(at_.list());
		else if (key == "VARSHARELIST")
			for (const Item& item : itemsIn(at_.list()))
				share(numbersInSet(item.name, variables), item.value);
		else if (key == "D")
			readDuplicates(at_.list());
		else if (key == "CONNECTIVITYSHAREZONE")
			shareCorners(at_.word());
		else if (key == "PASSIVEVARLIST")
			for (const std::size_t v : numbersInSet(at_.list(), variables))
				head_.passive[v] = true;
		else if (key == "NV")
			throw Refusal("a zone whose nodes have numbers of their own (NV=), which are not read; save it without");
		else if (at_.isString())
			at_.text();
		else
			at_.list(); // not used here: types of numbers, colors, parents, auxiliary data
	}

	void readType(std::string type)
	{
		if (type.starts_with("FE") && type.size() > 2)
			type.erase(0, 2);
		is_ordered_ = type == "ORDERED";
		head_.zone.element_type = is_ordered_ ? "" : type;
	}

	void readPacking(const std::string& packing)
	{
		if (!isOneOf(packing, {"POINT", "BLOCK", "FEPOINT", "FEBLOCK"}))
			throw damaged(fmt::format("a zone's values are packed as \"{}\"", packing.substr(0, 20)));
		head_.in_blocks = packing.ends_with("BLOCK");
		has_packing_ = true;
	}

	// "NODAL,NODAL,CELLCENTERED" from the first variable on, or by their numbers.
	void readPlaces(std::string_view list)
	{
		std::size_t next = 0;
		for (const Item& item : itemsIn(list))
		{
			std::vector<std::size_t> variables;
			std::string place = inCapitals(item.value);
			if (!item.value.empty())
				variables = numbersInSet(item.name, file_.variables.size());
			else
			{
				place = inCapitals(item.name);
				const std::size_t star = place.find('*');
				const std::int64_t times = star == place.npos ? 1 : text::Cursor(place.substr(0, star)).integer();
				place.erase(0, star == place.npos ? 0 : star + 1);
				if (times < 0 || times > static_cast<std::int64_t>(file_.variables.size() - next))
					throw damaged("a zone places more variables than it has");
				for (std::int64_t i = 0; i < times; ++i)
					variables.push_back(next++);
			}
			if (!isOneOf(place, {"NODAL", "CELLCENTERED"}))
				throw damaged(fmt::format("\"{}\" is no place of a variable", place.substr(0, 20)));
			for (const std::size_t v : variables)
				if (place == "NODAL")
					head_.zone.cell_variables.erase(v);
				else
					head_.zone.cell_variables.insert(v);
		}
	}

	// As files before 2000 share with the zone before: "D=(1,2,FECONNECT)".
	void readDuplicates(std::string_view list)
	{
		for (const Item& item : itemsIn(list))
			if (inCapitals(item.name) == "FECONNECT")
				shareCorners({});
			else
				share(numbersInSet(item.name, file_.variables.size()), {});
	}

	void share(const std::vector<std::size_t>& variables, std::string_view zone)
	{
		for (const std::size_t v : variables)
			head_.shared[v] = zoneNumber(zone);
	}

	void shareCorners(std::string_view zone)
	{
		if (zone != "0") // shared with none
			head_.shared_corners = zoneNumber(zone);
	}

	// From 0; without a number it is the zone before.
	std::size_t zoneNumber(std::string_view text)
	{
		const std::size_t zones = file_.zones.size();
		const std::int64_t number = text.empty() ? static_cast<std::int64_t>(zones) : text::Cursor(text).integer();
		if (number < 1 || number > static_cast<std::int64_t>(zones))
			throw damaged(fmt::format("a zone shares what zone {} has, which does not come before it", number));
		return static_cast<std::size_t>(number - 1);
	}

	std::uint32_t side()
	{
		const std::int64_t points = at_.integer();
		if (points < 1 || points > std::numeric_limits<int>::max())
			throw damaged(fmt::format("a zone of {} points along an axis", points));
		return static_cast<std::uint32_t>(points);
	}

	std::size_t count()
	{
		const std::int64_t number = at_.integer();
		if (number < 0 || number > TecplotLexer::kMaxCount)
			throw damaged(fmt::format("a zone of {} nodes, elements or faces", number));
		return static_cast<std::size_t>(number);
	}

	void finish()
	{
		TecplotZone& zone = head_.zone;
		if (zone.time && (is_static_ || !std::isfinite(*zone.time)))
			zone.time.reset();
		const bool by_faces = isOneOf(zone.element_type, {"POLYGON", "POLYHEDRON"});
		if (zone.element_type.empty() && !is_ordered_ && head_.names_nodes)
			throw Refusal("a zone of nodes without the type of its elements (ZONETYPE or ET)");
		if (!zone.element_type.empty() && tecplotCorners(zone.element_type) == 0 && !by_faces)
			throw Refusal(
			    fmt::format("a zone of {} elements, which are not read; convert it to FEBRICK or FETETRAHEDRON",
			                zone.element_type.substr(0, 20)));
		if (by_faces || (!has_packing_ && !zone.cell_variables.empty()))
			head_.in_blocks = true; // they are never written point by point
		if (!head_.in_blocks && !zone.cell_variables.empty())
			throw damaged("values at cells need DATAPACKING=BLOCK");
		head_.is_counted = zone.element_type.empty() && !has_sides_ && !head_.in_blocks;
	}

	TecplotLexer& at_;
	const TecplotFile& file_;
	TecplotZoneHead head_;
	bool has_sides_ = false;
	bool has_packing_ = false;
	bool is_ordered_ = false;
	bool is_static_ = false;
};

} // namespace

bool isTecplotRecord(std::string_view word)
{
	return isOneOf(word, {"TITLE", "FILETYPE", "VARIABLES", "ZONE", "TEXT", "GEOMETRY", "CUSTOMLABELS",
	                      "DATASETAUXDATA", "VARAUXDATA"});
}

TecplotZoneHead readTecplotZoneHead(TecplotLexer& at, const TecplotFile& file)
{
	return HeadReader(at, file).read();
}

} // namespace vp::reader::meshes
