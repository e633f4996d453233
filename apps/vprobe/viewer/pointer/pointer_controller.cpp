#include "viewer/pointer/pointer_controller.h"

#include "interact/camera_moves.h"
#include "interact/nudge.h"

#include <cmath>
#include <utility>

namespace vp::app
{

namespace
{

constexpr double kZoomFactor = 1.15; // zoom per notch of the wheel
constexpr const char* kDragKey = "drag";
constexpr const char* kWheelKey = "wheel";

} // namespace

std::vector<interact::HandleShape> PointerController::shapes() const
{
	const auto view = document_.view();
	if (!view || !document_.facts() || !document_.parts.handles)
		return {};
	interact::HandleOptions options{.ui_scale = ui_scale_};
	if (document_.parts.own)
		options.own = document_.sheet();
	return interact::handlesOf(document_.shown()->probe, *view, document_.facts()->bounds, options);
}

// Returns the nearest sheet under the pixel.
std::optional<interact::SheetHit> PointerController::sheetAt(const glm::dvec2& pixel) const
{
	const auto view = document_.view();
	if (!view || !document_.facts())
		return std::nullopt;
	for (const interact::SheetHit& hit :
	     interact::pickSheets(document_.shown()->probe, *view, pixel, document_.facts()->bounds))
		return hit;
	return std::nullopt;
}

void PointerController::look()
{
	handle_.reset();
	sheet_.reset();
	const auto view = document_.view();
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
	const auto view = document_.view();
	if (isBusy() || !within || !view || !part_.holds(at_))
		return;
	look();
	held_ = button;
	document_.endMerge();
	const Vec3 pivot = sheet_ ? sheet_->point : view->camera.focal_point;
	if (button == Button::left && handle_)
		grip_.emplace<interact::Drag>(*handle_, inScene(), *view, document_.probe(), document_.facts()->bounds,
		                              ui_scale_);
	else if (button == Button::left && sheet_)
		takeSheet();
	else
		grip_ = CameraGrip{*view, inScene(), button == Button::middle, pivot};
}

void PointerController::takeSheet()
{
	document_.chooseSheet(sheet_->sheet);
	if (document_.parts.magnifier)
		grip_ = LensGrip{document_.probe(), *document_.view(), sheet_->sheet, sheet_->uv};
	else
		grip_.emplace<interact::Drag>(
		    interact::Handle{interact::HandleKind::sheet, 2, sheet_->sheet, 0, document_.parts.own}, inScene(),
		    *document_.view(), document_.probe(), document_.facts()->bounds, ui_scale_);
}

void PointerController::release(Button button)
{
	if (held_ != button)
		return;
	held_.reset();
	if (std::exchange(has_dragged_, false))
		noteLearned();
	grip_ = std::monostate();
	document_.endMerge();
	look();
}

// Alt moves one sheet alone. On a window's edge or corner, Alt moves the opposite side too.
interact::Modifiers PointerController::keysFor(const interact::Drag& drag) const
{
	interact::Modifiers keys = keys_;
	const interact::HandleKind kind = drag.handle().kind;
	const bool sizes = kind == interact::HandleKind::edge || kind == interact::HandleKind::corner;
	keys.both_sides = keys_.own && sizes;
	keys.own = drag.handle().own || (keys_.own && !sizes);
	return keys;
}

// The hints for the first steps go on once a step was done.
void PointerController::noteLearned()
{
	const auto* drag = std::get_if<interact::Drag>(&grip_);
	if (std::holds_alternative<CameraGrip>(grip_))
		document_.learned(kHintOfCamera);
	else if (drag)
		document_.learned(drag->handle().kind == interact::HandleKind::sheet ? kHintOfSheet : kHintOfHandles);
}

void PointerController::drag()
{
	has_dragged_ = true;
	const glm::dvec2 pixel = inScene();
	if (const auto* drag = std::get_if<interact::Drag>(&grip_))
		return document_.setProbe(std::string(interact::wordsOf(drag->handle())), drag->to(pixel, keysFor(*drag)),
		                          kDragKey);
	if (const auto* lens = std::get_if<LensGrip>(&grip_))
	{
		const probe::Probe placed = probe::placed(lens->start);
		if (const auto hit = interact::hitOf(placed.sheets[lens->sheet], lens->sheet, lens->view, pixel))
			document_.setProbe("Move what the magnifier shows",
			                   interact::magnifierPanned(lens->start, lens->sheet, lens->from, hit->uv), kDragKey);
		return;
	}
	const auto& camera = std::get<CameraGrip>(grip_);
	const auto& extent = document_.facts()->extent;
	if (camera.pans || keys_.fine)
		document_.setCamera("Move the view", interact::panned(camera.start, camera.from, pixel, extent, camera.pivot),
		                    kDragKey);
	else
		document_.setCamera("Turn the view", interact::turned(camera.start, camera.from, pixel, extent), kDragKey);
}

void PointerController::wheel(double amount, bool within)
{
	const auto view = document_.view();
	if (isBusy() || !within || !view || !part_.holds(at_) || amount == 0.0)
		return;
	look();
	const probe::Probe probe = document_.probe();
	if (!sheet_ || keys_.snap)
	{
		const std::optional<Vec3> point = sheet_ ? std::optional(sheet_->point) : std::nullopt;
		return document_.setCamera(
		    "Zoom", interact::zoomed(*view, inScene(), std::pow(kZoomFactor, amount), document_.facts()->extent, point),
		    kWheelKey);
	}
	document_.chooseSheet(sheet_->sheet);
	if (document_.parts.magnifier)
		return document_.setProbe(
		    "Magnify", interact::magnified(probe, sheet_->sheet, std::pow(kZoomFactor, amount), sheet_->uv), kWheelKey);
	document_.setProbe("Push the sheet",
	                   interact::pushed(probe, sheet_->sheet, amount, document_.facts()->bounds, keys_.fine,
	                                    keys_.own || document_.parts.own),
	                   kWheelKey);
}

} // namespace vp::app
