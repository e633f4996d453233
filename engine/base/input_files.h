#pragma once

#include <optional>
#include <string>

namespace vp
{

enum class InputKind : unsigned char
{
	data, // anything that was read
	state // a saved state, whose place a newer state may take
};

/// Remembers a file that this process reads from, by its place and by its identity. No output may take its place. What
/// is no file (a folder, "-", a built-in data set) is left out. Any thread.
void noteInput(const std::string& path, InputKind kind = InputKind::data);

/// Returns what a file was read as, under whatever name: links and relative spellings count. Returns nothing for a file
/// that was not read.
std::optional<InputKind> inputAt(const std::string& path);

} // namespace vp
