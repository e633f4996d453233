#include "report/frames.h"
#include "viewer/document.h"
#include "viewer/mail.h"
#include "write/png.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr const char* kSweepKey = "sweep";
constexpr double kSpeedFactor = 1.25;
// Frames that the render thread has in hand: one drawn, one waiting.
constexpr int kOrdered = 2;

bool sameButPlace(const FrameRequest& a, const FrameRequest& b)
{
	view::ViewSpec placed = a.spec;
	takePlace(placed.probe, b.spec.probe);
	placed.input.time = b.spec.input.time;
	return placed.probe == b.spec.probe && placed.input == b.spec.input && placed.look == b.spec.look;
}

Status writeFilm(const FilmLoop& film, const std::string& file, double per_second)
{
	const render::Picture& first = *film.picture(0);
	FramePlaces places;
	(write::isFilm(file) ? places.film : places.pictures) = file;
	Result<Frames> frames = Frames::create(places, first.width, first.height, per_second);
	if (!frames)
		return frames.error();
	for (int k = 0; k < film.frames(); ++k)
		if (Status added = frames->add(k, *film.picture(k)); !added)
			return added;
	return frames->commit();
}

} // namespace

double Document::seconds() const
{
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Status Document::followSweep()
{
	if (!facts_)
		return Error{ErrorKind::usage, "nothing is shown yet; open a file first"};
	return sweep_.follow(state(), *facts_, seconds());
}

// False, with a notice, where the path cannot be gone.
bool Document::canSweep()
{
	const Status followed = followSweep();
	if (!followed)
	{
		sweep_.player.pause(seconds());
		notify(followed.error());
	}
	return bool(followed);
}

// The frame of this moment becomes the state's; a film loop is shown without cutting.
void Document::playSweep()
{
	if (!isPlaying())
	{
		// So that it is known how many frames there are; what is wrong with the path is told when it is played.
		[[maybe_unused]] const Status followed = followSweep();
		return;
	}
	if (!canSweep() || filmIsGood())
		return;
	const int frame = this->frame();
	change(
	    "Sweep", [&](view::ViewSpec& next) { next = sweep_.at(frame, next); }, kSweepKey);
}

void Document::seek(int frame)
{
	if (!canSweep())
		return;
	sweep_.player.seek(frame, seconds());
	change(
	    "Sweep", [&](view::ViewSpec& next) { next = sweep_.at(this->frame(), next); }, kSweepKey);
}

bool Document::performOnSweep(Action action)
{
	const double now = seconds();
	switch (action)
	{
	case Action::play:
		if (!canSweep())
			return true;
		sweep_.player.toggle(now);
		if (!isPlaying())
			seek(frame());
		return true;
	case Action::faster:
		return setSpeed(kSpeedFactor), true;
	case Action::slower:
		return setSpeed(1.0 / kSpeedFactor), true;
	case Action::there_and_back:
		change("There and back", [](view::ViewSpec& next) { next.sweep.there_and_back = !next.sweep.there_and_back; });
		return true;
	case Action::loop:
		sweep_.player.setLoops(!sweep_.player.loops(), now);
		notify(sweep_.player.loops() ? "The sweep begins again at its end" : "The sweep stops at its end");
		return true;
	case Action::next_frame:
		return seek(frame() + 1), true;
	case Action::previous_frame:
		return seek(frame() - 1), true;
	case Action::first_frame:
		return seek(0), true;
	case Action::last_frame:
		return seek(frames() - 1), true;
	case Action::record:
		return record(), true;
	case Action::cancel:
		if (recording_)
			notify("Recording was cancelled");
		recording_.reset();
		return true;
	default:
		return false;
	}
}

void Document::setSpeed(double factor)
{
	const double speed = std::clamp(state().sweep.frames_per_second * factor, interact::kMinSpeed, interact::kMaxSpeed);
	change(
	    "Speed", [&](view::ViewSpec& next) { next.sweep.frames_per_second = speed; }, "speed");
	sweep_.player.setSpeed(speed, seconds());
	notify(fmt::format("{:.3g} frames a second", speed));
}

void Document::record()
{
	if (recording_)
		return perform(Action::cancel), void();
	if (!canSweep())
		return;
	const std::size_t bytes = FilmLoop::bytesOf(frames(), asked_size_.width, asked_size_.height);
	if (bytes > FilmLoop::kMaxBytes)
		return notify(
		    fmt::format("{} frames of {}x{} take {} MiB, and a film loop holds {}: make them fewer, or the window "
		                "smaller",
		                frames(), asked_size_.width, asked_size_.height, bytes >> 20, FilmLoop::kMaxBytes >> 20),
		    true);
	sweep_.player.pause(seconds());
	film_.reset();
	exposure_.reset();
	recording_ = Recording{std::make_shared<FilmLoop>(frames()), 0, wish()};
	mail_->frame_failed.reset();
	mail_->exposure.reset();
	artist_.order(PictureJob{recording_->like, true,
	                         [mail = mail_](Result<render::Picture> empty)
	                         {
		                         const std::lock_guard lock(mail->mutex);
		                         if (empty)
			                         mail->exposure = std::make_shared<Exposure>(std::move(*empty));
	                         }});
}

void Document::orderFrames()
{
	if (!recording_)
		return;
	{
		const std::lock_guard lock(mail_->mutex);
		if (mail_->frame_failed)
		{
			notify(*mail_->frame_failed);
			recording_.reset();
			return;
		}
	}
	const std::shared_ptr<FilmLoop>& film = recording_->film;
	while (recording_->ordered < film->frames() && recording_->ordered - film->recorded() < kOrdered)
	{
		const int frame = recording_->ordered++;
		FrameRequest wish = recording_->like;
		const view::ViewSpec posed = sweep_.at(frame, state());
		wish.spec.probe = posed.probe;
		wish.spec.input.time = posed.input.time;
		artist_.order(PictureJob{wish, false,
		                         [mail = mail_, film, frame, wake = wake_](Result<render::Picture> picture)
		                         {
			                         mail->leave(std::move(picture), frame, *film);
			                         wake();
		                         }});
	}
	if (!film->isWhole())
		return;
	film_ = film;
	film_like_ = recording_->like;
	const std::lock_guard lock(mail_->mutex);
	if (mail_->exposure)
		exposure_ = std::make_shared<const render::Picture>(mail_->exposure->picture());
	recording_.reset();
	const auto size = film_->picture(0);
	notify(fmt::format("Film loop of {} frames, {} MiB", film_->frames(),
	                   FilmLoop::bytesOf(film_->frames(), size->width, size->height) >> 20));
}

// Whether the film loop shows what the sweep would.
bool Document::filmIsGood() const
{
	if (!film_ || film_->frames() != frames())
		return false;
	return sameButPlace(wish(), film_like_);
}

std::shared_ptr<const render::Picture> Document::filmPicture() const
{
	if (!filmIsGood())
		return nullptr;
	if (parts.exposure && exposure_)
		return exposure_;
	return isPlaying() ? film_->picture(frame()) : nullptr;
}

void Document::saveFilm(const std::string& file)
{
	if (!film_)
		return notify("Record the sweep first: what is saved is its film loop", true);
	notify(fmt::format("Writing {}", file));
	writeBeside(
	    [film = film_, file, per_second = state().sweep.frames_per_second]
	    {
		    const Status written = writeFilm(*film, file, per_second);
		    return written ? Notice{fmt::format("Saved {}", file), false, {}}
		                   : Notice{written.error().message, true, {}};
	    });
}

void Document::saveExposure(const std::string& file)
{
	if (!exposure_)
		return notify("Record the sweep first: an exposure is made of its frames", true);
	writeBeside(
	    [picture = exposure_, file]
	    {
		    const Status written = write::writePng(*picture, file);
		    return written ? Notice{fmt::format("Saved {}", file), false, {}}
		                   : Notice{written.error().message, true, {}};
	    });
}

} // namespace vp::app
