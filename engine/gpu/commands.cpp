#include "gpu/commands.h"

#include "gpu/vk_check.h"

namespace vp::gpu
{

Result<Commands> Commands::create(Device& device, std::string_view name)
{
	VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
	pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
	pool.queueFamilyIndex = device.queueFamily();
	Commands made;
	if (Status created =
	        check(vkCreateCommandPool(device.handle(), &pool, nullptr, &made.pool_), "vkCreateCommandPool");
	    !created)
		return created.error();
	made.device_ = &device;
	VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, made.pool_,
	                                 VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
	if (Status created =
	        check(vkAllocateCommandBuffers(device.handle(), &info, &made.commands_), "vkAllocateCommandBuffers");
	    !created)
		return created.error();
	device.setName(VK_OBJECT_TYPE_COMMAND_POOL, made.pool_, name);
	device.setName(VK_OBJECT_TYPE_COMMAND_BUFFER, made.commands_, name);
	return made;
}

Commands::~Commands()
{
	if (pool_)
		device_->retire([pool = pool_](VkDevice device) { vkDestroyCommandPool(device, pool, nullptr); });
}

Result<VkCommandBuffer> Commands::begin()
{
	if (Status done = wait(); !done)
		return done.error();
	if (Status reset = check(vkResetCommandPool(device_->handle(), pool_, 0), "vkResetCommandPool"); !reset)
		return reset.error();
	VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
	info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
	if (Status begun = check(vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer"); !begun)
		return begun.error();
	return commands_;
}

Result<std::uint64_t> Commands::submit(std::span<const VkSemaphore> wait, std::span<const VkSemaphore> signal)
{
	if (Status ended = check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer"); !ended)
		return ended.error();
	Result<std::uint64_t> number = device_->submit({{&commands_, 1}, wait, signal});
	if (number)
		submitted_ = *number;
	return number;
}

Status Commands::wait()
{
	return submitted_ ? device_->wait(submitted_) : Status(Nothing{});
}

Status Commands::submitAndWait()
{
	if (Result<std::uint64_t> submitted = submit(); !submitted)
		return submitted.error();
	return wait();
}

void Commands::swap(Commands& other) noexcept
{
	std::swap(device_, other.device_);
	std::swap(pool_, other.pool_);
	std::swap(commands_, other.commands_);
	std::swap(submitted_, other.submitted_);
}

Status runOnce(Device& device, const char* name, const std::function<void(VkCommandBuffer)>& record)
{
	Result<Commands> commands = Commands::create(device, name);
	if (!commands)
		return commands.error();
	Result<VkCommandBuffer> recording = commands->begin();
	if (!recording)
		return recording.error();
	{
		const Label label(device, *recording, name);
		record(*recording);
	}
	return commands->submitAndWait();
}

void memoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 before_stages, VkAccessFlags2 before_access,
                   VkPipelineStageFlags2 after_stages, VkAccessFlags2 after_access)
{
	const VkMemoryBarrier2 barrier{
	    VK_STRUCTURE_TYPE_MEMORY_BARRIER_2, nullptr, before_stages, before_access, after_stages, after_access};
	VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
	dependency.memoryBarrierCount = 1;
	dependency.pMemoryBarriers = &barrier;
	vkCmdPipelineBarrier2(commands, &dependency);
}

} // namespace vp::gpu
