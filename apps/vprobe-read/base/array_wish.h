#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vp::reader
{

// Says which arrays the parent asks for.
struct ArrayWish
{
	bool all = true;
	bool first = false;             // also the one that is shown where none is named
	std::vector<std::string> names; // as they are, or behind "point:" or "cell:"

	// Returns true if the parent asks for this array of a block. `is_shown`: it is the block's first point array, or
	// its first cell array if there is no point array.
	bool wants(std::string_view association, std::string_view name, bool is_shown) const
	{
		if (all || (first && is_shown))
			return true;
		for (const std::string_view each : names)
		{
			const bool is_prefixed = each.size() == association.size() + 1 + name.size() &&
			                         each.starts_with(association) && each[association.size()] == ':' &&
			                         each.ends_with(name);
			if (each == name || is_prefixed)
				return true;
		}
		return false;
	}
};

} // namespace vp::reader
