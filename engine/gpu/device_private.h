#pragma once

#include "gpu/device.h"
#include "gpu/instance.h"

#include <deque>
#include <mutex>

namespace vp::gpu
{

struct Device::Private
{
	struct Retired
	{
		std::uint64_t after; // submission
		std::function<void(VkDevice)> destroy;
	};

	std::unique_ptr<Instance> instance; // null for a device of the caller
	std::mutex queue_mutex;             // the queue and the number of its last submission
	std::uint64_t submitted = 0;
	std::mutex retired_mutex;
	std::deque<Retired> retired;
	bool has_memory_budget = false;
	std::unique_ptr<Arena> arena;

	// The locks of a caller's queue; empty for our own queue.
	std::function<void()> lock_queue;
	std::function<void()> unlock_queue;

	bool hasRetired();
	// Takes out an object that no submitted work uses any more, once `done` is done; empty if there is none. Memory is
	// not needed for it.
	std::function<void(VkDevice)> takeDue(std::uint64_t done);

	PFN_vkSetDebugUtilsObjectNameEXT set_name = nullptr;
	PFN_vkCmdBeginDebugUtilsLabelEXT begin_label = nullptr;
	PFN_vkCmdEndDebugUtilsLabelEXT end_label = nullptr;
	PFN_vkGetCalibratedTimestampsEXT calibrated_timestamps = nullptr;
};

// Work with the queue itself; queue_mutex is held.
class QueueTurn
{
public:
	explicit QueueTurn(const std::function<void()>& lock, const std::function<void()>& unlock) : unlock_(unlock)
	{
		if (lock)
			lock();
	}
	~QueueTurn()
	{
		if (unlock_)
			unlock_();
	}
	QueueTurn(const QueueTurn&) = delete;
	QueueTurn& operator=(const QueueTurn&) = delete;

private:
	const std::function<void()>& unlock_;
};

} // namespace vp::gpu
