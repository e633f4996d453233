#pragma once

#include "base/result.h"
#include "gpu/device.h"
#include "gpu/image.h"

#include <memory>
#include <vector>

namespace vp::app
{

// A pool of images to draw pictures into. An image is reused when nobody shows it any more. Only one thread may take
// images; any thread may release one.
class Pictures
{
public:
	// Returns an image of format render::kPictureFormat that can be copied to and from.
	Result<std::shared_ptr<gpu::Image>> take(gpu::Device& device, VkExtent2D extent);

private:
	std::vector<std::shared_ptr<gpu::Image>> all_;
};

} // namespace vp::app
