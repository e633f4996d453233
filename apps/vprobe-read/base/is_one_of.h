#pragma once

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace vp::reader
{

inline bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
	return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace vp::reader
