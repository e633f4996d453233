#pragma once

#include "vprobe-read/arrays/packed_array.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace vp::reader::quick
{

// Does work in parts. Any thread may do any part, in any order.
class Tasks
{
public:
	// `threads`: the largest number of threads to use.
	explicit Tasks(int threads) : threads_(threads) {}

	using Part = std::function<void(std::size_t part, arrays::Scratch& scratch)>;
	void add(std::size_t parts, Part work);
	// Does all work that was added. The first exception ends it, and is thrown again.
	void run();

private:
	struct Job
	{
		std::size_t first; // its parts' place among all
		Part work;
	};
	void workOn(std::size_t part, arrays::Scratch& scratch) const;

	int threads_;
	std::vector<Job> jobs_;
	std::size_t parts_ = 0;
};

} // namespace vp::reader::quick
