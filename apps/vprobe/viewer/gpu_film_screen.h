#pragma once

#include "base/result.h"
#include "gpu/image.h"
#include "render/picture.h"

#include <memory>
#include <vector>

namespace vp::app
{

// Puts pictures of a film loop onto the device, to be placed on the screen. Of the window's thread.
class FilmScreen
{
public:
	explicit FilmScreen(gpu::Device& device) : device_(device) {}

	// gpu::kCopyFrom. The same picture twice is put there once.
	Result<std::shared_ptr<const gpu::Image>> image(const std::shared_ptr<const render::Picture>& picture);

private:
	gpu::Device& device_;
	std::shared_ptr<const render::Picture> last_;
	std::shared_ptr<gpu::Image> shown_;
	std::vector<std::shared_ptr<gpu::Image>> images_;
};

} // namespace vp::app
