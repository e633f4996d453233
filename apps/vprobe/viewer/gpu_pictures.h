#pragma once

#include "base/result.h"
#include "gpu/device.h"
#include "gpu/image.h"

#include <memory>
#include <vector>

namespace vp::app
{

// Images that pictures are drawn into, handed on and taken again once nobody shows them. Of one thread, but whoever
// shows one may let go of it on another.
class Pictures
{
public:
	// render::kPictureFormat, to be copied to and from.
	Result<std::shared_ptr<gpu::Image>> take(gpu::Device& device, VkExtent2D extent);

private:
	std::vector<std::shared_ptr<gpu::Image>> all_;
};

} // namespace vp::app
