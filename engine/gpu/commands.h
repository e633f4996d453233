#pragma once

#include "gpu/device.h"

#include <functional>
#include <utility>

namespace vp::gpu
{

// A command buffer that is recorded and submitted again and again, with a pool of its own, so each thread may hold one.
class Commands
{
public:
	Commands() = default;
	static Result<Commands> create(Device& device, std::string_view name);
	~Commands();
	Commands(Commands&& other) noexcept { swap(other); }
	Commands& operator=(Commands&& other) noexcept
	{
		Commands taken(std::move(other));
		swap(taken);
		return *this;
	}

	// Waits for the last submission, forgets its commands and starts recording.
	Result<VkCommandBuffer> begin();
	// Ends the recording and submits it; the number is for wait().
	Result<std::uint64_t> submit(std::span<const VkSemaphore> wait = {}, std::span<const VkSemaphore> signal = {});
	// Waits for the last submission.
	Status wait();
	Status submitAndWait();

	VkCommandBuffer handle() const { return commands_; }

private:
	void swap(Commands& other) noexcept;

	Device* device_ = nullptr;
	VkCommandPool pool_ = VK_NULL_HANDLE;
	VkCommandBuffer commands_ = VK_NULL_HANDLE;
	std::uint64_t submitted_ = 0;
};

// Records, submits and waits, for work outside the hot path.
Status runOnce(Device& device, const char* name, const std::function<void(VkCommandBuffer)>& record);

// The stage of vkCmdUpdateBuffer is CLEAR, as it is one of the clear commands. Validation layers before 1.3.280 expect
// COPY.
constexpr VkPipelineStageFlags2 kUpdateStages = VK_PIPELINE_STAGE_2_CLEAR_BIT | VK_PIPELINE_STAGE_2_COPY_BIT;

// One global memory barrier.
void memoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 before_stages, VkAccessFlags2 before_access,
                   VkPipelineStageFlags2 after_stages, VkAccessFlags2 after_access);

} // namespace vp::gpu
