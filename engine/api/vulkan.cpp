#include "api/states.h"
#include "gpu/commands.h"
#include "gpu/device_choice.h"
#include "render/passes/targets.h"

#include <vprobe/vulkan.h>

#include <fmt/format.h>

namespace vprobe
{

namespace
{

// Covers everything that the caller submitted before, or will submit later.
vp::gpu::ImageUse anyUse(VkImageLayout layout)
{
	return {layout, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
}

vp::Status checkTarget(const DatasetState& state, const VulkanTarget& target)
{
	const auto wrong = [](std::string message) { return vp::Error{vp::ErrorKind::usage, std::move(message)}; };
	if (!state.has_callers_device)
		return wrong("the data set has no device of yours; call useDevice() at first");
	if (target.image == VK_NULL_HANDLE)
		return wrong("there is no image to draw into");
	switch (target.format)
	{
	case VK_FORMAT_R8G8B8A8_UNORM:
	case VK_FORMAT_R8G8B8A8_SRGB:
	case VK_FORMAT_B8G8R8A8_UNORM:
		break;
	default:
		return wrong(fmt::format("an image of VkFormat {} cannot be drawn into; use R8G8B8A8_UNORM, R8G8B8A8_SRGB or "
		                         "B8G8R8A8_UNORM",
		                         static_cast<int>(target.format)));
	}
	if (target.after == VK_IMAGE_LAYOUT_UNDEFINED || target.after == VK_IMAGE_LAYOUT_PREINITIALIZED)
		return wrong("an image cannot be left in an undefined layout; say what you use it for");
	return vp::Nothing{};
}

// The library's own image for the picture. It is kept from call to call.
vp::Status prepareImage(DatasetState& state, VkExtent2D extent)
{
	if (state.target && state.target->extent().width == extent.width && state.target->extent().height == extent.height)
		return vp::Nothing{};
	vp::gpu::ImageInfo info;
	info.extent = extent;
	info.format = vp::render::kPictureFormat;
	info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
	vp::Result<vp::gpu::Image> made = vp::gpu::Image::create(*state.session->device(), info, "picture for the caller");
	if (!made)
		return made.error();
	state.target.emplace(std::move(*made));
	return vp::Nothing{};
}

vp::Status copyTo(vp::gpu::Device& device, const vp::gpu::Image& picture, const VulkanTarget& target)
{
	const auto record = [&](VkCommandBuffer commands)
	{
		vp::gpu::imageBarrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, anyUse(target.before),
		                      vp::gpu::kCopyTo);
		const VkImageSubresourceLayers layer{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
		if (target.format == VK_FORMAT_B8G8R8A8_UNORM)
		{
			const VkOffset3D end{static_cast<int>(target.width), static_cast<int>(target.height), 1};
			const VkImageBlit all{layer, {{0, 0, 0}, end}, layer, {{0, 0, 0}, end}};
			vkCmdBlitImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
			               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &all, VK_FILTER_NEAREST);
		}
		else
		{
			// The bytes are copied as they are, since those of the picture are sRGB already.
			const VkImageCopy all{layer, {}, layer, {}, {target.width, target.height, 1}};
			vkCmdCopyImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
			               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &all);
		}
		vp::gpu::imageBarrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vp::gpu::kCopyTo,
		                      anyUse(target.after));
	};
	return vp::gpu::runOnce(device, "picture for the caller", record);
}

} // namespace

vp::Status DatasetState::drawForCaller(const Cut& cut, VkExtent2D extent)
{
	const vp::Result<Cut> drawn = readyToDraw(cut, {});
	if (!drawn)
		return drawn.error();
	if (vp::Status ready = prepareImage(*this, extent); !ready)
		return ready;
	const vp::session::Frame& frame = *drawn->state_->frame;
	const vp::Status done = painter->drawInto(*target, frame.slice, frame.sheets, frame.contours);
	session->timeline()->takeSections();
	return done;
}

Result<VulkanNeeds> VulkanNeeds::of(VkPhysicalDevice physical)
{
	return guarded(
	    [&]() -> Result<VulkanNeeds>
	    {
		    const vp::gpu::Candidate candidate = vp::gpu::examine(physical, false);
		    if (!candidate.lacks.empty())
			    return publicError(vp::gpu::unusable(candidate));
		    VulkanNeeds needs;
		    needs.features_ = std::make_shared<vp::gpu::WantedFeatures>(physical);
		    needs.queue_family_ = candidate.queue_family;
		    return needs;
	    });
}

const VkPhysicalDeviceFeatures2* VulkanNeeds::features() const
{
	return &static_cast<const vp::gpu::WantedFeatures*>(features_.get())->all();
}

Status useDevice(const Dataset& data, const VulkanDevice& device)
{
	return guarded(
	    [&]() -> Status
	    {
		    if (!device.instance || !device.physical || !device.device || !device.queue)
			    return Error{ErrorKind::usage, "a device needs instance, physical, device and queue"};
		    vp::Result<std::unique_ptr<vp::gpu::Device>> adopted =
		        vp::gpu::Device::adopt({device.instance, device.physical, device.device, device.queue,
		                                device.queue_family, device.lock_queue, device.unlock_queue});
		    if (!adopted)
			    return publicError(adopted.error());
		    DatasetState& state = stateOf(data);
		    const std::lock_guard lock(state.mutex);
		    if (vp::Status taken = state.takeDevice(std::move(*adopted)); !taken)
			    return publicError(taken.error());
		    return Nothing{};
	    });
}

Status drawInto(const Dataset& data, const Cut& cut, const View& view, const VulkanTarget& target)
{
	return guarded(
	    [&]() -> Status
	    {
		    View sized = view;
		    sized.size(target.width, target.height);
		    DatasetState& state = stateOf(data);
		    const auto work = [&]() -> vp::Result<Nothing>
		    {
			    if (vp::Status fits = checkTarget(state, target); !fits)
				    return fits.error();
			    vp::Status done = state.drawForCaller(cut, {target.width, target.height});
			    if (done)
				    done = copyTo(*state.session->device(), *state.target, target);
			    if (!done)
				    return state.afterFailure(done.error());
			    return Nothing{};
		    };
		    return withView<Nothing>(state, sized, work);
	    });
}

} // namespace vprobe
