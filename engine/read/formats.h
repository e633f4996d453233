#pragma once

#include <span>
#include <string>
#include <string_view>

namespace vp::read
{

// The files of an input: one, or one that may link to others, or files beside it too, or all in its folder. Those of
// `linked` count as alone where the sizes of files matter, since few have links.
enum class FormatFiles
{
	alone,
	linked,
	beside,
	folder
};

// A row of format_table.inl.
struct Format
{
	std::string_view name;    // the value that --format takes
	std::string_view endings; // endings of file names, separated by spaces; may be empty
	std::string_view what;
	std::string_view read;
	std::string_view by; // the library that reads it
	FormatFiles files;
	bool in_more; // whether vprobe-read-more reads it
};

// In the order in which they are recognized.
std::span<const Format> formats();

// Null if there is none.
const Format* findFormat(std::string_view name);

// The first format that a file's name suits, null if there is none.
const Format* formatOfEnding(std::string_view file);

// Returns true if some format that a file's name suits may name files beside it, or if none suits.
bool mayNameFiles(std::string_view file);

// All names, or all endings, separated by spaces.
std::string formatNames();
std::string readableEndings();

} // namespace vp::read
