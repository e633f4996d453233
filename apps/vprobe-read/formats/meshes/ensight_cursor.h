#pragma once

#include "vprobe-read/base/mapped_text.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::meshes
{

// A file of an EnSight case in memory. Fortran's records are joined, so it is text or C binary from here on.
class EnSightFile
{
public:
	enum class Form
	{
		text,
		c_binary,
		fortran
	};
	// A geometry, whose first bytes tell its form.
	explicit EnSightFile(const std::string& file);
	// A variable, which has the form of its geometry.
	EnSightFile(const std::string& file, Form form);

	Form form() const { return form_; }
	const std::string& name() const { return name_; }
	// Returns the bytes of a step. A file without marks of steps holds one; `is_step` is false then.
	std::string_view step(std::size_t number, bool& is_step) const;

private:
	void open(const std::string& file);
	std::string_view bytes() const { return joined_.empty() ? mapped_->text() : std::string_view(joined_); }

	std::string name_;
	std::unique_ptr<MappedText> mapped_;
	std::string joined_;
	Form form_ = Form::text;
};

// Walks through a step of a text or C binary file of EnSight. What lies past the end, and what is no number where one
// is wanted, is a Refusal that names the file.
class EnSightCursor
{
public:
	EnSightCursor(const EnSightFile& file, std::string_view step);

	bool isBinary() const { return binary_; }
	bool atEnd();
	// The next line that is not blank and no comment; empty at the end.
	std::string line();
	// The next line as it is.
	std::string description();
	std::int64_t integer();
	// A number of things, each of which takes so many numbers in the file.
	std::int64_t count(std::int64_t numbers_of_each = 1);
	// Refuses a number of things that cannot be in the rest of the file.
	void needRoom(std::int64_t things, std::int64_t numbers_of_each) const;
	std::vector<std::int64_t> integers(std::int64_t count);
	// Values go to to[0], to[stride], ...
	void reals(double* to, std::int64_t count, std::size_t stride = 1);
	std::vector<double> reals(std::int64_t count);
	void skip(std::int64_t numbers);

	// Whether binary numbers have the other byte order: the first integer tells, which is small.
	bool swaps() const { return swaps_; }
	void setSwaps(bool swaps);

	[[noreturn]] void refuse(const std::string& reason) const;
	[[noreturn]] void endsEarly() const;

private:
	void skipSpace();
	double textReal();
	std::uint32_t word();

	const std::string& name_;
	std::string_view bytes_;
	std::size_t at_ = 0;
	bool binary_;
	bool knows_order_ = false;
	bool swaps_ = false;
};

std::vector<std::string> wordsOf(std::string_view line);

// The beginning of a text for a line of an error: bytes that are no printable ASCII become question marks.
std::string ensightWords(std::string_view text);

} // namespace vp::reader::meshes
