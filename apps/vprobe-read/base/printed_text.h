#pragma once

#include <string>

namespace vp::reader
{

// As long as an object of this class exists, it keeps text that is printed to standard error. Libraries report there
// damage that does not stop them.
class PrintedText
{
public:
	PrintedText();
	~PrintedText();
	PrintedText(const PrintedText&) = delete;
	PrintedText& operator=(const PrintedText&) = delete;

	// Returns the text so far, at most its first 64 kB.
	std::string text() const;

private:
	int file_ = -1;
	int standard_error_ = -1;
};

} // namespace vp::reader
