#include "ensight_values.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace vp::reader::meshes
{

namespace
{

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

class ValuesReader
{
public:
	ValuesReader(EnSightCursor& at, const EnSightGeometry& geometry, bool per_node, int components)
	    : at_(at), geometry_(geometry), per_node_(per_node), components_(components)
	{
	}

	EnSightValues read()
	{
		at_.description();
		if (!geometry_.is_gold && per_node_)
			readGlobalValues();
		std::string line = at_.line();
		if (line.empty() && values_.empty())
			at_.endsEarly();
		while (!line.empty())
			line = readPart(line);
		if (components_ == 6)
			for (auto& [number, values] : values_)
				for (std::size_t v = 0; v + 6 <= values.size(); v += 6)
					std::swap(values[v + 4], values[v + 5]); // the file has xz before yz
		return std::move(values_);
	}

private:
	std::size_t width() const { return static_cast<std::size_t>(components_); }

	// EnSight 6: values of the nodes that all unstructured parts share.
	void readGlobalValues()
	{
		const auto nodes = static_cast<std::int64_t>(geometry_.nodes.size() / 3);
		at_.needRoom(nodes, components_);
		const std::vector<double> all = at_.reals(nodes * components_);
		for (const auto& [number, part] : geometry_.parts)
		{
			if (part.kind != EnSightPart::Kind::unstructured)
				continue;
			std::vector<double>& values = values_[number];
			for (const std::int64_t node : part.global)
			{
				const auto first = all.begin() + node * components_;
				values.insert(values.end(), first, first + components_);
			}
		}
	}

	const EnSightPart& partAt(const std::string& head, std::int64_t& number)
	{
		const std::vector<std::string> words = wordsOf(head);
		if (words[0] != "part")
			at_.refuse(fmt::format("\"{}\" where a part begins", ensightWords(head)));
		if (geometry_.is_gold || words.size() < 2)
			number = at_.integer();
		else if (std::from_chars(words[1].data(), words[1].data() + words[1].size(), number).ec != std::errc())
			at_.refuse(fmt::format("\"{}\" where a part begins", ensightWords(head)));
		const auto found = geometry_.parts.find(number);
		if (found == geometry_.parts.end())
			at_.refuse(fmt::format("values of part {}, which its geometry lacks", number));
		return found->second;
	}

	// Returns the line behind the part.
	std::string readPart(const std::string& head)
	{
		std::int64_t number = 0;
		const EnSightPart& part = partAt(head, number);
		const std::int64_t tuples = per_node_ ? part.points() : part.cells();
		const bool is_block = part.kind != EnSightPart::Kind::unstructured;
		std::vector<double>& values = values_[number];
		std::vector<bool> seen(is_block || per_node_ ? 1 : part.elements.size(), false);
		std::string line = at_.line();
		for (; !line.empty() && !line.starts_with("part"); line = at_.line())
		{
			const std::vector<std::string> words = wordsOf(line);
			std::int64_t first = 0, count = tuples;
			std::size_t section = 0;
			const bool is_whole = words[0] == "coordinates" || words[0] == "block";
			if (is_whole != (is_block || per_node_))
				at_.refuse(fmt::format("\"{}\" where values of {} are wanted", ensightWords(line),
				                       per_node_ ? "nodes" : "elements"));
			if (!is_whole)
				section = sectionOf(part, words[0], seen, first, count);
			if (seen[section])
				at_.refuse(fmt::format("values of part {} occur twice", number));
			seen[section] = true;
			at_.needRoom(count, words.size() > 1 && words[1] == "partial" ? 0 : components_);
			values.resize(static_cast<std::size_t>(tuples) * width(), kUndefined);
			readSection(words.size() > 1 ? words[1] : "", !is_whole, count, values.data() + first * components_);
		}
		if (line.empty() && lacksValues(part, seen, tuples)) // the end may have been cut off
			at_.endsEarly();
		if (values.empty())
			values_.erase(number);
		return line;
	}

	bool lacksValues(const EnSightPart& part, const std::vector<bool>& seen, std::int64_t tuples) const
	{
		for (std::size_t i = 0; i < seen.size(); ++i)
			if (!seen[i] && (seen.size() == part.elements.size() && !per_node_ ? part.elements[i].count : tuples) > 0)
				return true;
		return false;
	}

	// Which elements of the part these are: of those of one type, the next ones.
	std::size_t sectionOf(const EnSightPart& part, std::string_view word, const std::vector<bool>& seen,
	                      std::int64_t& first, std::int64_t& count) const
	{
		bool is_ghost = false;
		const std::string_view type = ensightTypeOf(word, is_ghost);
		for (std::size_t i = 0; i < part.elements.size(); first += part.elements[i++].count)
			if (part.elements[i].type == type && part.elements[i].is_ghost == is_ghost && !seen[i])
			{
				count = part.elements[i].count;
				return i;
			}
		at_.refuse(fmt::format("values of \"{}\", which its part lacks", ensightWords(word)));
	}

	void readSection(std::string_view option, bool is_elements, std::int64_t count, double* to)
	{
		if (option == "undef")
		{
			const double undefined = at_.reals(1)[0];
			readAll(is_elements, count, to);
			std::replace(to, to + count * components_, undefined, kUndefined);
		}
		else if (option == "partial")
		{
			const std::int64_t given = at_.count(1 + components_);
			const std::vector<std::int64_t> places = at_.integers(given);
			std::vector<double> values(static_cast<std::size_t>(given) * width());
			readAll(is_elements, given, values.data());
			for (std::size_t i = 0; i < places.size(); ++i)
			{
				if (places[i] < 1 || places[i] > count)
					at_.refuse(fmt::format("a value of number {} of {}", places[i], count));
				std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * width()), components_,
				            to + (places[i] - 1) * components_);
			}
		}
		else if (option.empty())
			readAll(is_elements, count, to);
		else
			at_.refuse(fmt::format("values that are \"{}\", which is not known", ensightWords(option)));
	}

	// Component by component; EnSight 6 has the values of elements tuple by tuple.
	void readAll(bool is_elements, std::int64_t count, double* to)
	{
		if (!geometry_.is_gold && is_elements)
			at_.reals(to, count * components_);
		else
			for (int c = 0; c < components_; ++c)
				at_.reals(count == 0 ? nullptr : to + c, count, width());
	}

	EnSightCursor& at_;
	const EnSightGeometry& geometry_;
	bool per_node_;
	int components_;
	EnSightValues values_;
};

// Whether the number of the first part is there in the other byte order alone.
bool hasOtherOrder(const EnSightFile& file, std::string_view step, const EnSightGeometry& geometry)
{
	constexpr std::size_t number_at = 160; // behind the description and "part"
	if (file.form() == EnSightFile::Form::text || !geometry.is_gold || step.size() < number_at + 4)
		return false;
	EnSightCursor at(file, step);
	at.description();
	at.description();
	at.setSwaps(geometry.swaps);
	const auto number = static_cast<std::uint32_t>(at.integer());
	return !geometry.parts.contains(static_cast<std::int32_t>(number)) &&
	       geometry.parts.contains(static_cast<std::int32_t>(__builtin_bswap32(number)));
}

} // namespace

EnSightValues readEnSightValues(const EnSightFile& file, std::string_view step, const EnSightGeometry& geometry,
                                bool per_node, int components)
{
	EnSightCursor at(file, step);
	at.setSwaps(geometry.swaps != hasOtherOrder(file, step, geometry));
	return ValuesReader(at, geometry, per_node, components).read();
}

} // namespace vp::reader::meshes
