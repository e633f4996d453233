#include "viewer/document/document.h"

#include "interact/camera_moves.h"
#include "report/console.h"
#include "view/resolve.h"
#include "viewer/document/mail.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

Document::Document(interact::History<view::ViewSpec> history, std::shared_ptr<gpu::Device> device,
                   std::function<void()> wake, ReadState read_state, WindowTimes& times)
    : settings(readSettings()), history_(std::move(history)), read_state_(std::move(read_state)), times_(times),
      recovery_file_(recoveryFile()), mail_(std::make_shared<Mail>()),
      messages_(
          [mail = mail_](Severity severity, std::string_view line)
          {
	          if (severity != Severity::error)
		          mail->leave({std::string(line), false, {}});
	          else
		          printLine(line);
          }),
      loader_(device, wake, times.keep()), jobs_(wake), render_thread_(device, wake, times),
      playback_(*this, render_thread_, jobs_, wake)
{
	if (!leftRecoveryFiles().empty())
		question = Question::recover;
	if (!state().input.files.empty())
	{
		load(state());
		loads_own_data_ = true;
	}
}

Document::~Document()
{
	writeSettings(settings);
	std::error_code ignored;
	if (!keeps_state_)
		std::filesystem::remove(recovery_file_, ignored);
}

void Document::change(const std::string& label, const Edit& edit, const std::string& merge)
{
	view::ViewSpec next = state();
	edit(next);
	if (history_.commit(std::move(next), label, merge))
		stateChanged();
}

void Document::stateChanged()
{
	++version_;
	takes_camera_ = takes_camera_ || !cameraOf(state().look);
}

probe::Probe Document::probe() const
{
	if (!facts_)
		return {};
	Result<probe::Probe> made = makeProbe(state().probe, facts_->bounds);
	return made ? *made : probe::Probe{};
}

void Document::setProbe(const std::string& label, const probe::Probe& probe, const std::string& merge)
{
	const probe::Probe before = this->probe();
	change(
	    label, [&](view::ViewSpec& state) { placeProbe(state.probe, before, probe); }, merge);
}

void Document::chooseSheet(std::size_t sheet)
{
	const std::size_t count = probe().sheets.size();
	sheet_ = count == 0 ? 0 : sheet % count;
}

void Document::setCamera(const std::string& label, const render::Camera& camera, const std::string& merge)
{
	change(
	    label, [&](view::ViewSpec& state) { state.look.camera = render::fixedCamera(camera); }, merge);
}

std::optional<interact::View> Document::view() const
{
	if (!shown_)
		return std::nullopt;
	return interact::View{shown_->camera, shown_->frame};
}

void Document::takePicture()
{
	std::shared_ptr<const PresentedFrame> newest = render_thread_.shown();
	if (std::optional<Error> error = render_thread_.takeError())
	{
		if (error->kind == ErrorKind::device)
			lost_device_ = std::move(error);
		else
			notify(*error);
	}
	if (newest == shown_)
		return;
	shown_ = std::move(newest);
	if (!takes_camera_)
		return fitAgain();
	if (shown_->wish.number != version_)
		return;
	fitted_size_ = asked_size_;
	// From now on the camera stays where it was fitted. Undo does not bring the fitting back.
	takes_camera_ = false;
	const bool was_given = state().look.camera.kind == render::CameraChoice::Kind::fixed;
	view::ViewSpec fixed = state();
	fixed.look.camera = render::fixedCamera(shown_->camera);
	fitted_camera_ = was_given ? std::nullopt : std::optional(fixed.look.camera);
	history_.amend(std::move(fixed));
}

// A window of another size shows the whole scene again, unless the user has moved the camera.
void Document::fitAgain()
{
	const auto isSameSize = [](const PixelSize& a, const PixelSize& b)
	{ return a.width == b.width && a.height == b.height; };
	const VkExtent2D extent = shown_->image->extent();
	// A picture of fewer pixels may be shown for a moment, while something moves.
	if (!facts_ || isSameSize(asked_size_, fitted_size_) || !isSameSize({extent.width, extent.height}, asked_size_))
		return;
	fitted_size_ = asked_size_;
	if (!fitted_camera_ || *fitted_camera_ != state().look.camera)
		return;
	view::ViewSpec fitted = state();
	fitted.look.camera = render::fixedCamera(interact::fitted(*view(), facts_->extent));
	fitted_camera_ = fitted.look.camera;
	history_.amend(std::move(fitted));
	++version_;
}

void Document::noteInput(Moment when)
{
	if (!input_)
		input_ = when;
}

void Document::update(PixelSize size)
{
	takeLoaded();
	takePicture();
	takeWritten();
	notices_.forgetOld(std::chrono::steady_clock::now());
	watchFiles();
	keepForRecovery();
	playback_.update();
	if (facts_ && size.width > 0 && size.height > 0)
		ask(size);
	input_.reset();
}

void Document::quit()
{
	constexpr std::chrono::milliseconds kKeyRepeats{500}; // a key that is held down asks many times
	const Moment now = std::chrono::steady_clock::now();
	if (quits_ == 0)
		first_quit_ = now;
	if (quits_ == 0 || now - first_quit_ > kKeyRepeats)
		++quits_;
}

void Document::setPane(PixelSize size)
{
	const std::optional<PaneWish> next =
	    size.width > 0 && size.height > 0 ? std::optional(PaneWish{sheet_, size}) : std::nullopt;
	if (next == pane_)
		return;
	pane_ = next;
	++version_;
}

void Document::pointContour(const std::optional<session::PointedValue>& pointed)
{
	if (pointed == pointed_contour_)
		return;
	pointed_contour_ = pointed;
	++version_;
}

void Document::ask(PixelSize size)
{
	const bool same_size = size.width == asked_size_.width && size.height == asked_size_.height;
	if (asked_ == version_ && same_size)
		return;
	if (!same_size)
		++version_;
	asked_ = version_;
	asked_size_ = size;
	PictureRequest next = pictureRequest();
	next.pane = pane_;
	render_thread_.ask(std::move(next));
}

// Returns a request for a picture of the state, in the size that was last asked for.
PictureRequest Document::pictureRequest() const
{
	PictureRequest wish{version_, state(), input_.value_or(std::chrono::steady_clock::now())};
	wish.spec.look.size = {asked_size_.width, asked_size_.height};
	wish.contour = pointed_contour_;
	return wish;
}

bool Document::isIdle() const
{
	// If a picture cannot be made, the picture before it stays.
	return !loader_.isBusy() && !playback_.isPlaying() && !playback_.recording() && jobs_.isIdle() &&
	       (!facts_ || (asked_ == version_ && render_thread_.isIdle() && shown_ == render_thread_.shown()));
}

bool Document::isShown() const
{
	return shown_ && asked_ == version_ && shown_->wish.number == asked_;
}

} // namespace vp::app
