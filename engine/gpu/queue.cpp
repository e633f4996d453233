#include "gpu/device_private.h"
#include "gpu/vk_check.h"

#include <chrono>
#include <thread>

namespace vp::gpu
{

// Waiting longer than this is left to the kernel.
constexpr auto kSpin = std::chrono::microseconds(100);

Result<std::uint64_t> Device::submit(const Submission& submission)
{
	if (isInherited())
		return forkedError();
	if (private_->hasRetired())
		destroyRetired();
	std::vector<VkCommandBufferSubmitInfo> commands;
	for (const VkCommandBuffer buffer : submission.commands)
		commands.push_back({VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO, nullptr, buffer, 0});
	const auto info = [](VkSemaphore semaphore, std::uint64_t value)
	{
		return VkSemaphoreSubmitInfo{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO, nullptr, semaphore, value,
		                             VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,    0};
	};
	std::vector<VkSemaphoreSubmitInfo> wait;
	for (const VkSemaphore semaphore : submission.wait)
		wait.push_back(info(semaphore, 0));
	std::vector<VkSemaphoreSubmitInfo> signal;
	for (const VkSemaphore semaphore : submission.signal)
		signal.push_back(info(semaphore, 0));

	const std::lock_guard lock(private_->queue_mutex);
	signal.push_back(info(timeline_, private_->submitted + 1));
	VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
	submit.waitSemaphoreInfoCount = static_cast<std::uint32_t>(wait.size());
	submit.pWaitSemaphoreInfos = wait.data();
	submit.commandBufferInfoCount = static_cast<std::uint32_t>(commands.size());
	submit.pCommandBufferInfos = commands.data();
	submit.signalSemaphoreInfoCount = static_cast<std::uint32_t>(signal.size());
	submit.pSignalSemaphoreInfos = signal.data();
	const QueueTurn turn(private_->lock_queue, private_->unlock_queue);
	if (Status submitted = check(vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2"); !submitted)
		return submitted.error();
	return ++private_->submitted;
}

// Gets the number of submissions that are done.
VkResult Device::counted(std::uint64_t& number) const
{
	return patiently([&] { return vkGetSemaphoreCounterValue(device_, timeline_, &number); });
}

bool Device::isDone(std::uint64_t number) const
{
	std::uint64_t value = 0;
	return counted(value) == VK_SUCCESS && value >= number;
}

Status Device::wait(std::uint64_t number)
{
	if (isInherited())
		return forkedError();
	const auto begin = std::chrono::steady_clock::now();
	do
	{
		std::uint64_t value = 0;
		if (Status asked = check(counted(value), "vkGetSemaphoreCounterValue"); !asked)
			return asked;
		if (value >= number)
			return Nothing{};
		// A software device computes on these very cores.
		std::this_thread::yield();
	} while (std::chrono::steady_clock::now() - begin < kSpin);
	VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
	info.semaphoreCount = 1;
	info.pSemaphores = &timeline_;
	info.pValues = &number;
	return check(patiently([&] { return vkWaitSemaphores(device_, &info, ~std::uint64_t(0)); }), "vkWaitSemaphores");
}

std::uint64_t Device::lastSubmission() const
{
	const std::lock_guard lock(private_->queue_mutex);
	return private_->submitted;
}

Status Device::waitIdle()
{
	if (isInherited())
		return forkedError();
	// Not only submissions: a presentation still waits for its semaphore.
	const std::lock_guard lock(private_->queue_mutex);
	const QueueTurn turn(private_->lock_queue, private_->unlock_queue);
	return check(patiently([this] { return vkQueueWaitIdle(queue_); }), "vkQueueWaitIdle");
}

VkResult Device::present(const VkPresentInfoKHR& info)
{
	const auto queue_present =
	    reinterpret_cast<PFN_vkQueuePresentKHR>(vkGetDeviceProcAddr(device_, "vkQueuePresentKHR"));
	const std::lock_guard lock(private_->queue_mutex);
	const QueueTurn turn(private_->lock_queue, private_->unlock_queue);
	return queue_present(queue_, &info);
}

void Device::lendQueue(const std::function<void()>& use)
{
	const std::lock_guard lock(private_->queue_mutex);
	use();
}

bool Device::Private::hasRetired()
{
	const std::lock_guard lock(retired_mutex);
	return !retired.empty();
}

std::function<void(VkDevice)> Device::Private::takeDue(std::uint64_t done)
{
	std::function<void(VkDevice)> due;
	const std::lock_guard lock(retired_mutex);
	if (!retired.empty() && retired.front().after <= done)
	{
		due = std::move(retired.front().destroy);
		retired.pop_front();
	}
	return due;
}

void Device::retireLater(std::function<void(VkDevice)> destroy)
{
	const std::uint64_t last = lastSubmission();
	const std::lock_guard lock(private_->retired_mutex);
	private_->retired.push_back({last, std::move(destroy)});
}

void Device::waitForAll() const
{
	const std::lock_guard lock(private_->queue_mutex);
	const QueueTurn turn(private_->lock_queue, private_->unlock_queue);
	patiently([this] { return vkQueueWaitIdle(queue_); }); // fails where the device is lost, and then all is done
}

void Device::destroyRetired()
{
	std::uint64_t done = 0;
	if (counted(done) != VK_SUCCESS)
		return; // a lost device: they go with it
	while (const auto destroy = private_->takeDue(done))
		destroy(device_);
}

} // namespace vp::gpu
