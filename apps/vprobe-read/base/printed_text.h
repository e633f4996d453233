#pragma once

#include <string>

// While one lives, what is printed to standard error is kept instead. Libraries tell there of damage that they go on
// after.
class PrintedText
{
public:
	PrintedText();
	~PrintedText();
	PrintedText(const PrintedText&) = delete;
	PrintedText& operator=(const PrintedText&) = delete;

	// So far; at most its first 64 kB.
	std::string text() const;

private:
	int file_ = -1;
	int standard_error_ = -1;
};
