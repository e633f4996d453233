#include "legacy_copy.h"

#include "base/real_text.h"
#include "is_one_of.h"
#include "refusal.h"
#include "text_cursor.h"
#include "text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>

using vp::grid::NumberType;

namespace
{

// Thrown where VTK's reader has to go on, or to tell what is wrong.
struct NotCopied
{
};

std::string inSmallLetters(std::string_view word)
{
	std::string small(word);
	std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
	return small;
}

struct LegacyType
{
	std::string_view word;
	NumberType type;
};

// VTK writes and reads its vtkIdType as 32 bits here.
constexpr LegacyType kLegacyTypes[] = {
    {"char", NumberType::int8},          {"signed_char", NumberType::int8},      {"unsigned_char", NumberType::uint8},
    {"short", NumberType::int16},        {"unsigned_short", NumberType::uint16}, {"int", NumberType::int32},
    {"vtkidtype", NumberType::int32},    {"unsigned_int", NumberType::uint32},   {"long", NumberType::int64},
    {"vtktypeint64", NumberType::int64}, {"unsigned_long", NumberType::uint64},  {"vtktypeuint64", NumberType::uint64},
    {"float", NumberType::float32},      {"double", NumberType::float64}};

std::string bigEndian(std::uint64_t value, std::size_t bytes)
{
	std::string text(bytes, '\0');
	for (std::size_t i = 0; i < bytes; ++i)
		text[bytes - 1 - i] = static_cast<char>(value >> 8 * i & 0xFF);
	return text;
}

// How binary files write a text: the first two bits say how long its length is.
std::string lengthOfText(std::size_t length)
{
	if (length < std::size_t(1) << 6)
		return bigEndian(length | 0xC0, 1);
	if (length < std::size_t(1) << 14)
		return bigEndian(length | 0x8000, 2);
	if (length < std::size_t(1) << 30)
		return bigEndian(length | 0x40000000, 4);
	return bigEndian(length, 8);
}

// "%20" is a blank.
std::string decodedText(std::string_view text)
{
	std::string decoded;
	for (std::size_t i = 0; i < text.size(); ++i)
	{
		unsigned value = 0;
		const char* digits = text.data() + i + 1;
		if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2)
		{
			decoded += static_cast<char>(value);
			i += 2;
		}
		else
			decoded += text[i];
	}
	return decoded;
}

class LegacyCopier
{
public:
	// to: null to see only whether a copy is needed.
	LegacyCopier(std::string_view text, MemoryFile* to) : text_(text), at_(text), to_(to) { readHead(); }

	bool isText() const { return is_text_; }
	bool isNeeded() const { return is_text_ || is_changed_; }
	const std::vector<std::string>& warnings() const { return warnings_; }

	void copy()
	{
		while (!at_.atEnd())
		{
			const std::string_view word = at_.word();
			if (!takeKeyword(inSmallLetters(word)))
			{
				if (std::any_of(word.begin(), word.end(), [](char c) { return c < '!' || c > '~'; }))
					throw damaged(fmt::format("behind {} stands no keyword: it has too few or too many values", last_));
				if (vp::parseReal(word))
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

	void write(std::string_view bytes)
	{
		if (to_)
			to_->append(bytes);
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
			copyArray(type, tuples_ * components, wordsFor(name));
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

	std::uint64_t countOf()
	{
		const std::int64_t count = at_.integer();
		if (count < 0 || count > std::int64_t(1) << 40)
			throw damaged(fmt::format("a number of {}", count));
		return static_cast<std::uint64_t>(count);
	}

	void copyReals(const std::string& word, std::size_t count)
	{
		std::string line = word;
		for (std::size_t i = 0; i < count; ++i)
		{
			const std::string_view digits = at_.word();
			const std::optional<double> number = vp::parseReal(digits);
			if (!number || !std::isfinite(*number))
				throw damaged(fmt::format("\"{}\" in its {} is no finite number", digits.substr(0, 40), word));
			double known = 0.0;
			const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), known);
			is_changed_ |= error != std::errc() || end != digits.data() + digits.size();
			line += fmt::format(" {}", *number);
		}
		write(line + "\n");
	}

	void copyCounted(const std::string& word, std::uint64_t components, const std::string& words)
	{
		const std::uint64_t count = countOf();
		const std::string type = inSmallLetters(at_.word());
		write(fmt::format("{} {} {}\n", word, count, type));
		copyArray(type, count * components, words);
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
		copyArray(type, tuples_ * components, wordsFor(name));
	}

	void copyNamed(const std::string& word, std::uint64_t components)
	{
		const std::string name = ownName();
		const std::string type = inSmallLetters(at_.word());
		write(fmt::format("{} {} {}\n", word, name, type));
		copyArray(type, tuples_ * components, wordsFor(name));
	}

	// Of a second array of ids VTK's reader would leave nothing, so it becomes an ordinary one.
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
		copyArray(type, tuples_, wordsFor(name));
	}

	// Shares of 1 in text, bytes in binary files.
	void copyColors()
	{
		const std::string name = ownName();
		const std::uint64_t components = countOf();
		write(fmt::format("COLOR_SCALARS {} {}\n", name, components));
		copyShades(tuples_ * components, wordsFor(name));
	}

	void copyShades(std::uint64_t count, const std::string& words)
	{
		last_ = words;
		if (!is_text_)
			return void(copyNumbers(NumberType::uint8, count, words));
		std::string shades;
		for (std::uint64_t i = 0; i < count; ++i)
		{
			const double share = at_.real();
			if (!(share >= 0.0 && share <= 1.0))
				throw damaged(fmt::format("{} has a color {} that is no share of 1", words, share));
			shades += static_cast<char>(static_cast<unsigned char>(255.0 * share + 0.5));
		}
		write(shades + "\n");
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
			copyArray(type, tuples * components, wordsFor(own));
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
		while (!ended())
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
			for (TextCursor words(line); !words.atEnd();)
				if (const std::optional<double> number = vp::parseReal(words.word()); number && !std::isfinite(*number))
					is_known = false;
		}
		endKey();
		write("METADATA\n" + names + (count > 0 ? fmt::format("INFORMATION {}\n{}", count, keys) : "") + "\n");
	}

	bool ended() { return at_.place() >= text_.size(); }

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

	// Returns the last value of whole numbers.
	std::int64_t copyArray(const std::string& type, std::uint64_t values, const std::string& words)
	{
		if (type == "bit")
			copyBits(values, words);
		else if (type == "string" || type == "utf8_string")
			copyTexts(values, words);
		else
		{
			const auto known = std::find_if(std::begin(kLegacyTypes), std::end(kLegacyTypes),
			                                [&](const LegacyType& each) { return each.word == type; });
			if (known == std::end(kLegacyTypes))
				throw NotCopied();
			return copyNumbers(known->type, values, words);
		}
		return 0;
	}

	std::int64_t copyNumbers(NumberType type, std::uint64_t values, const std::string& words)
	{
		last_ = words;
		if (values == 0)
			return 0;
		if (is_text_)
		{
			const TextNumbers numbers = readNumbers(text_.substr(at_.place()), type, words,
			                                        {.to = to_, .order = ByteOrder::big, .most = values});
			checkCount(numbers.count, values, words);
			at_.moveTo(at_.place() + numbers.behind);
			write("\n");
			return numbers.last;
		}
		const std::string_view bytes = takeBytes(values, byteSize(type), words);
		if (type != NumberType::int32 && type != NumberType::int64)
			return 0;
		std::uint64_t last = 0;
		for (const char c : bytes.substr(bytes.size() - byteSize(type)))
			last = last << 8 | static_cast<unsigned char>(c);
		return type == NumberType::int32 ? static_cast<std::int32_t>(last) : static_cast<std::int64_t>(last);
	}

	static void checkCount(std::uint64_t there, std::uint64_t wanted, const std::string& words)
	{
		if (there != wanted)
			throw damaged(fmt::format("{} has {} values where {} belong", words, there, wanted));
	}

	// Those of a binary file, which begin behind the line.
	std::string_view takeBytes(std::uint64_t values, std::uint64_t each, const std::string& words)
	{
		endLine();
		const std::uint64_t there = (text_.size() - at_.place()) / each;
		if (there < values)
			checkCount(there, values, words);
		const std::string_view bytes = text_.substr(at_.place(), values * each);
		at_.moveTo(at_.place() + bytes.size());
		write(bytes);
		write("\n");
		return bytes;
	}

	void endLine() { at_.moveTo(std::min(text_.find('\n', at_.place()), text_.size() - 1) + 1); }

	void copyBits(std::uint64_t values, const std::string& words)
	{
		last_ = words;
		if (values == 0)
			return;
		if (!is_text_)
			return void(takeBytes((values + 7) / 8, 1, words));
		std::string bytes((at_.checkedCount(static_cast<std::int64_t>(values), 2) + 7) / 8, '\0');
		for (std::uint64_t i = 0; i < values; ++i)
			if (at_.integer() != 0)
				bytes[i / 8] = static_cast<char>(bytes[i / 8] | 0x80 >> i % 8);
		write(bytes + "\n");
	}

	void copyTexts(std::uint64_t values, const std::string& words)
	{
		last_ = words;
		endLine();
		for (std::uint64_t i = 0; i < values; ++i)
			if (is_text_)
			{
				const std::string text = decodedText(at_.line());
				write(lengthOfText(text.size()) + text);
			}
			else
				copyText(words);
		write("\n");
	}

	void copyText(const std::string& words)
	{
		const std::string_view rest = text_.substr(at_.place());
		if (rest.empty())
			at_.endsEarly();
		constexpr std::size_t kBytes[] = {8, 4, 2, 1};
		const std::size_t bytes = kBytes[static_cast<unsigned char>(rest[0]) >> 6];
		std::uint64_t length = 0;
		for (std::size_t i = 0; i < std::min(bytes, rest.size()); ++i)
			length = length << 8 | static_cast<unsigned char>(rest[i]);
		length &= bytes == 8 ? ~std::uint64_t(0) : (std::uint64_t(1) << (8 * bytes - 2)) - 1;
		if (rest.size() < bytes || length > rest.size() - bytes)
			throw damaged(fmt::format("{} ends too early", words));
		write(rest.substr(0, bytes + length));
		at_.moveTo(at_.place() + bytes + length);
	}

	std::string_view text_;
	TextCursor at_;
	MemoryFile* to_;
	bool is_text_ = false;
	bool has_offsets_ = false;
	bool is_changed_ = false;
	std::optional<bool> is_point_; // of what the arrays that follow are; none before both
	std::uint64_t tuples_ = 0;
	std::set<std::string> names_[2]; // of the arrays of cells and of points
	std::set<std::string> ids_;
	std::string last_ = "its head"; // what was copied last
	std::vector<std::string> warnings_;
};

} // namespace

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
