#pragma once

#include <cstdint>
#include <string>

namespace vp::read
{

// A warning of a reader. If it counts something, the number stands before the words. Where several processes read
// parts of one file, their numbers are added.
struct ReadWarning
{
	std::uint64_t count = 0; // 0 if the words stand alone
	std::string words;
	std::string words_for_one{}; // if they differ

	std::string text() const
	{
		if (count == 0)
			return words;
		return std::to_string(count) + " " + (count == 1 && !words_for_one.empty() ? words_for_one : words);
	}
};

} // namespace vp::read
