#include "viewer/cutting/spec_edits.h"

namespace vp::app
{

void placeProbe(view::ProbeSpec& spec, const probe::Probe& before, const probe::Probe& after)
{
	if (!(before.frame == after.frame))
	{
		spec.origin = after.frame.origin;
		spec.normal = after.frame.normal;
		spec.up = after.frame.up;
	}
	if (before.sheets == after.sheets)
		return;
	spec.shape = view::ProbeShape::own;
	spec.own = probe::ProbeFile{after, true};
	spec.window.reset();
	spec.vanes.reset();
	spec.offsets.clear();
	spec.sheets.reset();
}

std::optional<render::Camera> cameraOf(const view::LookSpec& look)
{
	if (look.camera.kind != render::CameraChoice::Kind::fixed)
		return std::nullopt;
	return render::projected(look.camera, look.projection).camera;
}

} // namespace vp::app
