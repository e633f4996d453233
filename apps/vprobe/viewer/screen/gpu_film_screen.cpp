#include "viewer/screen/gpu_film_screen.h"

#include "render/passes/targets.h"

#include <algorithm>

namespace vp::app
{

Result<std::shared_ptr<const gpu::Image>> FilmScreen::image(const std::shared_ptr<const render::Picture>& picture)
{
	if (picture == last_ && shown_)
		return std::shared_ptr<const gpu::Image>(shown_);
	shown_.reset();
	const VkExtent2D extent{picture->width, picture->height};
	// Takes an image that no frame under way uses.
	const auto fits = [&](const std::shared_ptr<gpu::Image>& image) {
		return image.use_count() == 1 && image->extent().width == extent.width &&
		       image->extent().height == extent.height;
	};
	std::erase_if(images_, [&](const auto& image) { return image.use_count() == 1 && !fits(image); });
	auto free = std::ranges::find_if(images_, fits);
	if (free == images_.end())
	{
		Result<gpu::Image> made =
		    gpu::Image::create(device_,
		                       {.extent = extent,
		                        .format = render::kPictureFormat,
		                        .usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT},
		                       "film picture");
		if (!made)
			return made.error();
		images_.push_back(std::make_shared<gpu::Image>(std::move(*made)));
		free = images_.end() - 1;
	}
	const std::span<const std::uint8_t> pixels(picture->rgba);
	if (Status put = gpu::uploadImage(device_, **free, std::as_bytes(pixels), gpu::kCopyFrom); !put)
		return put.error();
	last_ = picture;
	shown_ = *free;
	return std::shared_ptr<const gpu::Image>(shown_);
}

} // namespace vp::app
