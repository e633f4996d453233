#pragma once

#include "render/picture.h"

#include <cstdint>
#include <vector>

namespace vp::app
{

// The frames of a sweep in one picture, as the eye keeps them: their light is added up over the empty scene's.
class Exposure
{
public:
	// The empty scene, of the frames' size.
	explicit Exposure(render::Picture empty);

	void add(const render::Picture& frame);
	// Pixels that at least as many frames show as show the median of all shown pixels have their frames' mean; the
	// fewer show a pixel, the fainter it is.
	render::Picture picture() const;

private:
	render::Picture empty_;
	std::vector<float> light_;           // per pixel and channel: what the frames add to the empty scene, linear
	std::vector<std::uint32_t> touched_; // per pixel: frames that differ from the empty scene
};

} // namespace vp::app
