#pragma once

#include <algorithm>
#include <cstdlib>

namespace vp::test
{

/// A test takes each of many similar cases, but every seventh in a build with sanitizers: there each takes some ten
/// times as long, and the first few already enter the code that is watched. VPROBE_TRY_EVERY asks for every so many,
/// where the same test runs again on a second device. With VPROBE_LONG set: every one.
inline int tryEvery()
{
	static const int every = []
	{
		if (std::getenv("VPROBE_LONG"))
			return 1;
#ifdef VPROBE_SANITIZED
		return 7;
#else
		const char* asked = std::getenv("VPROBE_TRY_EVERY");
		return asked ? std::max(1, std::atoi(asked)) : 1;
#endif
	}();
	return every;
}

/// How many of `full` cases that makes; at least 1.
inline int tries(int full)
{
	return (full + tryEvery() - 1) / tryEvery();
}

/// Counts the cases of a test, and says whether the next one is tried.
class Taken
{
public:
	bool next() { return count_++ % tryEvery() == 0; }

private:
	int count_ = 0;
};

/// For tests that are made of many parameters, of which each takes long: every one, or every third with sanitizers.
inline int takeParameterEvery()
{
	return tryEvery() == 1 ? 1 : 3;
}

} // namespace vp::test
