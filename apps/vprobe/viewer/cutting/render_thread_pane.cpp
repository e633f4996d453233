#include "interact/camera_moves.h"
#include "picture/facing.h"
#include "probe/presets.h"
#include "render/passes/targets.h"
#include "render/scene/outline.h"
#include "viewer/cutting/render_thread.h"

#include <algorithm>

namespace vp::app
{

namespace
{

// A sheet alone, without what is written around it. Seen straight on a perspective is true to scale.
render::Scene paneScene(const render::Scene& scene, const render::SheetDrawing& sheet, PixelSize size)
{
	render::Scene pane;
	pane.sheets = {sheet};
	pane.values = scene.values;
	pane.bounds = scene.bounds;
	pane.look = scene.look;
	pane.look.width = size.width;
	pane.look.height = size.height;
	pane.look.legend = pane.look.axes = pane.look.box_axes = false;
	pane.look.title.clear();
	pane.look.caption.clear();
	return pane;
}

// The grid's outline laid into the sheet's plane: so the sheet's scale does not depend on how deep it lies.
std::vector<Vec3> flatExtent(const grid::BlockSet& blocks, const probe::Sheet& sheet)
{
	std::vector<Vec3> extent = render::extentOf(blocks);
	for (Vec3& point : extent)
		point -= glm::dot(point - sheet.origin, sheet.normal) * sheet.normal;
	return extent;
}

} // namespace

// The sheet of a scene that a wish's pane shows; null where that is hidden, or no plane.
const render::SheetDrawing* RenderThread::sheetOfPane(const PresentedFrame& shown, const render::Scene& scene)
{
	const std::size_t sheet = shown.wish.pane->sheet;
	const auto& sheets = shown.probe.sheets;
	if (sheet >= sheets.size() || sheets[sheet].wishes.hidden || scene.sheets.size() != shown.cut->sheets.size())
		return nullptr;
	const auto end = sheets.begin() + static_cast<std::ptrdiff_t>(sheet);
	const auto before =
	    std::count_if(sheets.begin(), end, [](const probe::Sheet& each) { return !each.wishes.hidden; });
	return &scene.sheets[static_cast<std::size_t>(before)];
}

Status RenderThread::drawPane(PresentedFrame& shown, const render::Scene& scene)
{
	shown.pane.reset();
	if (!shown.wish.pane)
		return Nothing{};
	const render::SheetDrawing* sheet = sheetOfPane(shown, scene);
	if (!sheet)
		return Nothing{};
	if (!pane_renderer_)
	{
		Result<render::Renderer> made = render::Renderer::create(*device_);
		if (!made)
			return made.error();
		pane_renderer_.emplace(std::move(*made));
	}
	const PixelSize size = shown.wish.pane->size;
	render::Scene pane = paneScene(scene, *sheet, size);
	const render::Frame frame = render::pictureFrame(pane);
	// It looks as the flat pictures of vprobe slice do.
	const grid::Orientation orientation = picture::orientationOf(finest_.session->blocks());
	probe::Sheet facing = picture::facingSheet(sheet->sheet, orientation, shown.wish.spec.probe.up.has_value());
	if (facing.window && probe::reachesAround(*facing.window, finest_.session->blocks().bounds()))
		facing.window.reset(); // its data fill the pane
	pane.camera =
	    interact::faceSheet({scene.camera, frame}, facing, flatExtent(finest_.session->blocks(), sheet->sheet));
	Result<std::shared_ptr<gpu::Image>> image = pane_pictures_.take(*device_, {size.width, size.height});
	if (!image)
		return image.error();
	if (Result<bool> drawn = pane_renderer_->drawInto(pane, **image, {}, at_->session->timeline()); !drawn)
		return drawn.error();
	shown.pane = PresentedFrame::Pane{*image, shown.wish.pane->sheet, pane.camera, frame};
	return Nothing{};
}

} // namespace vp::app
