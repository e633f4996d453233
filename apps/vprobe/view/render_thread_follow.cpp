#include "time_steps.h"
#include "view/render_thread.h"
#include "view/view_state.h"

#include <utility>

namespace vp::app
{

namespace
{

// Whether two cuts differ in no more than where their probes are.
bool differInPlace(ProbeOptions a, const ProbeOptions& b)
{
	takePlace(a, b);
	return a == b;
}

// The painter draws lines around windows by these.
bool haveSameRims(const ProbeOptions& a, const ProbeOptions& b)
{
	return a.probe == b.probe && a.window == b.window;
}

ProbeOptions withoutTime(ProbeOptions options)
{
	options.time.clear();
	return options;
}

} // namespace

Status RenderThread::takeNeighbors(const ProbeOptions& options, bool needed)
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
	if (Status made = makeCutter(*session_, options); !made)
		return made;
	return painter_ ? painter_->takeBlocks() : Nothing{};
}

Status RenderThread::follow(const FrameRequest& wish)
{
	const bool needed = needsNeighbors(wish.look) || needsNeighbors(wish.probe) || wish.contour;
	Status done = takeNeighbors(wish.probe, needed);
	if (done)
		done = followAll(wish);
	if (!done)
		followed_.reset(); // some of it may have been done
	return done;
}

// Session and painter, as the wish has them. What has not changed is left as it is.
Status RenderThread::followAll(const FrameRequest& wish)
{
	if (!followed_ || followed_->probe.time != wish.probe.time)
		if (Status moved = followTime(wish.probe); !moved)
			return moved;
	if (!followed_ || !(withoutTime(followed_->probe) == withoutTime(wish.probe)))
	{
		if (Status chosen = choose(*session_, wish.probe); !chosen)
			return chosen;
		only_moved_ = followed_ && differInPlace(followed_->probe, wish.probe);
		cut_is_old_ = true;
	}
	if (!followed_ || !(followed_->look == wish.look) || !haveSameRims(followed_->probe, wish.probe))
		if (Status looked = followLook(wish); !looked)
			return looked;
	followed_ = wish;
	return Nothing{};
}

Status RenderThread::followTime(const ProbeOptions& options)
{
	if (!followed_)
		return Nothing{}; // the session was opened at this time
	Result<read::TimeChoice> time = read::parseTime(options.time);
	if (!time)
		return time.error();
	cut_is_old_ = true;
	only_moved_ = false;
	cut_.reset();
	Result<bool> same_grid = moveToTime(*session_, options, *time, painter_ ? &*painter_ : nullptr);
	if (!same_grid)
		return same_grid.error();
	if (!*same_grid)
		neighbors_.drop();
	return Nothing{};
}

Status RenderThread::followLook(const FrameRequest& wish)
{
	Result<LookChoice> look = parseLook(wish.look, wish.probe.inputs);
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
	if (look->range_of_slice && !session_->range_of_slice)
	{
		cut_is_old_ = true; // what it shows was not measured
		only_moved_ = false;
	}
	session_->range_of_slice = look->range_of_slice;
	if (painter_)
		return painter_->setLook(wish.probe, std::move(*look));
	Result<Painter> painter = Painter::create(*session_, wish.probe, std::move(*look));
	if (!painter)
		return painter.error();
	painter_.emplace(std::move(*painter));
	return Nothing{};
}

// What can have no contours, such as arrays of cells, has none.
Status RenderThread::growAsWished(const FrameRequest& wish)
{
	ContourOptions options = wish.look.contour;
	options.opacity = 1.0; // a matter of drawing
	if (grown_.cut == cut_ && grown_.options == options && grown_.pointed == wish.contour)
		return Nothing{};
	Result<Contours> contours =
	    growContours(*session_, cut_->slice, cut_->sheets, options, Tell::nothing, wish.contour);
	if (!contours)
		return contours.error();
	grown_ = {cut_, options, wish.contour, std::move(*contours)};
	return Nothing{};
}

Result<double> RenderThread::cutAsWished(const ProbeOptions& options)
{
	if (cut_ && !cut_is_old_)
		return 0.0;
	if (const Result<find::CutPlan> plan = planOf(*session_); plan && plan->needs_neighbors)
		if (Status taken = takeNeighbors(options, true); !taken)
			return taken.error();
	const Moment start = std::chrono::steady_clock::now();
	std::shared_ptr<const CutFrame> last = only_moved_ ? cut_ : nullptr;
	Result<cut::Cut> slice = cut(*session_, last ? std::shared_ptr<const cut::Cut>(last, &last->slice) : nullptr);
	if (!slice)
		return slice.error();
	auto made = std::make_shared<CutFrame>();
	made->slice = std::move(*slice);
	Result<std::vector<SheetStats>> sheets = statsSince(*session_, made->slice, last.get(), false);
	if (!sheets)
		return sheets.error();
	made->sheets = std::move(*sheets);
	cut_ = std::move(made);
	cut_is_old_ = false;
	++cuts_;
	return millisecondsSince(start);
}

} // namespace vp::app
