#include "viewer/cutting/gpu_pictures.h"

#include "render/passes/targets.h"

namespace vp::app
{

Result<std::shared_ptr<gpu::Image>> Pictures::take(gpu::Device& device, VkExtent2D extent)
{
	const auto fits = [&](const gpu::Image& image)
	{ return image.extent().width == extent.width && image.extent().height == extent.height; };
	std::erase_if(all_, [&](const auto& picture) { return picture.use_count() == 1 && !fits(*picture); });
	for (const auto& picture : all_)
		if (picture.use_count() == 1 && fits(*picture)) // an image of another size may have become free just now
			return picture;
	Result<gpu::Image> made =
	    gpu::Image::create(device,
	                       {.extent = extent,
	                        .format = render::kPictureFormat,
	                        .usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT},
	                       "shown picture");
	if (!made)
		return made.error();
	return all_.emplace_back(std::make_shared<gpu::Image>(std::move(*made)));
}

} // namespace vp::app
