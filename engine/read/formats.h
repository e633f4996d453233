#pragma once

#include <span>
#include <string>
#include <string_view>

namespace vp::read
{

// The files of an input: one, or files beside it too, or all in its folder.
enum class FormatFiles
{
	alone,
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

// All names, or all endings, separated by spaces.
std::string formatNames();
std::string readableEndings();

} // namespace vp::read
