#pragma once

#include <string>
#include <string_view>

#include <regex.h>

namespace vp::reader::codes
{

// A key in quotes: an extended regular expression of POSIX that has to fit the whole name, as OpenFOAM takes it.
class FoamPattern
{
public:
	// Throws a Refusal if it is none, or one that takes long.
	explicit FoamPattern(std::string_view expression);
	~FoamPattern();
	FoamPattern(const FoamPattern&) = delete;
	FoamPattern& operator=(const FoamPattern&) = delete;

	bool fits(std::string_view name) const;

private:
	regex_t compiled_;
};

} // namespace vp::reader::codes
