#include "view/view_state.h"

#include <fmt/format.h>

namespace vp::app
{

namespace
{

// Read again they are the same numbers.
std::string exact(const Vec3& v, const char* between)
{
	return fmt::format("{1}{0}{2}{0}{3}", between, v.x, v.y, v.z);
}

} // namespace

SavedOptions savedOptions(const ViewState& state, const std::string& file)
{
	SavedOptions saved;
	saved.probe = state.probe;
	saved.look = state.look;
	saved.path = state.path;
	saved.save = file;
	return saved;
}

void placeProbe(ProbeOptions& options, const probe::Probe& before, const probe::Probe& after)
{
	if (!(before.frame == after.frame))
	{
		const probe::Frame& frame = after.frame;
		options.origin = {frame.origin.x, frame.origin.y, frame.origin.z};
		options.normal = exact(frame.normal, " ");
		options.up = {frame.up.x, frame.up.y, frame.up.z};
	}
	if (before.sheets == after.sheets)
		return;
	options.probe.clear();
	options.own_probe = probe::ProbeFile{after, true};
	options.window.clear();
	options.vanes.reset();
	options.offsets.clear();
	options.sheets.reset();
}

void takePlace(ProbeOptions& options, const ProbeOptions& from)
{
	options.origin = from.origin;
	options.normal = from.normal;
	options.up = from.up;
	options.window = from.window;
	options.probe = from.probe;
	options.own_probe = from.own_probe;
	options.vanes = from.vanes;
	options.offsets = from.offsets;
	options.sheets = from.sheets;
}

std::optional<render::Camera> cameraOf(const LookOptions& look)
{
	Result<render::CameraChoice> choice = render::parseCamera(look.camera);
	if (!choice || choice->kind != render::CameraChoice::Kind::fixed)
		return std::nullopt;
	return choice->camera;
}

void setCamera(LookOptions& look, const render::Camera& camera)
{
	look.camera =
	    fmt::format("{},{},{}", exact(camera.position, ","), exact(camera.focal_point, ","), exact(camera.up, ","));
}

} // namespace vp::app
