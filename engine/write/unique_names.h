#pragma once

#include <fmt/format.h>

#include <set>
#include <string>

namespace vp::write
{

// Makes names of columns or properties different: a second "s" becomes "s_2".
class UniqueNames
{
public:
	std::string add(const std::string& wanted)
	{
		std::string name = wanted;
		for (int n = 2; !names_.insert(name).second; ++n)
			name = fmt::format("{}_{}", wanted, n);
		return name;
	}

private:
	std::set<std::string> names_;
};

} // namespace vp::write
