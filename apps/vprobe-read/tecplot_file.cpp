#include "tecplot_file.h"

#include "refusal.h"
#include "tecplot_lexer.h"
#include "text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace
{

// "[1-3,7]" or "1-3" as numbers from 0.
std::vector<std::size_t> numbersIn(std::string_view list, std::size_t end)
{
	std::vector<std::size_t> numbers;
	std::string words(list);
	std::replace_if(
	    words.begin(), words.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
	TextCursor at(words);
	while (!at.atEnd())
	{
		const std::string_view word = at.word();
		const auto dash = word.find('-');
		const std::int64_t first = TextCursor(word.substr(0, dash)).integer();
		const std::int64_t last = dash == word.npos ? first : TextCursor(word.substr(dash + 1)).integer();
		if (first < 1 || last > static_cast<std::int64_t>(end))
			throw damaged(fmt::format("\"{}\" names variables that it does not have", word.substr(0, 20)));
		for (std::int64_t n = first; n <= last; ++n)
			numbers.push_back(static_cast<std::size_t>(n - 1));
	}
	return numbers;
}

// Pairs of a list as "([1-3]=1,[4,5]=2)" has them.
std::vector<std::pair<std::string, std::string>> pairsIn(std::string_view list)
{
	std::vector<std::pair<std::string, std::string>> pairs;
	while (!list.empty())
	{
		const auto equals = list.find('=');
		const auto end = std::min(list.find_first_of(",[", std::min(equals, list.size())), list.size());
		pairs.emplace_back(list.substr(0, equals),
		                   equals == list.npos ? "" : list.substr(equals + 1, end - equals - 1));
		list.remove_prefix(std::min(std::max(end, std::size_t(1)), list.size()));
	}
	return pairs;
}

class Parser
{
public:
	explicit Parser(std::string_view text) : at_(text) {}

	TecplotFile parse()
	{
		while (!at_.atEnd())
		{
			const std::string word = at_.word();
			if (word == "TITLE" || word == "FILETYPE")
				readText();
			else if (word == "VARIABLES")
				readVariables();
			else if (word == "ZONE")
				readZone();
			else if (word == "DATASETAUXDATA")
			{
				at_.word();
				readText();
			}
			else if (word == "VARAUXDATA")
			{
				at_.integer();
				at_.word();
				readText();
			}
			else if (word == "TEXT" || word == "GEOMETRY" || word == "CUSTOMLABELS")
				throw Refusal(fmt::format("its {} records are not read; save it without them", word));
			else
				throw damaged(fmt::format("\"{}\" where a record begins", word.substr(0, 20)));
		}
		return std::move(file_);
	}

private:
	std::string readText()
	{
		at_.take('=');
		return at_.text();
	}

	void readVariables()
	{
		at_.take('=');
		while (!at_.atEnd())
		{
			if (!at_.isString())
			{
				TecplotLexer ahead = at_;
				const std::string word = ahead.word();
				if (word.empty() || word == "ZONE" || word == "DATASETAUXDATA" || word == "VARAUXDATA" ||
				    word == "TEXT" || word == "GEOMETRY")
					return;
			}
			file_.variables.push_back(at_.text());
		}
	}

	std::uint32_t side()
	{
		const std::int64_t points = at_.integer();
		if (points < 1 || points > TecplotLexer::kMaxCount - 1)
			throw damaged(fmt::format("a zone of {} points along an axis", points));
		return static_cast<std::uint32_t>(points);
	}

	std::size_t count()
	{
		const std::int64_t number = at_.integer();
		if (number < 0 || number > TecplotLexer::kMaxCount)
			throw damaged(fmt::format("a zone of {} nodes or elements", number));
		return static_cast<std::size_t>(number);
	}

	struct Header
	{
		TecplotZone zone;
		bool in_blocks = false;
		std::vector<bool> passive;
		std::map<std::size_t, std::size_t> shared; // variable to zone
		std::optional<std::size_t> shared_corners;
	};

	void readZone()
	{
		if (file_.variables.empty())
			throw damaged("a zone before its VARIABLES");
		Header header;
		header.passive.resize(file_.variables.size());
		header.zone.title = fmt::format("zone {}", file_.zones.size() + 1);
		while (!at_.atEnd() && !at_.isNumber())
		{
			TecplotLexer ahead = at_;
			const std::string key = ahead.word();
			if (key == "ZONE") // all of this one is shared
				break;
			at_ = ahead;
			if (key == "AUXDATA")
				at_.word();
			if (!at_.take('='))
				throw damaged(fmt::format("\"{}\" in the head of a zone", key.substr(0, 20)));
			readKey(key, header);
		}
		readValues(header);
		readCorners(header);
		file_.zones.push_back(std::move(header.zone));
	}

	void readKey(const std::string& key, Header& header)
	{
		TecplotZone& zone = header.zone;
		const std::size_t variables = file_.variables.size();
		if (key == "T")
			zone.title = at_.text();
		else if (key == "I" || key == "J" || key == "K")
			zone.points[static_cast<std::size_t>(key[0] - 'I')] = side();
		else if (key == "N" || key == "NODES")
			zone.nodes = count();
		else if (key == "E" || key == "ELEMENTS")
			zone.elements = count();
		else if (key == "ET" || key == "ZONETYPE")
		{
			const std::string type = at_.word();
			zone.element_type = type == "ORDERED" ? "" : type.starts_with("FE") ? type.substr(2) : type;
		}
		else if (key == "F" || key == "DATAPACKING")
		{
			const std::string packing = at_.word();
			header.in_blocks = packing.ends_with("BLOCK");
			if (packing.starts_with("FE") && zone.element_type.empty())
				zone.element_type = packing.substr(0, 2); // until ET= follows
		}
		else if (key == "SOLUTIONTIME")
			zone.time = at_.real();
		else if (key == "VARLOCATION")
		{
			for (const auto& [names, place] : pairsIn(at_.group()))
				if (place.find("CELL") != place.npos || place.find("cell") != place.npos)
					for (const std::size_t v : numbersIn(names, variables))
						zone.cell_variables.insert(v);
		}
		else if (key == "VARSHARELIST")
		{
			for (const auto& [names, from] : pairsIn(at_.group()))
				for (const std::size_t v : numbersIn(names, variables))
					header.shared[v] = zoneNumber(from);
		}
		else if (key == "CONNECTIVITYSHAREZONE")
			header.shared_corners = zoneNumber(at_.word());
		else if (key == "PASSIVEVARLIST")
		{
			for (const std::size_t v : numbersIn(at_.group(), variables))
				header.passive[v] = true;
		}
		else if (key == "DT")
			at_.group();
		else
			at_.text(); // of no use here: colors, strands, parents, auxiliary data
	}

	// From 0; without a number it is the zone before.
	std::size_t zoneNumber(const std::string& text)
	{
		const std::size_t zones = file_.zones.size();
		const std::int64_t number = text.empty() ? static_cast<std::int64_t>(zones) : TextCursor(text).integer();
		if (number < 1 || number > static_cast<std::int64_t>(zones))
			throw damaged(fmt::format("a zone shares what zone {} has, which does not come before it", number));
		return static_cast<std::size_t>(number - 1);
	}

	static std::size_t product(std::size_t a, std::size_t b, std::size_t c)
	{
		std::size_t result = 0;
		if (__builtin_mul_overflow(a, b, &result) || __builtin_mul_overflow(result, c, &result) ||
		    result > static_cast<std::size_t>(TecplotLexer::kMaxCount))
			throw damaged("a zone of more points than there can be");
		return result;
	}

	void readValues(Header& header)
	{
		TecplotZone& zone = header.zone;
		const bool ordered = zone.element_type.empty();
		const auto& p = zone.points;
		const auto cells = [](std::uint32_t side) { return std::max(side, 2u) - 1; };
		const std::size_t points = ordered ? product(p[0], p[1], p[2]) : zone.nodes;
		const std::size_t middles = ordered ? product(cells(p[0]), cells(p[1]), cells(p[2])) : zone.elements;
		if (!header.in_blocks && !zone.cell_variables.empty())
			throw damaged("values at cells need DATAPACKING=BLOCK");

		std::vector<std::shared_ptr<std::vector<double>>> read(file_.variables.size());
		for (std::size_t v = 0; v < read.size(); ++v)
			if (!header.passive[v] && !header.shared.contains(v))
				read[v] = std::make_shared<std::vector<double>>();
		if (header.in_blocks)
		{
			for (std::size_t v = 0; v < read.size(); ++v)
				for (std::size_t i = 0; read[v] && i < (zone.cell_variables.contains(v) ? middles : points); ++i)
					read[v]->push_back(at_.value());
		}
		else
			for (std::size_t i = 0; i < points; ++i)
				for (const auto& values : read)
					if (values)
						values->push_back(at_.value());

		zone.values.resize(read.size());
		for (std::size_t v = 0; v < read.size(); ++v)
			zone.values[v] = read[v];
		for (const auto& [v, from] : header.shared)
		{
			zone.values[v] = file_.zones[from].values[v];
			const std::size_t wanted = zone.cell_variables.contains(v) ? middles : points;
			if (zone.values[v] && zone.values[v]->size() != wanted)
				throw damaged("a zone shares values with one of another size");
		}
	}

	void readCorners(Header& header)
	{
		TecplotZone& zone = header.zone;
		if (zone.element_type.empty())
			return;
		const auto corners = static_cast<std::size_t>(tecplotCorners(zone.element_type));
		if (corners == 0)
			throw Refusal(
			    fmt::format("a zone of {} elements, which are not read; convert it to FEBRICK or FETETRAHEDRON",
			                zone.element_type.substr(0, 20)));
		if (header.shared_corners)
		{
			zone.corners = file_.zones[*header.shared_corners].corners;
			if (!zone.corners || zone.corners->size() != corners * zone.elements)
				throw damaged("a zone shares elements with one of another size");
			return;
		}
		auto read = std::make_shared<std::vector<std::int64_t>>();
		for (std::size_t i = 0; i < corners * zone.elements; ++i)
		{
			const std::int64_t node = at_.integer();
			if (node < 1 || node > static_cast<std::int64_t>(zone.nodes))
				throw damaged(fmt::format("an element has node {} of {}", node, zone.nodes));
			read->push_back(node - 1);
		}
		zone.corners = std::move(read);
	}

	TecplotLexer at_;
	TecplotFile file_;
};

} // namespace

int tecplotCorners(const std::string& element_type)
{
	static const std::map<std::string, int> corners = {
	    {"BRICK", 8}, {"TETRAHEDRON", 4}, {"QUADRILATERAL", 4}, {"TRIANGLE", 3}, {"LINESEG", 2}};
	const auto found = corners.find(element_type);
	return found == corners.end() ? 0 : found->second;
}

TecplotFile parseTecplot(std::string_view text)
{
	return Parser(text).parse();
}
