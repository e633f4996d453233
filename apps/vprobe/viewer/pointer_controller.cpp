#include "viewer/pointer_controller.h"

#include "interact/camera_moves.h"
#include "interact/nudge.h"

#include <cmath>

namespace vp::app
{

namespace
{

constexpr double kZoomFactor = 1.15; // of a notch of the wheel
constexpr const char* kDragKey = "drag";
constexpr const char* kWheelKey = "wheel";

} // namespace

std::vector<interact::HandleShape> PointerController::shapes() const
{
	const auto view = bench_.view();
	if (!view || !bench_.facts() || !bench_.parts.handles)
		return {};
	interact::HandleOptions options{.ui_scale = ui_scale_};
	if (bench_.parts.own)
		options.own = bench_.sheet();
	return interact::handlesOf(bench_.shown()->probe, *view, bench_.facts()->bounds, options);
}

// Where the grid is cut there, the nearest sheet.
std::optional<interact::SheetHit> PointerController::sheetAt(const glm::dvec2& pixel) const
{
	const auto view = bench_.view();
	if (!view || !bench_.facts())
		return std::nullopt;
	for (const interact::SheetHit& hit :
	     interact::pickSheets(bench_.shown()->probe, *view, pixel, bench_.facts()->bounds))
		return hit;
	return std::nullopt;
}

void PointerController::look()
{
	handle_.reset();
	sheet_.reset();
	const auto view = bench_.view();
	if (!view || !part_.holds(at_))
		return;
	handle_ = interact::pickHandle(shapes(), *view, inScene(), 6.0 * ui_scale_);
	sheet_ = sheetAt(inScene());
}

void PointerController::moveTo(const glm::dvec2& at)
{
	at_ = at;
	if (isBusy())
		return drag();
	look();
}

void PointerController::press(Button button, bool within)
{
	const auto view = bench_.view();
	if (isBusy() || !within || !view || !part_.holds(at_))
		return;
	look();
	held_ = button;
	bench_.endMerge();
	const Vec3 pivot = sheet_ ? sheet_->point : view->camera.focal_point;
	if (button == Button::left && handle_)
		grip_.emplace<interact::Drag>(*handle_, inScene(), *view, bench_.probe(), bench_.facts()->bounds, ui_scale_);
	else if (button == Button::left && sheet_)
		takeSheet();
	else
		grip_ = CameraGrip{*view, inScene(), button == Button::middle, pivot};
}

void PointerController::takeSheet()
{
	bench_.chooseSheet(sheet_->sheet);
	if (bench_.parts.magnifier)
		grip_ = LensGrip{bench_.probe(), *bench_.view(), sheet_->sheet, sheet_->uv};
	else
		grip_.emplace<interact::Drag>(
		    interact::Handle{interact::HandleKind::sheet, 2, sheet_->sheet, 0, bench_.parts.own}, inScene(),
		    *bench_.view(), bench_.probe(), bench_.facts()->bounds, ui_scale_);
}

void PointerController::release(Button button)
{
	if (held_ != button)
		return;
	held_.reset();
	grip_ = std::monostate();
	bench_.endMerge();
	look();
}

// Alt takes a sheet out of its probe, or a window's side with its opposite.
interact::Modifiers PointerController::keysFor(const interact::Drag& drag) const
{
	interact::Modifiers keys = keys_;
	const interact::HandleKind kind = drag.handle().kind;
	const bool sizes = kind == interact::HandleKind::edge || kind == interact::HandleKind::corner;
	keys.both_sides = keys_.own && sizes;
	keys.own = drag.handle().own || (keys_.own && !sizes);
	return keys;
}

void PointerController::drag()
{
	const glm::dvec2 pixel = inScene();
	if (const auto* drag = std::get_if<interact::Drag>(&grip_))
		return bench_.setProbe(std::string(interact::wordsOf(drag->handle())), drag->to(pixel, keysFor(*drag)),
		                       kDragKey);
	if (const auto* lens = std::get_if<LensGrip>(&grip_))
	{
		const probe::Probe placed = probe::placed(lens->start);
		if (const auto hit = interact::hitOf(placed.sheets[lens->sheet], lens->sheet, lens->view, pixel))
			bench_.setProbe("Move what the magnifier shows",
			                interact::magnifierPanned(lens->start, lens->sheet, lens->from, hit->uv), kDragKey);
		return;
	}
	const auto& camera = std::get<CameraGrip>(grip_);
	const auto& extent = bench_.facts()->extent;
	if (camera.pans || keys_.fine)
		bench_.setCamera("Move the view", interact::panned(camera.start, camera.from, pixel, extent, camera.pivot),
		                 kDragKey);
	else
		bench_.setCamera("Turn the view", interact::turned(camera.start, camera.from, pixel, extent), kDragKey);
}

void PointerController::wheel(double amount, bool within)
{
	const auto view = bench_.view();
	if (isBusy() || !within || !view || !part_.holds(at_) || amount == 0.0)
		return;
	look();
	const probe::Probe probe = bench_.probe();
	if (!sheet_ || keys_.snap)
	{
		const std::optional<Vec3> point = sheet_ ? std::optional(sheet_->point) : std::nullopt;
		return bench_.setCamera(
		    "Zoom", interact::zoomed(*view, inScene(), std::pow(kZoomFactor, amount), bench_.facts()->extent, point),
		    kWheelKey);
	}
	bench_.chooseSheet(sheet_->sheet);
	if (bench_.parts.magnifier)
		return bench_.setProbe(
		    "Magnify", interact::magnified(probe, sheet_->sheet, std::pow(kZoomFactor, amount), sheet_->uv), kWheelKey);
	bench_.setProbe("Push the sheet",
	                interact::pushed(probe, sheet_->sheet, amount, bench_.facts()->bounds, keys_.fine,
	                                 keys_.own || bench_.parts.own),
	                kWheelKey);
}

} // namespace vp::app
