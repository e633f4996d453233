#include "viewer/document.h"

#include "report/console.h"
#include "view/resolve.h"
#include "viewer/mail.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

constexpr std::chrono::seconds kNoticeStays{6};
constexpr std::chrono::seconds kErrorStays{15};

} // namespace

Document::Document(view::ViewSpec state, std::shared_ptr<gpu::Device> device, std::function<void()> wake,
                   ReadState read_state)
    : settings(readSettings()), history_(state), read_state_(std::move(read_state)), recovery_file_(recoveryFile()),
      mail_(std::make_shared<Mail>()), messages_(
                                           [mail = mail_](Severity severity, std::string_view line)
                                           {
	                                           if (severity == Severity::warning)
		                                           mail->leave({std::string(line), false, {}});
	                                           else
		                                           printLine(line);
                                           }),
      wake_(wake), loader_(device, wake), artist_(device, wake)
{
	if (!leftRecoveryFiles().empty())
		question = Question::recover;
	if (!state.input.files.empty())
		load(std::move(state));
}

Document::~Document()
{
	for (std::future<Notice>& task : written_)
		task.wait();
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
	std::shared_ptr<const PresentedFrame> newest = artist_.shown();
	if (std::optional<Error> error = artist_.takeError())
		notify(*error);
	if (newest == shown_)
		return;
	shown_ = std::move(newest);
	if (!takes_camera_ || shown_->wish.number != version_)
		return;
	// From now on the camera stands where it was fitted; undoing what came before does not bring the fitting back.
	takes_camera_ = false;
	view::ViewSpec fixed = state();
	fixed.look.camera = render::fixedCamera(shown_->camera);
	history_.amend(std::move(fixed));
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
	forgetOldNotices();
	watchFiles();
	keepForRecovery();
	playSweep();
	orderFrames();
	if (facts_ && size.width > 0 && size.height > 0)
		ask(size);
	input_.reset();
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
	FrameRequest next = wish();
	next.pane = pane_;
	artist_.ask(std::move(next));
}

// What the state is to look like, in the size that was last asked for.
FrameRequest Document::wish() const
{
	FrameRequest wish{version_, state(), input_.value_or(std::chrono::steady_clock::now())};
	wish.spec.look.size = {asked_size_.width, asked_size_.height};
	wish.contour = pointed_contour_;
	return wish;
}

bool Document::isIdle() const
{
	// A picture that cannot be made leaves the one before it.
	return !loader_.isBusy() && !isPlaying() && !recording_ && written_.empty() &&
	       (!facts_ || (asked_ == version_ && artist_.isIdle() && shown_ == artist_.shown()));
}

bool Document::isShown() const
{
	return shown_ && asked_ == version_ && shown_->wish.number == asked_;
}

void Document::notify(std::string words, bool is_error)
{
	dismiss(words);
	notices_.push_back({withOptionNames(words), is_error, std::chrono::steady_clock::now()});
}

void Document::dismiss(const std::string& words)
{
	std::erase_if(notices_, [&](const Notice& notice) { return notice.words == words; });
}

void Document::forgetOldNotices()
{
	const Moment now = std::chrono::steady_clock::now();
	std::erase_if(notices_, [&](const Notice& notice)
	              { return now - notice.since > (notice.is_error ? kErrorStays : kNoticeStays); });
}

} // namespace vp::app
