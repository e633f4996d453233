#include "view/workbench.h"

#include "make_probe.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

constexpr std::chrono::seconds kNoticeStays{6};
constexpr std::chrono::seconds kErrorStays{15};

} // namespace

Workbench::Workbench(ViewState state, std::shared_ptr<gpu::Device> device, std::function<void()> wake)
    : history_(std::move(state)), loader_(device, wake), artist_(device, wake)
{
	if (!history_.state().probe.inputs.empty())
		loader_.begin(history_.state().probe);
}

void Workbench::change(const std::string& label, const Edit& edit, const std::string& merge)
{
	ViewState next = state();
	edit(next);
	if (history_.commit(std::move(next), label, merge))
		stateChanged();
}

void Workbench::stateChanged()
{
	++version_;
	takes_camera_ = takes_camera_ || !cameraOf(state().look);
}

probe::Probe Workbench::probe() const
{
	if (!facts_)
		return {};
	Result<probe::Probe> made = makeProbe(state().probe, facts_->bounds);
	return made ? *made : probe::Probe{};
}

void Workbench::setProbe(const std::string& label, const probe::Probe& probe, const std::string& merge)
{
	const probe::Probe before = this->probe();
	change(
	    label, [&](ViewState& state) { placeProbe(state.probe, before, probe); }, merge);
}

void Workbench::chooseSheet(std::size_t sheet)
{
	const std::size_t count = probe().sheets.size();
	sheet_ = count == 0 ? 0 : sheet % count;
}

void Workbench::setCamera(const std::string& label, const render::Camera& camera, const std::string& merge)
{
	change(
	    label, [&](ViewState& state) { app::setCamera(state.look, camera); }, merge);
}

std::optional<interact::View> Workbench::view() const
{
	if (!shown_)
		return std::nullopt;
	return interact::View{shown_->camera, shown_->frame};
}

void Workbench::open(std::vector<std::string> inputs)
{
	ProbeOptions options = state().probe;
	options.inputs = std::move(inputs);
	// What belongs to other data goes: places, arrays, times. How it is looked at stays.
	ProbeOptions fresh;
	fresh.inputs = options.inputs;
	fresh.classify = options.classify;
	fresh.classify_given = options.classify_given;
	fresh.threads = options.threads;
	loader_.begin(std::move(fresh));
}

void Workbench::reload()
{
	if (facts_)
		loader_.begin(state().probe);
}

void Workbench::cancelLoading()
{
	loader_.cancel();
	notify("Loading was cancelled");
}

void Workbench::takeLoaded()
{
	std::optional<Loader::Loaded> loaded = loader_.take();
	if (!loaded)
		return;
	if (!loaded->session)
		return notify(loaded->session.error());
	std::unique_ptr<Session> session = std::move(*loaded->session);
	const bool same = facts_ && facts_->inputs == loaded->options.inputs;
	facts_ = factsOf(*session, loaded->options.inputs);
	if (!same && !(state().probe == loaded->options))
	{
		ViewState fresh = state();
		fresh.probe = loaded->options;
		fresh.look.camera = "auto";
		fresh.look.range.clear();
		fresh.look.title.reset();
		history_ = interact::History<ViewState>(std::move(fresh));
	}
	takes_camera_ = takes_camera_ || !cameraOf(state().look);
	++version_;
	artist_.replaceSession(std::move(session));
}

void Workbench::takePicture()
{
	std::shared_ptr<const Shown> newest = artist_.shown();
	if (std::optional<Error> error = artist_.takeError())
		notify(*error);
	if (newest == shown_)
		return;
	shown_ = std::move(newest);
	if (!takes_camera_ || shown_->wish.number != version_)
		return;
	// From now on the camera stands where it was fitted; undoing what came before does not bring the fitting back.
	takes_camera_ = false;
	ViewState fixed = state();
	app::setCamera(fixed.look, shown_->camera);
	history_.amend(std::move(fixed));
}

void Workbench::noteInput(Moment when)
{
	if (!input_)
		input_ = when;
}

void Workbench::update(VkExtent2D size)
{
	takeLoaded();
	takePicture();
	forgetOldNotices();
	if (facts_ && size.width > 0 && size.height > 0)
		ask(size);
	input_.reset();
}

void Workbench::ask(VkExtent2D size)
{
	const bool same_size = size.width == asked_size_.width && size.height == asked_size_.height;
	if (asked_ == version_ && same_size)
		return;
	if (!same_size)
		++version_;
	asked_ = version_;
	asked_size_ = size;
	Wish wish{version_, state().probe, state().look, input_.value_or(std::chrono::steady_clock::now())};
	wish.look.size = fmt::format("{}x{}", size.width, size.height);
	artist_.ask(std::move(wish));
}

bool Workbench::isIdle() const
{
	// A picture that cannot be made leaves the one before it.
	return !loader_.isBusy() && (!facts_ || (asked_ == version_ && artist_.isIdle() && shown_ == artist_.shown()));
}

void Workbench::notify(std::string words, bool is_error)
{
	const Moment now = std::chrono::steady_clock::now();
	std::erase_if(notices_, [&](const Notice& notice) { return notice.words == words; });
	notices_.push_back({std::move(words), is_error, now});
}

void Workbench::forgetOldNotices()
{
	const Moment now = std::chrono::steady_clock::now();
	std::erase_if(notices_, [&](const Notice& notice)
	              { return now - notice.since > (notice.is_error ? kErrorStays : kNoticeStays); });
}

} // namespace vp::app
