#include "sweep/sweep_line.h"

#include "base/messages.h"
#include "base/progress.h"
#include "options/trace_option.h"
#include "report/remaining_time.h"
#include "report/stats_json.h"
#include "session/time_steps.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <future>
#include <optional>
#include <utility>

namespace vp::app
{

namespace
{

struct SweptFrame
{
	std::shared_ptr<const session::Frame> cut;
	std::optional<double> time; // the input's, if the frames are its times
	nlohmann::json figures;     // of --stats, where they are wanted
};

// Cuts one frame after the other, where it is asked for or on a thread of its own.
class Cutter
{
public:
	Cutter(const SweepPlan& plan, const AskFrame& ask, session::Session& session)
	    : plan_(plan), ask_(ask), session_(session)
	{
		if (plan.cuts_ahead)
			worker_.emplace("cutter");
	}

	void start(int frame)
	{
		task_ = std::make_shared<Task>([this, frame] { return cut(frame); });
		result_ = task_->get_future();
		if (worker_)
			worker_->give([task = std::move(task_)] { (*task)(); });
	}
	// Of the frame that was started last.
	Result<SweptFrame> take()
	{
		const TimedSection section(worker_ ? session_.timeline() : nullptr, "await cut");
		if (!worker_)
			(*task_)();
		return result_.get();
	}

	/// Returns true if the frame changes the blocks, since they lack what it needs. No frame is under way.
	bool changesBlocks(int frame) const
	{
		const Result<bool> lacks = session_.changesBlocksFor(ask_(frame));
		return lacks && *lacks; // the frame itself tells what is wrong with it
	}

private:
	using Task = std::packaged_task<Result<SweptFrame>()>;

	Result<SweptFrame> cut(int frame)
	{
		const FrameScope scope(frame, plan_.last_stop);
		if (plan_.times)
			if (Status moved = session_.goTo(session::choiceOfStep(*plan_.times, static_cast<std::size_t>(frame)));
			    !moved)
				return moved.error();
		session::FrameRequest request = ask_(frame);
		request.wants = {.figures = plan_.figures ? session::Wants::Figures::all : session::Wants::Figures::for_picture,
		                 .warns = false};
		request.last = last_;
		Result<std::shared_ptr<const session::Frame>> made = session_.frame(request);
		if (!made)
			return made.error();
		last_ = *made;
		SweptFrame swept{std::move(*made), plan_.times ? session_.time() : std::nullopt, {}};
		if (plan_.figures)
			swept.figures = {{"sheets", sheetsJson(session_, swept.cut->slice, swept.cut->sheets)},
			                 {"contours", contoursJson(session_, swept.cut->contours)},
			                 {"parts", partsJson(session_)}};
		return swept;
	}

	const SweepPlan& plan_;
	const AskFrame& ask_;
	session::Session& session_;
	std::shared_ptr<Task> task_; // that nobody has begun
	std::future<Result<SweptFrame>> result_;
	std::shared_ptr<const session::Frame> last_; // of the thread that cuts
	std::optional<Worker> worker_;               // must be the last member, since it uses the others
};

// The first frame from `frame` on that is not there yet, or the number of frames. Of several processes, one knows
// what is there.
int nextFrame(int frame, const SweepPlan& plan, const SweepProducts& products, const ranks::Ranks& ranks,
              RemainingTime& remaining)
{
	int next = frame;
	while (next < plan.frames && products.has(next))
		++next;
	next = ranks.sum(next, [](int& last, int other) { last = std::max(last, other); });
	for (; frame < next; ++frame)
		remaining.skip();
	return next;
}

// Whether the frame shows nothing, at any rank.
bool isEmpty(const session::Session& session, const session::Frame& frame)
{
	return !session.ranks().any(!std::ranges::all_of(frame.slice.sheets, session::isEmpty));
}

// Whether a frame has a sheet that lies in the boundary, so that its area is 0.
bool hasBoundarySheet(const session::Frame& frame)
{
	return std::ranges::any_of(frame.sheets, [](const session::SheetStats& sheet)
	                           { return sheet.measure.area == 0.0 && sheet.measure.boundary_area > 0.0; });
}

// What went wrong with an earlier frame comes first.
Error firstError(SweepProducts& products, const Error& error)
{
	const Status before = products.finish();
	return before ? error : before.error();
}

} // namespace

Status sweepThrough(const SweepPlan& plan, const AskFrame& ask, session::Session& session, SweepProducts& products)
{
	int empty = 0;
	int in_boundary = 0;
	RemainingTime remaining(static_cast<std::size_t>(plan.frames));
	Progress progress(remaining.line());
	if (plan.writes_beside)
		products.writeBeside();
	Cutter cutter(plan, ask, session);
	int next = nextFrame(0, plan, products, session.ranks(), remaining);
	if (next < plan.frames)
		cutter.start(next);
	while (next < plan.frames)
	{
		const int frame = next;
		const FrameScope scope(frame, plan.last_stop);
		progress.say(remaining.line());
		const Result<SweptFrame> cut = cutter.take();
		if (!cut)
			return firstError(products, cut.error());
		next = nextFrame(frame + 1, plan, products, session.ranks(), remaining);
		const bool waits = next < plan.frames && cutter.changesBlocks(next); // until this frame is done with
		if (next < plan.frames && !waits)
			cutter.start(next);
		if (Status added = products.add(frame, cut->time, *cut->cut); !added)
			return firstError(products, added.error());
		if (waits)
			cutter.start(next);
		remaining.done();
		empty += isEmpty(session, *cut->cut);
		if (plan.figures)
		{
			in_boundary += hasBoundarySheet(*cut->cut);
			nlohmann::json figures = cut->figures;
			figures["frame"] = frame;
			if (cut->time)
				figures["time"] = *cut->time;
			plan.figures->add(session, std::move(figures));
		}
		if (plan.trace)
			addToTrace(session, *plan.trace);
	}
	if (Status written = products.commit(); !written)
		return written.error();
	if (plan.trace)
		addToTrace(session, *plan.trace);
	if (empty > 0)
		warn("{} of {} frames are empty: the probe misses the grid there", empty, plan.frames);
	if (in_boundary > 0)
		warn("in {} of {} frames a sheet lies in the boundary of the grid and cuts no cell, so its area is 0; "
		     "boundary_area, boundary_mean and boundary_flux are its figures",
		     in_boundary, plan.frames);
	return Nothing{};
}

} // namespace vp::app
