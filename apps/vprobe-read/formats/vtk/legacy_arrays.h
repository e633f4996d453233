#pragma once

#include "grid/field.h"
#include "plain_arrays.h"
#include "vprobe-read/base/memory_file.h"
#include "vprobe-read/text/text_cursor.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vp::reader::vtk
{

std::string inSmallLetters(std::string_view word);

// "%20" is a blank in the names and texts of legacy VTK files.
std::string decodedText(std::string_view text);

// Thrown where VTK's reader has to go on, or to tell what is wrong.
struct NotCopied
{
};

// Copies the numbers and texts of a legacy VTK file, from text or bytes into bytes. `words` name what is copied, for
// errors. Too few values, too many, and words that are no numbers are a Refusal.
class LegacyArrays
{
protected:
	// to: null to see only whether a copy is needed.
	LegacyArrays(std::string_view text, MemoryFile* to) : text_(text), at_(text), to_(to) {}

	void write(std::string_view bytes);
	std::uint64_t countOf();
	// So many finite numbers, on the line of a keyword.
	void copyReals(const std::string& word, std::size_t count);
	// Shares of 1 in text, bytes in binary files.
	void copyShades(std::uint64_t count, const std::string& words);
	// Values of a type by its name in small letters. Returns the last value of whole numbers.
	std::int64_t copyArray(const std::string& type, std::uint64_t values, const std::string& words);
	std::int64_t copyNumbers(grid::NumberType type, std::uint64_t values, const std::string& words);
	// Notes where the values lie that were copied last. on_points: nothing for those of neither points nor cells.
	void notePlain(std::optional<bool> on_points, const std::string& name, const std::string& type,
	               std::uint64_t tuples, std::uint64_t components);

	std::string_view text_;
	text::Cursor at_;
	MemoryFile* to_;
	bool is_text_ = false;
	bool is_changed_ = false;       // what is copied from bytes is not what was there
	std::string last_ = "its head"; // what was copied last
	std::vector<arrays::PlainArray> plain_;

private:
	std::string_view takeBytes(std::uint64_t values, std::uint64_t each, const std::string& words);
	void endLine();
	void copyBits(std::uint64_t values, const std::string& words);
	void copyTexts(std::uint64_t values, const std::string& words);
	void copyText(const std::string& words);
};

} // namespace vp::reader::vtk
