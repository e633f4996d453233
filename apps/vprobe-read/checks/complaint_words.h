#pragma once

#include <string>
#include <string_view>

// A library's complaint speaks of its own insides, in its own words. These say what it means for the file.

// Whether memory ran out. Then the file need not be damaged.
bool tellsOfMemory(std::string_view complaint);

// What is wrong, and where, as far as the complaint tells.
std::string inOurWords(std::string_view complaint);
