#pragma once

#include "base/result.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vp
{

// Counters of the processor for this process, all its threads together, outside of the system. Threads that start later
// are counted too.
class ProcessorCounters
{
public:
	enum Counter : std::uint8_t
	{
		instructions,
		cache_misses, // those of the last cache
		count_of_counters
	};
	using Counts = std::array<std::uint64_t, count_of_counters>;

	// Returns why there are none: many virtual machines have no counters, and a system may keep them for itself.
	static Result<ProcessorCounters> open();
	~ProcessorCounters();
	ProcessorCounters(ProcessorCounters&& other) noexcept : files_(std::move(other.files_)) { other.files_ = {}; }
	ProcessorCounters& operator=(ProcessorCounters&&) = delete;

	// Returns the counts since open().
	Counts read() const;

private:
	ProcessorCounters() = default;

	std::array<std::vector<int>, count_of_counters> files_; // one for each thread
};

} // namespace vp
