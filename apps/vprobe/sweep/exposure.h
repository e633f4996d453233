#pragma once

#include "render/picture.h"

#include <cstdint>
#include <vector>

namespace vp::app
{

// Puts the frames of a sweep into one picture, as the eye keeps them: the light of the frames is added to the light of
// the empty scene.
class Exposure
{
public:
	// empty: the empty scene, in the size of the frames.
	explicit Exposure(render::Picture empty);

	void add(const render::Picture& frame);
	// A pixel that many frames touch gets the mean of these frames; "many" is the median over all pixels that any frame
	// touches. A pixel that fewer frames touch is fainter in proportion.
	render::Picture picture() const;

private:
	render::Picture empty_;
	std::vector<float> light_;           // per pixel and channel: what the frames add to the empty scene, linear
	std::vector<std::uint32_t> touched_; // per pixel: frames that differ from the empty scene
};

} // namespace vp::app
