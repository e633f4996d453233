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
	if (grid::hasNeighbors(at_->session->blocks()))
		return Nothing{};
	if (needed)
		neighbors_.begin(at_->session->blocks());
	Result<std::optional<grid::BlockSet>> built = neighbors_.take(needed);
	if (!built)
		return built.error();
	if (!*built)
		return Nothing{};
	at_->cut.reset(); // cells have other numbers now
	at_->grown = {};
	return at_->session->takeNeighbors(
	    std::move(**built)); // the time may have changed meanwhile, and the values with it
}

Status RenderThread::follow(const PictureRequest& wish)
{
	Status done = takeNeighbors(session::needsNeighbors(wish.spec, at_->session->blocks()) || wish.contour);
	if (done)
		done = followAll(wish);
	if (!done)
		at_->followed.reset(); // some of it may have been done
	return done;
}

// Session and painter, as the wish has them. What has not changed is left as it is.
Status RenderThread::followAll(const PictureRequest& wish)
{
	if (!at_->followed || !(at_->followed->spec.input.time == wish.spec.input.time))
		if (Status moved = followTime(wish.spec.input.time); !moved)
			return moved;
	if (Status set = at_->session->set(wish.spec); !set)
		return set;
	if (!at_->painter || !at_->followed || !(at_->followed->spec.look == wish.spec.look) ||
	    !haveSameRims(at_->followed->spec.probe, wish.spec.probe))
		if (Status looked = followLook(wish); !looked)
			return looked;
	at_->followed = wish;
	return Nothing{};
}

Status RenderThread::followTime(const read::TimeChoice& time)
{
	if (!at_->followed)
		return Nothing{}; // the session was opened at this time
	const std::uint64_t grid = at_->session->stamp().grid;
	if (Status moved = at_->session->goTo(time); !moved)
		return moved;
	if (at_->session->stamp().grid != grid)
		neighbors_.drop();
	return Nothing{};
}

Status RenderThread::followLook(const PictureRequest& wish)
{
	Result<view::ResolvedLook> look = view::resolveLook(wish.spec);
	if (!look)
		return look.error();
	if (at_->painter)
		return at_->painter->setLook(std::move(*look));
	Result<picture::Painter> painter = picture::Painter::create(*at_->session, std::move(*look));
	if (!painter)
		return painter.error();
	at_->painter.emplace(std::move(*painter));
	return Nothing{};
}

// What can have no contours, such as arrays of cells, has none.
Status RenderThread::growAsWished(const PictureRequest& wish)
{
	view::ContourSpec options = wish.spec.look.contour;
	options.opacity = 1.0; // a matter of drawing
	if (at_->grown.cut == at_->cut && at_->grown.options == options && at_->grown.pointed == wish.contour)
		return Nothing{};
	Result<session::Contours> contours = session::growContours(*at_->session, at_->cut->slice, at_->cut->sheets,
	                                                           options, session::Tell::nothing, wish.contour);
	if (!contours)
		return contours.error();
	at_->grown = {at_->cut, options, wish.contour, std::move(*contours)};
	return Nothing{};
}

Result<double> RenderThread::cutAsWished(std::stop_token stop)
{
	session::FrameRequest request{
	    .wants = {.figures = session::Wants::Figures::for_picture, .contours = false, .warns = false},
	    .last = at_->cut};
	request.expect =
	    grid::hasNeighbors(at_->session->blocks()) ? session::Expect::more : session::Expect::first_of_many;
	if (const Result<bool> needed = at_->session->needsNeighborsFor(request); needed && *needed)
		if (Status taken = takeNeighbors(true); !taken)
			return taken.error();
	const Moment start = std::chrono::steady_clock::now();
	Result<std::shared_ptr<const session::Frame>> made = at_->session->frame(request, std::move(stop));
	if (!made)
		return made.error();
	at_->cut_for = at_->followed;
	if (*made == at_->cut)
		return 0.0;
	at_->cut = std::move(*made);
	++cuts_;
	return millisecondsSince(start);
}

} // namespace vp::app
