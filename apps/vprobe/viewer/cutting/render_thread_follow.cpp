#include "session/time_steps.h"
#include "viewer/cutting/render_thread.h"
#include "viewer/cutting/spec_edits.h"

#include <utility>

namespace vp::app
{

namespace
{

// The painter draws lines around windows by these.
bool haveSameRims(const view::ProbeSpec& a, const view::ProbeSpec& b)
{
	return a.shape == b.shape && a.window == b.window;
}

} // namespace

Status RenderThread::takeNeighbors(bool needed)
{
	if (grid::hasNeighbors(session_->blocks()))
		return Nothing{};
	if (needed)
		neighbors_.begin(session_->blocks());
	Result<std::optional<grid::BlockSet>> built = neighbors_.take(needed);
	if (!built)
		return built.error();
	if (!*built)
		return Nothing{};
	cut_.reset(); // cells have other numbers now
	grown_ = {};
	return session_->takeNeighbors(std::move(**built)); // the time may have changed meanwhile, and the values with it
}

Status RenderThread::follow(const PictureRequest& wish)
{
	Status done = takeNeighbors(session::needsNeighbors(wish.spec) || wish.contour);
	if (done)
		done = followAll(wish);
	if (!done)
		followed_.reset(); // some of it may have been done
	return done;
}

// Session and painter, as the wish has them. What has not changed is left as it is.
Status RenderThread::followAll(const PictureRequest& wish)
{
	if (!followed_ || !(followed_->spec.input.time == wish.spec.input.time))
		if (Status moved = followTime(wish.spec.input.time); !moved)
			return moved;
	if (Status set = session_->set(wish.spec); !set)
		return set;
	if (!followed_ || !(followed_->spec.look == wish.spec.look) ||
	    !haveSameRims(followed_->spec.probe, wish.spec.probe))
		if (Status looked = followLook(wish); !looked)
			return looked;
	followed_ = wish;
	return Nothing{};
}

Status RenderThread::followTime(const read::TimeChoice& time)
{
	if (!followed_)
		return Nothing{}; // the session was opened at this time
	const std::uint64_t grid = session_->stamp().grid;
	if (Status moved = session_->goTo(time); !moved)
		return moved;
	if (session_->stamp().grid != grid)
		neighbors_.drop();
	return Nothing{};
}

Status RenderThread::followLook(const PictureRequest& wish)
{
	Result<view::ResolvedLook> look = view::resolveLook(wish.spec);
	if (!look)
		return look.error();
	if (painter_)
		return painter_->setLook(std::move(*look));
	Result<picture::Painter> painter = picture::Painter::create(*session_, std::move(*look));
	if (!painter)
		return painter.error();
	painter_.emplace(std::move(*painter));
	return Nothing{};
}

// What can have no contours, such as arrays of cells, has none.
Status RenderThread::growAsWished(const PictureRequest& wish)
{
	view::ContourSpec options = wish.spec.look.contour;
	options.opacity = 1.0; // a matter of drawing
	if (grown_.cut == cut_ && grown_.options == options && grown_.pointed == wish.contour)
		return Nothing{};
	Result<session::Contours> contours =
	    session::growContours(*session_, cut_->slice, cut_->sheets, options, session::Tell::nothing, wish.contour);
	if (!contours)
		return contours.error();
	grown_ = {cut_, options, wish.contour, std::move(*contours)};
	return Nothing{};
}

Result<double> RenderThread::cutAsWished()
{
	session::FrameRequest request{
	    .wants = {.figures = session::Wants::Figures::for_picture, .contours = false, .warns = false}, .last = cut_};
	request.expect = grid::hasNeighbors(session_->blocks()) ? session::Expect::more : session::Expect::first_of_many;
	if (const Result<bool> needed = session_->needsNeighborsFor(request); needed && *needed)
		if (Status taken = takeNeighbors(true); !taken)
			return taken.error();
	const Moment start = std::chrono::steady_clock::now();
	Result<std::shared_ptr<const session::Frame>> made = session_->frame(request);
	if (!made)
		return made.error();
	if (*made == cut_)
		return 0.0;
	cut_ = std::move(*made);
	++cuts_;
	return millisecondsSince(start);
}

} // namespace vp::app
