#include "viewer/cutting/backdrop.h"

namespace vp::app
{

Backdrop::Backdrop(const render::Scene& scene, const view::ViewSpec& spec)
    : spec_(spec), camera_(scene.camera), values_(scene.values), bounds_(scene.bounds),
      outline_(scene.outline.begin(), scene.outline.end())
{
}

void Backdrop::putInto(render::Scene& scene, const view::ViewSpec& spec) const
{
	if (!spec_ || !(spec_->look == spec.look) || !(spec_->input.time == spec.input.time) ||
	    spec_->probe.array != spec.probe.array || spec_->probe.component != spec.probe.component)
		return;
	if (!spec.look.camera.followsSheet())
		scene.camera = camera_;
	scene.values = values_;
	scene.bounds = bounds_;
	scene.outline = outline_;
}

} // namespace vp::app
