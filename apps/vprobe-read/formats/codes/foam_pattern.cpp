#include "foam_pattern.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

namespace vp::reader::codes
{

namespace
{

// Counts in braces and references back make the time and the memory of glibc's matcher unbounded.
constexpr std::size_t kMaxExpression = 1024;
constexpr std::size_t kMaxMatched = 1024;

bool takesLong(std::string_view expression)
{
	for (std::size_t i = 0; i + 1 < expression.size(); ++i)
		if (expression[i] == '\\' && expression[i + 1] >= '1' && expression[i + 1] <= '9')
			return true;
	return expression.size() > kMaxExpression || expression.find('{') != expression.npos;
}

} // namespace

FoamPattern::FoamPattern(std::string_view expression)
{
	const std::string whole = fmt::format("^({})$", expression);
	if (takesLong(expression) || expression.find('\0') != expression.npos ||
	    regcomp(&compiled_, whole.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
		throw Refusal(
		    fmt::format("its pattern \"{}\" is not read; name the patches themselves", expression.substr(0, 40)));
}

FoamPattern::~FoamPattern()
{
	regfree(&compiled_);
}

bool FoamPattern::fits(std::string_view name) const
{
	return name.size() <= kMaxMatched && regexec(&compiled_, std::string(name).c_str(), 0, nullptr, 0) == 0;
}

} // namespace vp::reader::codes
