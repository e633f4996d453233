// Tecplot text files, after the Tecplot 360 Data Format Guide, chapter "ASCII Data".
#include "tecplot_file.h"

#include "tecplot_lexer.h"
#include "tecplot_zone_head.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace vp::reader::meshes
{

namespace
{

// Names may have line ends in them.
std::string onOneLine(std::string name)
{
	std::replace_if(
	    name.begin(), name.end(), [](unsigned char c) { return c < 0x20; }, ' ');
	return name;
}

std::size_t countOf(std::size_t a, std::size_t b, std::size_t c)
{
	std::size_t result = 0;
	if (__builtin_mul_overflow(a, b, &result) || __builtin_mul_overflow(result, c, &result) ||
	    result > static_cast<std::size_t>(TecplotLexer::kMaxCount))
		throw damaged("a zone of more points than there can be");
	return result;
}

class TecplotParser
{
public:
	explicit TecplotParser(std::string_view text) : at_(text) {}

	TecplotFile parse()
	{
		while (!at_.atEnd())
		{
			if (at_.isNumber())
				throw damaged(file_.zones.empty() ? "numbers before its first zone"
				                                  : fmt::format("\"{}\" has more values than it announces",
				                                                file_.zones.back().title.substr(0, 40)));
			readRecord(at_.word());
		}
		return std::move(file_);
	}

private:
	void readRecord(const std::string& word)
	{
		if (word == "TITLE")
			readText();
		else if (word == "FILETYPE")
			checkFileType(readText());
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
		else if (isTecplotRecord(word)) // texts, drawings and labels
			skipRecord();
		else
			throw damaged(fmt::format("\"{}\" where a record begins", word.substr(0, 20)));
	}

	std::string readText()
	{
		at_.take('=');
		return at_.text();
	}

	static void checkFileType(std::string type)
	{
		std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::toupper(c); });
		if (type == "SOLUTION")
			throw Refusal("a Tecplot solution without its grid; save both in one file");
	}

	void skipRecord()
	{
		while (!at_.atEnd())
		{
			const bool is_value = at_.take('=');
			if (at_.isString())
				at_.text();
			else if (at_.isNext('(') || at_.isNext('['))
				at_.list();
			else if (!at_.take(')') && !at_.isNext('='))
			{
				TecplotLexer ahead = at_;
				if (isTecplotRecord(ahead.word()) && !is_value)
					return;
				at_ = ahead;
			}
		}
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
				if (word.empty() || isTecplotRecord(word))
					return;
			}
			addVariable(onOneLine(at_.text()));
		}
	}

	// If several variables have one name, each has a number from the second on.
	void addVariable(const std::string& name)
	{
		const std::size_t number = ++names_[name];
		std::string own = number == 1 ? name : fmt::format("{} ({})", name, number);
		while (number > 1 && names_.contains(own))
			own += "'";
		names_.try_emplace(own, 1);
		file_.variables.push_back(std::move(own));
	}

	void readZone()
	{
		if (file_.variables.empty())
			throw damaged("a zone before its VARIABLES");
		TecplotZoneHead head = readTecplotZoneHead(at_, file_);
		head.zone.title = onOneLine(head.zone.title);
		readValues(head);
		if (!at_.isBetweenValues())
			throw damaged(fmt::format("\"{}\" has more values than it announces", head.zone.title.substr(0, 40)));
		if (isOneOf(head.zone.element_type, {"POLYGON", "POLYHEDRON"}))
			readFaces(head);
		else if (!head.zone.element_type.empty())
			readCorners(head);
		while ((head.has_neighbors || head.has_outer_neighbors) && at_.isNumber())
			at_.real();
		file_.zones.push_back(std::move(head.zone));
	}

	void readValues(TecplotZoneHead& head)
	{
		TecplotZone& zone = head.zone;
		std::vector<std::shared_ptr<std::vector<double>>> read(file_.variables.size());
		for (std::size_t v = 0; v < read.size(); ++v)
			if (!head.passive[v] && !head.shared.contains(v))
				read[v] = std::make_shared<std::vector<double>>();
		if (head.is_counted)
			countPoints(read, zone);

		const bool ordered = zone.element_type.empty();
		const auto& p = zone.points;
		const auto cells = [](std::uint32_t side) { return std::max(side, 2u) - 1; };
		const std::size_t points = ordered ? countOf(p[0], p[1], p[2]) : zone.nodes;
		const std::size_t middles = ordered ? countOf(cells(p[0]), cells(p[1]), cells(p[2])) : zone.elements;
		const auto wanted = [&](std::size_t v) { return zone.cell_variables.contains(v) ? middles : points; };
		if (head.in_blocks)
			for (std::size_t v = 0; v < read.size(); ++v)
				for (std::size_t i = 0; read[v] && i < wanted(v); ++i)
					read[v]->push_back(at_.value());
		else if (!head.is_counted)
			for (std::size_t i = 0; i < points; ++i)
				for (const auto& values : read)
					if (values)
						values->push_back(at_.value());

		zone.values.assign(read.begin(), read.end());
		for (const auto& [v, from] : head.shared)
		{
			zone.values[v] = file_.zones[from].values[v];
			if (zone.values[v] && zone.values[v]->size() != wanted(v))
				throw damaged("a zone shares values with one of another size");
		}
	}

	// As many points as there are values before the next record.
	void countPoints(const std::vector<std::shared_ptr<std::vector<double>>>& read, TecplotZone& zone)
	{
		std::size_t points = 0;
		const bool has_values = std::ranges::any_of(read, [](const auto& values) { return values != nullptr; });
		for (; has_values && (at_.isNumber() || !at_.isBetweenValues()); ++points)
			for (const auto& values : read)
				if (values)
					values->push_back(at_.value());
		if (points >= std::numeric_limits<std::uint32_t>::max())
			throw damaged("a zone of more points than there can be");
		zone.points[0] = std::max(static_cast<std::uint32_t>(points), 1u);
		if (points == 0 && has_values)
			throw damaged("a zone without values");
	}

	std::int64_t node(const TecplotZone& zone)
	{
		const std::int64_t node = at_.integer();
		if (node < 1 || node > static_cast<std::int64_t>(zone.nodes))
			throw damaged(fmt::format("an element has node {} of {}", node, zone.nodes));
		return node - 1;
	}

	void readCorners(TecplotZoneHead& head)
	{
		TecplotZone& zone = head.zone;
		const auto corners = static_cast<std::size_t>(tecplotCorners(zone.element_type));
		if (head.shared_corners)
		{
			zone.corners = file_.zones[*head.shared_corners].corners;
			const auto isBelow = [&](std::int64_t n) { return n < static_cast<std::int64_t>(zone.nodes); };
			if (!zone.corners || zone.corners->size() != corners * zone.elements ||
			    !std::ranges::all_of(*zone.corners, isBelow))
				throw damaged("a zone shares elements with one of another size");
			return;
		}
		auto read = std::make_shared<std::vector<std::int64_t>>();
		for (std::size_t i = 0; i < corners * zone.elements; ++i)
			read->push_back(node(zone));
		zone.corners = std::move(read);
	}

	void readFaces(TecplotZoneHead& head)
	{
		TecplotZone& zone = head.zone;
		if (head.shared_corners)
		{
			const TecplotZone& other = file_.zones[*head.shared_corners];
			zone.faces = other.faces;
			if (!zone.faces || other.nodes != zone.nodes || other.elements != zone.elements)
				throw damaged("a zone shares faces with one of another size");
			return;
		}
		if (head.faces > at_.left())
			throw damaged(fmt::format("it announces {} faces, more than it has room for", head.faces));
		auto faces = std::make_shared<TecplotFaces>();
		for (std::size_t f = 0; f < head.faces; ++f)
		{
			const std::int64_t corners = zone.element_type == "POLYGON" ? 2 : at_.integer();
			if (corners < 2 || corners > static_cast<std::int64_t>(zone.nodes))
				throw damaged(fmt::format("a face of {} nodes", corners));
			faces->starts.push_back(faces->starts.back() + corners);
		}
		const auto all = static_cast<std::size_t>(faces->starts.back());
		if (head.face_corners && *head.face_corners != all)
			throw damaged(fmt::format("its faces have {} nodes, where it announces {}", all, *head.face_corners));
		for (std::size_t i = 0; i < all; ++i)
			faces->corners.push_back(node(zone));
		for (auto* side : {&faces->left, &faces->right})
			for (std::size_t f = 0; f < head.faces; ++f)
			{
				// Below 0 it is one of other zones, which are listed behind.
				const std::int64_t element = at_.integer();
				if (element > static_cast<std::int64_t>(zone.elements) || (element < 0 && !head.has_outer_neighbors))
					throw damaged(fmt::format("a face has element {} of {}", element, zone.elements));
				side->push_back(std::max(element - 1, std::int64_t(-1)));
			}
		zone.faces = std::move(faces);
	}

	TecplotLexer at_;
	TecplotFile file_;
	std::map<std::string, std::size_t> names_;
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
	return TecplotParser(text).parse();
}

} // namespace vp::reader::meshes
