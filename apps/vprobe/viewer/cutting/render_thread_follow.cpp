#include "picture/time_steps.h"
#include "viewer/cutting/render_thread.h"
#include "viewer/cutting/spec_edits.h"

#include <utility>

namespace vp::app
{

namespace
{

// Whether two cuts differ in no more than where their probes are.
bool differInPlace(view::ViewSpec a, const view::ViewSpec& b)
{
	takePlace(a.probe, b.probe);
	return a.probe == b.probe && a.input == b.input;
}

// Whether all but the time of the input and the look is the same.
bool haveSameCut(const view::ViewSpec& a, const view::ViewSpec& b)
{
	view::InputSpec input = a.input;
	input.time = b.input.time;
	return input == b.input && a.probe == b.probe && a.machine == b.machine;
}

// The painter draws lines around windows by these.
bool haveSameRims(const view::ProbeSpec& a, const view::ProbeSpec& b)
{
	return a.shape == b.shape && a.window == b.window;
}

} // namespace

Status RenderThread::takeNeighbors(bool needed)
{
	if (grid::hasNeighbors(session_->blocks))
		return Nothing{};
	if (needed)
		neighbors_.begin(session_->blocks);
	Result<std::optional<grid::BlockSet>> built = neighbors_.take(needed);
	if (!built)
		return built.error();
	if (!*built)
		return Nothing{};
	// The time may have changed meanwhile, and the values with it.
	for (std::size_t b = 0; b < session_->blocks.blocks.size(); ++b)
		(*built)->blocks[b].fields = std::move(session_->blocks.blocks[b].fields);
	session_->cutter.reset();
	session_->blocks = std::move(**built);
	session_->another_follows = true;
	cut_.reset(); // cells have other numbers now
	grown_ = {};
	only_moved_ = false;
	if (Status made = session::makeCutter(*session_); !made)
		return made;
	return painter_ ? painter_->takeBlocks() : Nothing{};
}

Status RenderThread::follow(const FrameRequest& wish)
{
	Status done = takeNeighbors(session::needsNeighbors(wish.spec) || wish.contour);
	if (done)
		done = followAll(wish);
	if (!done)
		followed_.reset(); // some of it may have been done
	return done;
}

// Session and painter, as the wish has them. What has not changed is left as it is.
Status RenderThread::followAll(const FrameRequest& wish)
{
	if (!followed_ || !(followed_->spec.input.time == wish.spec.input.time))
		if (Status moved = followTime(wish.spec.input.time); !moved)
			return moved;
	if (!followed_ || !haveSameCut(followed_->spec, wish.spec))
	{
		if (Status resolved = session::resolveAgain(*session_, wish.spec); !resolved)
			return resolved;
		only_moved_ = followed_ && differInPlace(followed_->spec, wish.spec);
		cut_is_old_ = true;
	}
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
	cut_is_old_ = true;
	only_moved_ = false;
	cut_.reset();
	Result<bool> same_grid = picture::moveToTime(*session_, time, painter_ ? &*painter_ : nullptr);
	if (!same_grid)
		return same_grid.error();
	if (!*same_grid)
		neighbors_.drop();
	return Nothing{};
}

Status RenderThread::followLook(const FrameRequest& wish)
{
	Result<view::ResolvedLook> look = view::resolveLook(wish.spec);
	if (!look)
		return look.error();
	const auto finder = look->by_generation           ? find::Finder::traversal
	                    : session_->cutter->usesGpu() ? find::Finder::direct
	                                                  : find::Finder::automatic;
	if (finder != session_->finder)
	{
		session_->finder = finder;
		cut_is_old_ = true;
		only_moved_ = false;
	}
	if (look->range_of_slice && session_->spec.look.range_of == view::RangeOf::data)
	{
		cut_is_old_ = true; // what it shows was not measured
		only_moved_ = false;
	}
	session_->spec.look = wish.spec.look;
	if (painter_)
		return painter_->setLook(std::move(*look));
	Result<picture::Painter> painter = picture::Painter::create(*session_, std::move(*look));
	if (!painter)
		return painter.error();
	painter_.emplace(std::move(*painter));
	return Nothing{};
}

// What can have no contours, such as arrays of cells, has none.
Status RenderThread::growAsWished(const FrameRequest& wish)
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
	if (cut_ && !cut_is_old_)
		return 0.0;
	if (const Result<find::CutPlan> plan = session::planOf(*session_); plan && plan->needs_neighbors)
		if (Status taken = takeNeighbors(true); !taken)
			return taken.error();
	const Moment start = std::chrono::steady_clock::now();
	std::shared_ptr<const session::CutFrame> last = only_moved_ ? cut_ : nullptr;
	Result<cut::Cut> slice =
	    session::cut(*session_, last ? std::shared_ptr<const cut::Cut>(last, &last->slice) : nullptr);
	if (!slice)
		return slice.error();
	auto made = std::make_shared<session::CutFrame>();
	made->slice = std::move(*slice);
	Result<std::vector<session::SheetStats>> sheets = session::statsSince(*session_, made->slice, last.get(), false);
	if (!sheets)
		return sheets.error();
	made->sheets = std::move(*sheets);
	cut_ = std::move(made);
	cut_is_old_ = false;
	++cuts_;
	return millisecondsSince(start);
}

} // namespace vp::app
