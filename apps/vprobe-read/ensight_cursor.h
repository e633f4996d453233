#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

// A structure of an EnSight case that is not checked; not an error.
struct NotUnderstood
{
};

using Words = std::vector<std::string>;

Words wordsOf(const std::string& line);

// Walks through a text or C binary file of EnSight Gold. Whatever lies past the end is a Refusal, but for a line that
// may be missing.
class EnSightCursor
{
public:
	// Of a geometry, whose first line says whether it is binary. Throws NotUnderstood for Fortran records.
	static EnSightCursor ofGeometry(const std::string& file);
	// Of a variable, which is what its geometry is.
	EnSightCursor(const std::string& file, bool binary);

	bool binary() const { return binary_; }

	// Empty at the end.
	std::string line();
	std::int64_t integer();
	// An integer that is a number of things in the file; Refusal where it cannot be.
	std::int64_t count();
	std::int64_t product(std::int64_t a, std::int64_t b) const;

	// So many numbers, which in text stand on so many lines.
	void skip(std::int64_t numbers, std::int64_t lines);
	void skip(std::int64_t numbers) { skip(numbers, numbers); }

	// Of the next so many integers.
	std::int64_t sumOf(std::int64_t numbers);

	[[noreturn]] void endsEarly() const;

private:
	std::string name_;
	std::ifstream in_;
	std::uint64_t size_ = 0;
	bool binary_ = false;
};
