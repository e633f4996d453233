#include "viewer/document/playback.h"

#include "sweep/frames.h"
#include "viewer/document/document.h"
#include "write/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr const char* kSweepKey = "sweep";
constexpr double kSpeedFactor = 1.25;
// Number of frames that the render thread holds: it draws one, and one waits.
constexpr int kOrdered = 2;

bool sameButPlace(const PictureRequest& a, const PictureRequest& b)
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

// Holds messages from the render thread. It outlives the playback if that thread is slower.
struct Playback::Mail
{
	std::mutex mutex;
	std::optional<Error> failed;
	std::shared_ptr<Exposure> exposure;

	// Takes a recorded frame. Only the render thread adds to the exposure.
	void leave(Result<render::Picture> picture, int frame, FilmLoop& film)
	{
		std::shared_ptr<Exposure> exposed;
		{
			const std::lock_guard lock(mutex);
			if (!picture)
				failed = picture.error();
			exposed = exposure;
		}
		if (picture && exposed)
			exposed->add(*picture);
		if (picture)
			film.put(frame, std::move(*picture));
	}
};

Playback::Playback(Document& document, RenderThread& render_thread, FileJobs& jobs, std::function<void()> wake)
    : document_(document), render_thread_(render_thread), jobs_(jobs), wake_(std::move(wake)),
      mail_(std::make_shared<Mail>())
{
}

void Playback::update()
{
	play();
	orderFrames();
}

void Playback::forgetFilm()
{
	film_.reset();
	recording_.reset();
}

double Playback::seconds() const
{
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Status Playback::followSweep()
{
	if (!document_.facts())
		return Error{ErrorKind::usage, "nothing is shown yet; open a file first"};
	return path_.follow(document_.state(), *document_.facts(), seconds());
}

// Returns false, with a notice, if the probe cannot follow the path.
bool Playback::canSweep()
{
	const Status followed = followSweep();
	if (!followed)
	{
		path_.player.pause(seconds());
		document_.notify(followed.error());
	}
	return bool(followed);
}

// Moves the state to the current frame. If a film loop is shown instead, nothing is cut.
void Playback::play()
{
	if (!isPlaying())
	{
		// This finds the number of frames. An error in the path is reported when the sweep is played.
		[[maybe_unused]] const Status followed = followSweep();
		return;
	}
	if (!canSweep() || filmIsGood())
		return;
	const int frame = this->frame();
	document_.change(
	    "Sweep", [&](view::ViewSpec& next) { next = path_.at(frame, next); }, kSweepKey);
}

void Playback::seek(int frame)
{
	if (!canSweep())
		return;
	path_.player.seek(frame, seconds());
	document_.change(
	    "Sweep", [&](view::ViewSpec& next) { next = path_.at(this->frame(), next); }, kSweepKey);
}

bool Playback::perform(Action action)
{
	const double now = seconds();
	switch (action)
	{
	case Action::play:
		if (!canSweep())
			return true;
		path_.player.toggle(now);
		if (!isPlaying())
			seek(frame());
		return true;
	case Action::faster:
		return setSpeed(kSpeedFactor), true;
	case Action::slower:
		return setSpeed(1.0 / kSpeedFactor), true;
	case Action::there_and_back:
		document_.change("There and back",
		                 [](view::ViewSpec& next) { next.sweep.there_and_back = !next.sweep.there_and_back; });
		return true;
	case Action::loop:
		path_.player.setLoops(!path_.player.loops(), now);
		document_.notify(path_.player.loops() ? "The sweep begins again at its end" : "The sweep stops at its end");
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
		return cancelRecording(), true;
	default:
		return false;
	}
}

void Playback::setSpeed(double factor)
{
	const double speed =
	    std::clamp(view::framesPerSecond(document_.state().sweep) * factor, interact::kMinSpeed, interact::kMaxSpeed);
	document_.change(
	    "Speed", [&](view::ViewSpec& next) { next.sweep.frames_per_second = speed; }, "speed");
	path_.player.setSpeed(speed, seconds());
	document_.notify(fmt::format("{:.3g} frames a second", speed));
}

void Playback::cancelRecording()
{
	if (recording_)
		document_.notify("Recording was cancelled");
	recording_.reset();
}

void Playback::record()
{
	if (recording_)
		return cancelRecording();
	if (!canSweep())
		return;
	const PictureRequest like = document_.pictureRequest();
	const auto [width, height] = like.spec.look.size;
	const std::size_t bytes = FilmLoop::bytesOf(frames(), width, height);
	if (bytes > FilmLoop::kMaxBytes)
		return document_.notify(
		    fmt::format("{} frames of {}x{} take {} MiB, and a film loop holds {}: make them fewer, or the window "
		                "smaller",
		                frames(), width, height, bytes >> 20, FilmLoop::kMaxBytes >> 20),
		    true);
	path_.player.pause(seconds());
	film_.reset();
	exposure_.reset();
	recording_ = Recording{std::make_shared<FilmLoop>(frames()), 0, like};
	mail_->failed.reset();
	mail_->exposure.reset();
	render_thread_.order(PictureJob{recording_->like, true,
	                                [mail = mail_](Result<render::Picture> empty)
	                                {
		                                const std::lock_guard lock(mail->mutex);
		                                if (empty)
			                                mail->exposure = std::make_shared<Exposure>(std::move(*empty));
	                                }});
}

void Playback::orderFrames()
{
	if (!recording_)
		return;
	{
		const std::lock_guard lock(mail_->mutex);
		if (mail_->failed)
		{
			document_.notify(*mail_->failed);
			recording_.reset();
			return;
		}
	}
	const std::shared_ptr<FilmLoop>& film = recording_->film;
	while (recording_->ordered < film->frames() && recording_->ordered - film->recorded() < kOrdered)
	{
		const int frame = recording_->ordered++;
		PictureRequest wish = recording_->like;
		const view::ViewSpec posed = path_.at(frame, document_.state());
		wish.spec.probe = posed.probe;
		wish.spec.input.time = posed.input.time;
		render_thread_.order(PictureJob{wish, false,
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
	document_.notify(fmt::format("Film loop of {} frames, {} MiB", film_->frames(),
	                             FilmLoop::bytesOf(film_->frames(), size->width, size->height) >> 20));
}

// Returns true if the film loop shows what the sweep would show.
bool Playback::filmIsGood() const
{
	if (!film_ || film_->frames() != frames())
		return false;
	return sameButPlace(document_.pictureRequest(), film_like_);
}

std::shared_ptr<const render::Picture> Playback::filmPicture() const
{
	if (!filmIsGood())
		return nullptr;
	if (document_.parts.exposure && exposure_)
		return exposure_;
	return isPlaying() ? film_->picture(frame()) : nullptr;
}

void Playback::saveFilm(const std::string& file)
{
	if (!film_)
		return document_.notify("Record the sweep first: what is saved is its film loop", true);
	document_.notify(fmt::format("Writing {}", file));
	jobs_.run(file,
	          [film = film_, file, per_second = view::filmSpeed(document_.state().sweep, film_->frames())]
	          {
		          const Status written = writeFilm(*film, file, per_second);
		          return noticeOf(written, fmt::format("Saved {}", file));
	          });
}

void Playback::saveExposure(const std::string& file)
{
	if (!exposure_)
		return document_.notify("Record the sweep first: an exposure is made of its frames", true);
	jobs_.run(file,
	          [picture = exposure_, file]
	          {
		          const Status written = write::writePng(*picture, file);
		          return noticeOf(written, fmt::format("Saved {}", file));
	          });
}

} // namespace vp::app
