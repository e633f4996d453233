#pragma once

#include <string>
#include <string_view>
#include <vector>

// Which arrays the parent asks for.
struct ArrayWish
{
	bool all = true;
	bool first = false;             // also the one that is shown where none is named
	std::vector<std::string> names; // as they are, or behind "point:" or "cell:"

	// Of an array of a block. `is_shown`: the block's first point array, or its first cell array where it has no other.
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
