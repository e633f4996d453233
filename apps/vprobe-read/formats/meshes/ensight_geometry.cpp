#include "ensight_geometry.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace vp::reader::meshes
{

namespace
{

// Along one axis of a block; EnSight counts with 32 bits.
constexpr std::int64_t kMaxAlong = std::numeric_limits<std::int32_t>::max();

constexpr std::pair<std::string_view, std::int64_t> kElementNodes[] = {
    {"point", 1},    {"bar2", 2},     {"bar3", 3},       {"tria3", 3},  {"tria6", 6},   {"quad4", 4},
    {"quad8", 8},    {"tetra4", 4},   {"tetra10", 10},   {"hexa8", 8},  {"hexa20", 20}, {"penta6", 6},
    {"penta15", 15}, {"pyramid5", 5}, {"pyramid13", 13}, {"nsided", 0}, {"nfaced", 0},
};

std::int64_t checkedProduct(std::int64_t a, std::int64_t b, const EnSightCursor& at)
{
	std::int64_t product = 0;
	if (__builtin_mul_overflow(a, b, &product))
		at.endsEarly();
	return product;
}

class GeometryReader
{
public:
	GeometryReader(EnSightCursor& at, bool is_gold, bool may_lack_cells) : at_(at), may_lack_cells_(may_lack_cells)
	{
		geometry_.is_gold = is_gold;
	}

	EnSightGeometry read()
	{
		at_.description();
		at_.description();
		const bool node_ids = readIds("node id");
		element_ids_ = readIds("element id");
		std::string line = at_.line();
		if (line.starts_with("extents"))
		{
			at_.skip(6);
			line = at_.line();
		}
		if (!geometry_.is_gold && line.starts_with("coordinates"))
		{
			readGlobalNodes(node_ids);
			line = at_.line();
		}
		while (!line.empty())
			line = readPart(line, node_ids);
		if (geometry_.parts.empty() && !may_lack_cells_)
			at_.endsEarly();
		geometry_.swaps = at_.swaps();
		return std::move(geometry_);
	}

private:
	// Whether ids stand in the file.
	bool readIds(std::string_view what)
	{
		const std::string line = at_.line();
		if (!line.starts_with(what))
			at_.refuse(fmt::format("\"{}\" where its \"{}\" is wanted", ensightWords(line), what));
		const std::vector<std::string> words = wordsOf(line);
		return words.back() == "given" || words.back() == "ignore";
	}

	// EnSight 6: all nodes of unstructured parts, each with its id.
	void readGlobalNodes(bool with_ids)
	{
		const std::int64_t nodes = at_.count(with_ids ? 4 : 3);
		std::vector<std::int64_t> ids(static_cast<std::size_t>(nodes));
		std::iota(ids.begin(), ids.end(), 1);
		geometry_.nodes.resize(3 * ids.size());
		if (with_ids && at_.isBinary())
			ids = at_.integers(nodes);
		for (std::size_t n = 0; n < ids.size(); ++n)
		{
			if (with_ids && !at_.isBinary())
				ids[n] = at_.integer();
			at_.reals(&geometry_.nodes[3 * n], 3);
		}
		for (std::size_t n = 0; n < ids.size(); ++n)
			if (!node_of_id_.emplace(ids[n], static_cast<std::int64_t>(n)).second)
				at_.refuse(fmt::format("node {} occurs twice", ids[n]));
	}

	// Returns the line behind the part.
	std::string readPart(const std::string& head, bool node_ids)
	{
		const std::vector<std::string> words = wordsOf(head);
		if (words[0] != "part")
			at_.refuse(fmt::format("\"{}\" where a part begins", ensightWords(head)));
		std::int64_t number = 0;
		if (geometry_.is_gold || words.size() < 2)
			number = at_.integer();
		else if (std::from_chars(words[1].data(), words[1].data() + words[1].size(), number).ec != std::errc())
			at_.refuse(fmt::format("\"{}\" where a part begins", ensightWords(head)));
		if (!at_.isBinary() && (geometry_.is_gold || words.size() < 2))
			at_.description(); // the rest of the number's line
		const auto [place, is_new] = geometry_.parts.try_emplace(number);
		if (!is_new)
			at_.refuse(fmt::format("part {} occurs twice", number));
		EnSightPart& part = place->second;
		part.name = trimmedName(at_.description());
		std::string line = at_.line();
		for (; !line.empty() && !line.starts_with("part"); line = at_.line())
			if (line.starts_with("block"))
				readBlock(line, part);
			else if (line.starts_with("coordinates") && geometry_.is_gold)
				readCoordinates(node_ids, part);
			else
				readElements(line, part);
		if (line.empty() && part.elements.empty() && part.points() > 0 && !may_lack_cells_ &&
		    part.kind == EnSightPart::Kind::unstructured)
			at_.endsEarly();
		if (!geometry_.is_gold && part.kind == EnSightPart::Kind::unstructured)
			gatherNodes(part);
		return line;
	}

	static std::string trimmedName(std::string name)
	{
		const auto first = name.find_first_not_of(" \t\r");
		const auto last = name.find_last_not_of(" \t\r");
		return first == name.npos ? std::string() : name.substr(first, last - first + 1);
	}

	void readCoordinates(bool with_ids, EnSightPart& part)
	{
		const std::int64_t points = at_.count(with_ids ? 4 : 3);
		if (with_ids)
			at_.integers(points);
		part.coordinates.resize(3 * static_cast<std::size_t>(points));
		// An empty part's data may be null, which nothing may be added to.
		for (std::size_t axis = 0; axis < 3 && points > 0; ++axis)
			at_.reals(part.coordinates.data() + axis, points, 3);
	}

	void readBlock(const std::string& options, EnSightPart& part)
	{
		const std::vector<std::string> words = wordsOf(options);
		const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
		part.kind = has("uniform")       ? EnSightPart::Kind::uniform
		            : has("rectilinear") ? EnSightPart::Kind::rectilinear
		                                 : EnSightPart::Kind::curvilinear;
		for (std::int64_t& n : part.along)
			n = at_.integer();
		if (has("range"))
			for (std::int64_t& n : part.along)
			{
				const std::int64_t first = at_.integer();
				n = at_.integer() - first + 1;
			}
		std::int64_t points = 1;
		for (const std::int64_t n : part.along)
		{
			if (n < 1 || n > kMaxAlong)
				at_.refuse(fmt::format("a block of {} points", n));
			points = checkedProduct(points, n, at_);
		}
		readPlaces(points, part);
		if (has("iblanked"))
			part.blanks = at_.integers(points);
		if (has("with_ghost") || has("with_ghosts"))
		{
			if (!at_.line().starts_with("ghost_flags"))
				at_.refuse("a block without the ghost flags that it announces");
			part.ghosts = at_.integers(part.cells());
		}
	}

	void readPlaces(std::int64_t points, EnSightPart& part)
	{
		if (part.kind == EnSightPart::Kind::rectilinear)
			for (std::size_t axis = 0; axis < 3; ++axis)
				part.axes[axis] = at_.reals(part.along[axis]);
		else if (part.kind == EnSightPart::Kind::uniform)
		{
			const std::vector<double> places = at_.reals(6);
			for (std::size_t axis = 0; axis < 3; ++axis)
				part.axes[axis] = {places[axis], places[3 + axis]};
		}
		else
		{
			at_.needRoom(points, 3);
			part.coordinates.resize(3 * static_cast<std::size_t>(points));
			for (std::size_t axis = 0; axis < 3; ++axis)
				at_.reals(part.coordinates.data() + axis, points, 3);
		}
	}

	void readElements(const std::string& line, EnSightPart& part)
	{
		if (const std::string first = wordsOf(line)[0]; first == "node_ids" || first == "element_ids")
		{
			// The ids of a block are not shown.
			at_.skip(first == "node_ids" ? part.points() : part.cells());
			return;
		}
		EnSightElements elements;
		elements.type = ensightTypeOf(line, elements.is_ghost);
		if (!isEnSightElement(elements.type))
			at_.refuse(fmt::format("\"{}\" where a type of elements is wanted", ensightWords(line)));
		elements.count = at_.count(1);
		// EnSight 6 has each id in front of its element's nodes in text.
		const bool id_in_line = element_ids_ && !geometry_.is_gold && !at_.isBinary();
		if (element_ids_ && !id_in_line)
			at_.integers(elements.count);
		std::int64_t nodes = checkedProduct(elements.count, ensightNodesOf(elements.type), at_);
		if (elements.type == "nsided" || elements.type == "nfaced")
		{
			elements.sizes = at_.integers(elements.count);
			nodes = sumOf(elements.sizes);
			if (elements.type == "nfaced")
			{
				elements.face_sizes = at_.integers(nodes);
				nodes = sumOf(elements.face_sizes);
			}
		}
		elements.nodes = id_in_line ? nodesWithIds(elements.count, ensightNodesOf(elements.type)) : at_.integers(nodes);
		const std::int64_t points = geometry_.is_gold ? part.points() : 0;
		for (std::int64_t& node : elements.nodes)
			node = geometry_.is_gold ? checkedNode(node, points, elements.type) : globalNode(node, elements.type);
		part.elements.push_back(std::move(elements));
	}

	std::vector<std::int64_t> nodesWithIds(std::int64_t count, std::int64_t nodes_of_each)
	{
		std::vector<std::int64_t> nodes;
		for (std::int64_t i = 0; i < count; ++i)
		{
			at_.integer();
			for (std::int64_t n = 0; n < nodes_of_each; ++n)
				nodes.push_back(at_.integer());
		}
		return nodes;
	}

	std::int64_t sumOf(const std::vector<std::int64_t>& sizes) const
	{
		std::int64_t sum = 0;
		for (const std::int64_t size : sizes)
			if (size < 0 || __builtin_add_overflow(sum, size, &sum))
				at_.endsEarly();
		return sum;
	}

	std::int64_t checkedNode(std::int64_t node, std::int64_t points, const std::string& type) const
	{
		if (node < 1 || node > points)
			at_.refuse(fmt::format("an element {} has node {} of {}", type, node, points));
		return node - 1;
	}

	std::int64_t globalNode(std::int64_t node, const std::string& type) const
	{
		const auto found = node_of_id_.find(node);
		if (found == node_of_id_.end())
			at_.refuse(fmt::format("an element {} has node {}, which is not there", type, node));
		return found->second;
	}

	// EnSight 6: a part has those of the file's nodes that its elements use.
	void gatherNodes(EnSightPart& part) const
	{
		std::unordered_map<std::int64_t, std::int64_t> point_of;
		for (EnSightElements& elements : part.elements)
			for (std::int64_t& node : elements.nodes)
			{
				const auto [place, is_new] = point_of.emplace(node, static_cast<std::int64_t>(part.global.size()));
				if (is_new)
				{
					part.global.push_back(node);
					const auto first = geometry_.nodes.begin() + 3 * node;
					part.coordinates.insert(part.coordinates.end(), first, first + 3);
				}
				node = place->second;
			}
	}

	EnSightCursor& at_;
	EnSightGeometry geometry_;
	bool may_lack_cells_;
	bool element_ids_ = false;
	std::unordered_map<std::int64_t, std::int64_t> node_of_id_;
};

} // namespace

std::int64_t EnSightPart::points() const
{
	if (kind == Kind::unstructured)
		return static_cast<std::int64_t>(coordinates.size() / 3);
	return along[0] * along[1] * along[2];
}

std::int64_t EnSightPart::cells() const
{
	std::int64_t cells = 0;
	if (kind == Kind::unstructured)
		for (const EnSightElements& each : elements)
			cells += each.count;
	else
	{
		cells = 1;
		for (const std::int64_t n : along)
			cells *= std::max<std::int64_t>(n - 1, 1);
	}
	return cells;
}

std::int64_t ensightNodesOf(std::string_view type)
{
	const auto found = std::ranges::find(kElementNodes, type, &std::pair<std::string_view, std::int64_t>::first);
	return found == std::end(kElementNodes) ? 0 : found->second;
}

bool isEnSightElement(std::string_view type)
{
	return std::ranges::find(kElementNodes, type, &std::pair<std::string_view, std::int64_t>::first) !=
	       std::end(kElementNodes);
}

std::string_view ensightTypeOf(std::string_view word, bool& is_ghost)
{
	word = word.substr(0, word.find_first_of(" \t\r"));
	is_ghost = word.starts_with("g_");
	return is_ghost ? word.substr(2) : word;
}

EnSightGeometry readEnSightGeometry(const EnSightFile& file, std::string_view step, bool is_gold, bool may_lack_cells)
{
	EnSightCursor at(file, step);
	try
	{
		return GeometryReader(at, is_gold, may_lack_cells).read();
	}
	catch (const Refusal&)
	{
		if (file.form() == EnSightFile::Form::text)
			throw;
		// The first integer may have misled about the byte order.
		const std::exception_ptr first = std::current_exception();
		EnSightCursor again(file, step);
		again.setSwaps(!at.swaps());
		try
		{
			return GeometryReader(again, is_gold, may_lack_cells).read();
		}
		catch (const Refusal&)
		{
			std::rethrow_exception(first);
		}
	}
}

void takeEnSightCells(EnSightGeometry& geometry, const EnSightGeometry& other, const std::string& name)
{
	const auto refuse = [&](std::int64_t number)
	{ throw damaged(fmt::format("{}: part {} has not the points of the step with its cells", name, number)); };
	for (const auto& [number, source] : other.parts)
	{
		if (source.kind != EnSightPart::Kind::unstructured)
			continue;
		EnSightPart& part = geometry.parts[number];
		if (!part.elements.empty())
			continue;
		if (!geometry.is_gold)
		{
			part = source;
			if (geometry.nodes.size() != other.nodes.size())
				refuse(number);
			for (std::size_t p = 0; p < part.global.size(); ++p)
				std::copy_n(geometry.nodes.begin() + 3 * part.global[p], 3,
				            part.coordinates.begin() + static_cast<std::ptrdiff_t>(3 * p));
		}
		else if (part.points() != source.points())
			refuse(number);
		part.elements = source.elements;
		part.name = source.name;
	}
}

} // namespace vp::reader::meshes
