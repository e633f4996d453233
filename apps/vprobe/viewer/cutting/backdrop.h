#pragma once

#include "render/scene/scene.h"
#include "view/view_spec.h"

#include <optional>
#include <vector>

namespace vp::app
{

// All of a picture but its sheets: camera, colors, outline. A picture of a coarser level takes it from that of the
// finest one, so that only the sheets change between the two.
class Backdrop
{
public:
	Backdrop() = default;
	Backdrop(const render::Scene& scene, const view::ViewSpec& spec);

	// Does nothing if the settings ask for another backdrop. The scene must not outlive this object.
	void putInto(render::Scene& scene, const view::ViewSpec& spec) const;

private:
	std::optional<view::ViewSpec> spec_;
	render::Camera camera_;
	std::optional<render::ValueScale> values_;
	std::optional<Box> bounds_;
	std::vector<render::Segment> outline_;
};

} // namespace vp::app
