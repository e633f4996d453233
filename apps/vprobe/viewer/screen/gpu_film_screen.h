#pragma once

#include "base/result.h"
#include "gpu/image.h"
#include "render/picture.h"

#include <memory>
#include <vector>

namespace vp::app
{

// Copies pictures of a film loop to the device for the screen. Used by the window's thread only.
class FilmScreen
{
public:
	explicit FilmScreen(gpu::Device& device) : device_(device) {}

	// Returns an image in the use gpu::kCopyFrom. The same picture is copied only once.
	Result<std::shared_ptr<const gpu::Image>> image(const std::shared_ptr<const render::Picture>& picture);

private:
	gpu::Device& device_;
	std::shared_ptr<const render::Picture> last_;
	std::shared_ptr<gpu::Image> shown_;
	std::vector<std::shared_ptr<gpu::Image>> images_;
};

} // namespace vp::app
