#pragma once

#include "base/result.h"

#include <string>
#include <string_view>

namespace vp::write
{

// File names of a sweep's frames, from a pattern with {frame} in it; {frame:04} writes the number with at least four
// digits. So for other numbered things: of `example` "{sheet}" the pattern has {sheet} in it.
class FrameNames
{
public:
	// The folder must be there: an output error tells the remedy. A pattern without the example's word is a usage
	// error.
	static Result<FrameNames> create(const std::string& pattern, const std::string& example = "{frame:04}");

	std::string of(int frame) const;

private:
	std::string before_;
	std::string after_;
	int digits_ = 1;
};

} // namespace vp::write
