#include "sweep/sweep_line.h"

#include "base/messages.h"
#include "base/progress.h"
#include "ranks/team.h"
#include "report/remaining_time.h"
#include "report/stats_json.h"

#include <algorithm>
#include <future>
#include <optional>
#include <utility>

namespace vp::app
{

namespace
{

struct SweptFrame : session::CutFrame
{
	nlohmann::json figures; // of --stats, where they are wanted
};

using CutFrameResult = Result<std::shared_ptr<const SweptFrame>>;

// Cuts one frame after the other, where it is asked for or on a thread of its own.
class Cutter
{
public:
	Cutter(const SweepPlan& plan, const CutSlice& cut_slice, const session::Session& session)
	    : plan_(plan), cut_slice_(cut_slice), session_(session)
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
	CutFrameResult take()
	{
		const TimedSection section(worker_ ? session_.timeline.get() : nullptr, "await cut");
		if (!worker_)
			(*task_)();
		return result_.get();
	}

	/// The next frame takes nothing from those before. No frame is under way.
	void forgetLast() { last_.reset(); }

private:
	using Task = std::packaged_task<CutFrameResult()>;

	CutFrameResult cut(int frame)
	{
		auto made = std::make_shared<SweptFrame>();
		{
			const TimedSection section(session_.timeline.get(), "cut");
			Result<cut::Cut> slice =
			    cut_slice_(frame, last_ ? std::shared_ptr<const cut::Cut>(last_, &last_->slice) : nullptr);
			if (!slice)
				return slice.error();
			made->slice = std::move(*slice);
			Result<std::vector<session::SheetStats>> sheets =
			    session::statsSince(session_, made->slice, last_.get(), plan_.wants_figures);
			if (!sheets)
				return sheets.error();
			made->sheets = std::move(*sheets);
			Result<session::Contours> contours =
			    session::growContours(session_, made->slice, made->sheets, plan_.contour, session::Tell::unfit);
			if (!contours)
				return contours.error();
			made->contours = std::move(*contours);
		}
		if (plan_.wants_figures)
			made->figures = {{"sheets", sheetsJson(session_, made->slice, made->sheets)},
			                 {"contours", contoursJson(session_, made->contours)}};
		last_ = made;
		return std::shared_ptr<const SweptFrame>(std::move(made));
	}

	const SweepPlan& plan_;
	const CutSlice& cut_slice_;
	const session::Session& session_;
	std::shared_ptr<Task> task_; // that nobody has begun
	std::future<CutFrameResult> result_;
	std::shared_ptr<const SweptFrame> last_; // of the thread that cuts
	std::optional<Worker> worker_;           // must be the last member, since it uses the others
};

// The first frame from `frame` on that is not there yet, or the number of frames. Of a team, one rank knows what is
// there.
int nextFrame(int frame, const SweepPlan& plan, const SweepProducts& products, ranks::Team* team,
              RemainingTime& remaining)
{
	int next = frame;
	while (next < plan.frames && products.has(next))
		++next;
	if (team)
		ranks::sumOverAll(*team, next, [](int& last, int other) { last = std::max(last, other); });
	for (; frame < next; ++frame)
		remaining.skip();
	return next;
}

// Whether the frame shows nothing, at any rank.
bool isEmpty(const session::Session& session, const session::CutFrame& frame)
{
	const bool is_shown = !std::ranges::all_of(frame.slice.sheets, session::isEmpty);
	return !(session.team ? ranks::anyOf(*session.team, is_shown) : is_shown);
}

// Whether a frame has a sheet that lies in the boundary, so that its area is 0.
bool hasBoundarySheet(const session::CutFrame& frame)
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

Result<nlohmann::json> sweepThrough(const SweepPlan& plan, const CutSlice& cut_slice, const session::Session& session,
                                    SweepProducts& products)
{
	nlohmann::json figures = nlohmann::json::array();
	int empty = 0;
	int in_boundary = 0;
	RemainingTime remaining(static_cast<std::size_t>(plan.frames));
	Progress progress(remaining.line());
	if (plan.writes_beside)
		products.writeBeside();
	Cutter cutter(plan, cut_slice, session);
	int next = nextFrame(0, plan, products, session.team, remaining);
	const auto lacksNeighbors = [&](int frame)
	{ return plan.build_neighbors && frame > 0 && frame < plan.frames && !grid::hasNeighbors(session.blocks); };
	if (lacksNeighbors(next))
		if (Status built = plan.build_neighbors(); !built)
			return built.error();
	if (next < plan.frames)
		cutter.start(next);
	while (next < plan.frames)
	{
		const int frame = next;
		progress.say(remaining.line());
		const CutFrameResult cut = cutter.take();
		if (!cut)
			return firstError(products, cut.error());
		next = nextFrame(frame + 1, plan, products, session.team, remaining);
		const bool waits = lacksNeighbors(next); // until the first frame is done with
		if (next < plan.frames && !waits)
			cutter.start(next);
		if (Status added = products.add(frame, **cut); !added)
			return firstError(products, added.error());
		if (waits)
		{
			if (Status built = plan.build_neighbors(); !built)
				return firstError(products, built.error());
			cutter.forgetLast();
			cutter.start(next);
		}
		remaining.done();
		empty += isEmpty(session, **cut);
		if (plan.wants_figures)
		{
			in_boundary += hasBoundarySheet(**cut);
			figures.push_back((*cut)->figures);
			figures.back()["frame"] = frame;
		}
		if (plan.trace)
			plan.trace->add(session.timeline->takeSections());
	}
	if (Status written = products.commit(); !written)
		return written.error();
	if (plan.trace)
		plan.trace->add(session.timeline->takeSections());
	if (empty > 0)
		warn("{} of {} frames are empty: the probe misses the grid there", empty, plan.frames);
	if (in_boundary > 0)
		warn("in {} of {} frames a sheet lies in the boundary of the grid and cuts no cell, so its area is 0; "
		     "boundary_area, boundary_mean and boundary_flux are its figures",
		     in_boundary, plan.frames);
	return figures;
}

} // namespace vp::app
