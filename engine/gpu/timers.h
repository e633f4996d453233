#pragma once

#include "gpu/device.h"

#include <string>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::gpu
{

// Timestamps around passes, read back later in one go as GPU sections of a timeline. Where somebody counts invocations
// (invocations.h), passes count theirs, too: they must not lie in each other. Not thread safe: one per recording
// thread.
class Timers
{
public:
	// Its sections stand in a row of their own.
	explicit Timers(Device& device, const char* row = "GPU");
	~Timers();
	Timers(Timers&& other) noexcept;
	Timers& operator=(Timers&&) = delete;

	// Writes the timestamps and the debug label around what is recorded in between. `name` is kept as it is: a literal.
	std::size_t begin(VkCommandBuffer commands, const char* name);
	void end(VkCommandBuffer commands, std::size_t section);

	// Puts the sections of finished submissions onto the timeline and forgets them all. Call it when everything
	// recorded is done.
	void collect(Timeline& timeline);
	void forget();

private:
	// Queries are made in pools of this many sections; a traversal has hundreds of generations.
	static constexpr std::uint32_t kPoolSections = 256;

	struct Section
	{
		const char* name;
		std::uint64_t recorded_ns; // steady clock: the anchor where the clocks cannot be calibrated
		bool is_counted = false;   // by a query of statistics
	};
	// Makes and resets the pool for a section, unless it is there. Its entry is null if there is no memory.
	void makePool(std::vector<VkQueryPool>& pools, std::size_t section, const VkQueryPoolCreateInfo& info);
	void collectTimes(Timeline& timeline);
	void collectInvocations();

	Device* device_;
	std::uint32_t row_;
	std::vector<VkQueryPool> pools_;      // for timestamps, two for each section
	std::vector<VkQueryPool> statistics_; // one query for each section
	std::vector<Section> sections_;
};

// A section over the commands recorded during its life.
class TimedPass
{
public:
	TimedPass(Timers& timers, VkCommandBuffer commands, const char* name)
	    : timers_(timers), commands_(commands), section_(timers.begin(commands, name))
	{
	}
	~TimedPass() { timers_.end(commands_, section_); }
	TimedPass(const TimedPass&) = delete;
	TimedPass& operator=(const TimedPass&) = delete;

private:
	Timers& timers_;
	VkCommandBuffer commands_;
	std::size_t section_;
};

} // namespace vp::gpu
