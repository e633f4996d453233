#pragma once

#include <string>
#include <vector>

namespace vp
{

// Returns true if a name comes before another one: numbers in them are compared as numbers.
bool comesBefore(const std::string& a, const std::string& b);

// Returns true if the ending is one of pictures of two dimensions, of which a volume may be made.
bool isPictureName(const std::string& file);

// Returns true if the last part of a path has *, ? or [, and there is no file of that name.
bool isFilePattern(const std::string& path);

// Returns the files that a pattern matches, in that order, or all files of a folder. Hidden ones are left out.
std::vector<std::string> filesOfPattern(const std::string& path);

} // namespace vp
