#include "legacy_copy.h"

#include "base/real_text.h"
#include "legacy_arrays.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace vp::reader::vtk
{

using grid::NumberType;

namespace
{

class LegacyCopier : LegacyArrays
{
public:
	// to: null to see only whether a copy is needed.
	LegacyCopier(std::string_view text, MemoryFile* to) : LegacyArrays(text, to) { readHead(); }

	bool isText() const { return is_text_; }
	bool isNeeded() const { return is_text_ || is_changed_; }
	const std::vector<std::string>& warnings() const { return warnings_; }
	const std::vector<arrays::PlainArray>& plainArrays() const { return plain_; }

	void copy()
	{
		while (!at_.atEnd())
		{
			const std::string_view word = at_.word();
			if (!takeKeyword(inSmallLetters(word)))
			{
				if (std::any_of(word.begin(), word.end(), [](char c) { return c < '!' || c > '~'; }))
					throw damaged(fmt::format("behind {} stands no keyword: it has too few or too many values", last_));
				if (parseReal(word))
					throw damaged(fmt::format("behind {} stands \"{}\": it has more values than it announces", last_,
					                          word.substr(0, 40)));
				throw NotCopied();
			}
		}
	}

private:
	void readHead()
	{
		const std::string_view version = at_.line();
		const std::size_t number = version.find("Version");
		if (number == version.npos)
			throw NotCopied();
		const std::size_t digit = version.find_first_of("0123456789", number);
		has_offsets_ = digit != version.npos && version[digit] >= '5' &&
		               version[digit + 1 < version.size() ? digit + 1 : digit] == '.';
		const std::string_view title = at_.line();
		const std::string form = inSmallLetters(at_.word());
		if (form != "ascii" && form != "binary")
			throw NotCopied();
		is_text_ = form == "ascii";
		write(fmt::format("{}\n{}\nBINARY\n", version, title.substr(0, 255)));
	}

	bool takeKeyword(const std::string& word)
	{
		return takeGeometry(word) || takeAttribute(word) || takeDescription(word);
	}

	bool takeGeometry(const std::string& word)
	{
		if (word == "dataset")
		{
			const std::string kind = inSmallLetters(at_.word());
			if (!isOneOf(kind,
			             {"structured_points", "structured_grid", "rectilinear_grid", "unstructured_grid", "polydata"}))
				throw NotCopied();
			write(fmt::format("DATASET {}\n", kind));
		}
		else if (isOneOf(word, {"dimensions", "extent"}))
			copyReals(word, word == "extent" ? 6 : 3);
		else if (isOneOf(word, {"spacing", "aspect_ratio", "origin"}))
			copyReals(word, 3);
		else if (word == "points")
			copyCounted(word, 3, "the array of its points");
		else if (isOneOf(word, {"x_coordinates", "y_coordinates", "z_coordinates"}))
			copyCounted(word, 1, fmt::format("the array {}", word));
		else if (isOneOf(word, {"cells", "vertices", "lines", "polygons", "triangle_strips"}))
			copyCells(word);
		else if (word == "cell_types")
		{
			const std::uint64_t count = countOf();
			write(fmt::format("CELL_TYPES {}\n", count));
			copyNumbers(NumberType::int32, count, "the array of its types of cells");
		}
		else
			return false;
		return true;
	}

	bool takeAttribute(const std::string& word)
	{
		if (word == "point_data" || word == "cell_data")
		{
			is_point_ = word == "point_data";
			tuples_ = countOf();
			write(fmt::format("{} {}\n", word, tuples_));
		}
		else if (word == "scalars")
			copyScalars();
		else if (isOneOf(word, {"vectors", "normals"}))
			copyNamed(word, 3);
		else if (word == "tensors6" || word == "tensors")
			copyNamed(word, word == "tensors" ? 9 : 6);
		else if (word == "texture_coordinates")
		{
			const std::string name = ownName();
			const std::uint64_t components = countOf();
			const std::string type = inSmallLetters(at_.word());
			write(fmt::format("{} {} {} {}\n", word, name, components, type));
			copyValues(name, type, tuples_, components);
		}
		else if (isOneOf(word, {"global_ids", "pedigree_ids", "edge_flags"}))
			copyIds(word);
		else if (word == "color_scalars")
			copyColors();
		else
			return false;
		return true;
	}

	bool takeDescription(const std::string& word)
	{
		if (word == "lookup_table")
		{
			const std::string name(at_.word());
			const std::uint64_t colors = countOf();
			write(fmt::format("LOOKUP_TABLE {} {}\n", name, colors));
			copyShades(colors * 4, fmt::format("the table {}", name));
		}
		else if (word == "field")
			copyField();
		else if (word == "metadata")
			copyMetadata();
		else
			return false;
		return true;
	}

	void copyCounted(const std::string& word, std::uint64_t components, const std::string& words)
	{
		const std::uint64_t count = countOf();
		const std::string type = inSmallLetters(at_.word());
		write(fmt::format("{} {} {}\n", word, count, type));
		copyArray(type, count * components, words);
	}

	void copyValues(const std::string& name, const std::string& type, std::uint64_t tuples, std::uint64_t components)
	{
		copyArray(type, tuples * components, wordsFor(name));
		notePlain(is_point_, name, type, tuples, components);
	}

	// Before version 5, how many corners each cell has stands before them.
	void copyCells(const std::string& word)
	{
		const std::uint64_t first = countOf();
		const std::uint64_t second = countOf();
		write(fmt::format("{} {} {}\n", word, first, second));
		const std::string words = fmt::format("the list {}", word);
		if (!has_offsets_)
			return void(copyNumbers(NumberType::int32, second, words));
		if (first == 0)
			return;
		std::int64_t corners = 0;
		for (const auto& [list, count] : {std::pair{"offsets", first}, {"connectivity", second}})
		{
			if (inSmallLetters(at_.word()) != list)
				throw NotCopied();
			const std::string type = inSmallLetters(at_.word());
			write(fmt::format("{} {}\n", list, type));
			const std::int64_t last = copyArray(type, count, fmt::format("the {} of {}", list, words));
			corners = count == first && std::string_view(list) == "offsets" ? last : corners;
		}
		if (static_cast<std::uint64_t>(corners) != second)
			throw damaged(fmt::format("{} has {} corners where its offsets ask for {}", words, second, corners));
	}

	void copyScalars()
	{
		const std::string name = ownName();
		const std::string type = inSmallLetters(at_.word());
		std::string table = inSmallLetters(at_.word());
		std::uint64_t components = 1;
		if (table != "lookup_table")
		{
			if (std::from_chars(table.data(), table.data() + table.size(), components).ptr !=
			        table.data() + table.size() ||
			    components < 1 || components > 1 << 16)
				throw NotCopied();
			table = inSmallLetters(at_.word());
		}
		if (table != "lookup_table")
			throw NotCopied();
		write(fmt::format("SCALARS {} {} {}\nLOOKUP_TABLE {}\n", name, type, components, at_.word()));
		copyValues(name, type, tuples_, components);
	}

	void copyNamed(const std::string& word, std::uint64_t components)
	{
		const std::string name = ownName();
		const std::string type = inSmallLetters(at_.word());
		write(fmt::format("{} {} {}\n", word, name, type));
		copyValues(name, type, tuples_, components);
	}

	// VTK's reader would leave nothing of a second array of ids, so it becomes an ordinary one.
	void copyIds(const std::string& word)
	{
		const std::string name = ownName();
		const std::string type = inSmallLetters(at_.word());
		const bool is_first = ids_.insert(fmt::format("{} {}", is_point_.value_or(false), word)).second;
		if (is_first)
			write(fmt::format("{} {} {}\n", word, name, type));
		else
		{
			is_changed_ = true;
			write(fmt::format("FIELD FieldData 1\n{} 1 {} {}\n", name, tuples_, type));
		}
		copyValues(name, type, tuples_, 1);
	}

	void copyColors()
	{
		const std::string name = ownName();
		const std::uint64_t components = countOf();
		write(fmt::format("COLOR_SCALARS {} {}\n", name, components));
		copyShades(tuples_ * components, wordsFor(name));
	}

	void copyField()
	{
		const std::string name(at_.word());
		const std::uint64_t arrays = countOf();
		write(fmt::format("FIELD {} {}\n", name, arrays));
		for (std::uint64_t a = 0; a < arrays; ++a)
		{
			if (a > 0 && !at_.atEnd() && inSmallLetters(at_.peekLine()).starts_with("metadata"))
			{
				at_.word();
				copyMetadata();
			}
			const std::string array(at_.word());
			if (array == "NULL_ARRAY")
			{
				write("NULL_ARRAY\n");
				continue;
			}
			const std::string own = is_point_ ? ownNameFor(array) : array; // field data stand before both
			const std::uint64_t components = countOf();
			const std::uint64_t tuples = countOf();
			const std::string type = inSmallLetters(at_.word());
			if (components > 1 << 16)
				throw damaged(fmt::format("an array of {} components", components));
			write(fmt::format("{} {} {} {}\n", own, components, tuples, type));
			copyValues(own, type, tuples, components);
		}
	}

	// The lines up to a blank one. Keys with numbers that are not finite stop VTK's reader, so they are left out: they
	// are ranges, which are found anew.
	void copyMetadata()
	{
		at_.line();
		std::string names, key, keys;
		std::size_t count = 0;
		bool is_key = false;
		bool is_known = true;
		const auto endKey = [&]
		{
			if (!key.empty() && is_known)
			{
				keys += key;
				++count;
			}
			is_changed_ |= !key.empty() && !is_known;
			key.clear();
			is_known = true;
		};
		while (at_.place() < text_.size())
		{
			const std::string_view line = at_.line();
			if (line.empty())
				break;
			is_key |= line.starts_with("INFORMATION");
			if (line.starts_with("INFORMATION"))
				continue;
			if (!is_key)
			{
				names += fmt::format("{}\n", line);
				continue;
			}
			if (line.starts_with("NAME "))
				endKey();
			key += fmt::format("{}\n", line);
			for (text::Cursor words(line); !words.atEnd();)
				if (const std::optional<double> number = parseReal(words.word()); number && !std::isfinite(*number))
					is_known = false;
		}
		endKey();
		write("METADATA\n" + names + (count > 0 ? fmt::format("INFORMATION {}\n{}", count, keys) : "") + "\n");
	}

	std::string wordsFor(const std::string& name) const
	{
		const char* kind = !is_point_ ? "" : *is_point_ ? "point " : "cell ";
		return fmt::format("the {}array {}", kind, decodedText(name));
	}

	// VTK's writer encodes a blank in the name of colors as "%%20", which its reader does not know.
	std::string ownName()
	{
		std::string name(at_.word());
		for (std::size_t at = name.find("%%"); at != name.npos; at = name.find("%%", at))
		{
			name.erase(at, 1);
			is_changed_ = true;
		}
		return ownNameFor(name);
	}

	std::string ownNameFor(const std::string& name)
	{
		if (!is_point_)
			throw NotCopied();
		std::set<std::string>& taken = names_[*is_point_ ? 1 : 0];
		if (taken.insert(name).second)
			return name;
		std::string own;
		for (std::size_t number = 2; own.empty() || !taken.insert(own).second; ++number)
			own = fmt::format("{}%20{}", name, number);
		warnings_.push_back(fmt::format("two {} arrays are called {}; the later one is shown as {}",
		                                *is_point_ ? "point" : "cell", decodedText(name), decodedText(own)));
		is_changed_ = true;
		return own;
	}

	bool has_offsets_ = false;
	std::optional<bool> is_point_; // whether the arrays that follow are at points; none before both
	std::uint64_t tuples_ = 0;
	std::set<std::string> names_[2]; // those of the arrays at cells, and at points
	std::set<std::string> ids_;
	std::vector<std::string> warnings_;
};

} // namespace

std::vector<arrays::PlainArray> plainArraysOfLegacy(std::string_view text)
try
{
	LegacyCopier look(text, nullptr);
	if (!look.isText())
		look.copy();
	return look.plainArrays();
}
catch (const NotCopied&)
{
	return {};
}

LegacyCopy copyLegacy(std::string_view text)
{
	LegacyCopy copy;
	try
	{
		LegacyCopier look(text, nullptr);
		copy.is_text = look.isText();
		if (!look.isText())
			look.copy();
		if (!look.isNeeded())
			return copy;
		auto file = std::make_unique<MemoryFile>();
		LegacyCopier copier(text, file.get());
		copier.copy();
		file->end();
		copy.file = std::move(file);
		copy.warnings = copier.warnings();
	}
	catch (const NotCopied&)
	{
	}
	return copy;
}

} // namespace vp::reader::vtk
