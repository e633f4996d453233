#include "session/frame.h"

#include "base/frame_scope.h"
#include "parts/stoppable.h"
#include "ranks/data/share.h"
#include "ranks/join/hanging_borders.h"

#include <algorithm>

namespace vp::session
{

namespace
{

bool cutsByValue(const probe::Probe& probe)
{
	return std::ranges::any_of(probe.sheets,
	                           [](const probe::Sheet& sheet) { return sheet.form && sheet.form->isoValue(); });
}

// Returns true if the cells of a cut are still the cells to cut after the values have changed.
bool keepsCells(const view::ResolvedView& view, const Frame& last)
{
	return !last.slice.refined && !view.threshold && !cutsByValue(view.probe);
}

// Builds the polygons of all sheets. Sheets that did not move since the last frame keep theirs, and their figures. Ends
// with a sheet that hangs, if there is one.
Status addMeshes(const Session& session, const Frame* last, Frame& frame, std::vector<bool>& kept)
{
	for (std::size_t s = 0; s < frame.slice.sheets.size(); ++s)
	{
		kept.push_back(last && s < last->sheets.size() && last->slice.sheets[s].number == frame.slice.sheets[s].number);
		if (kept.back())
		{
			frame.sheets.push_back(last->sheets[s]);
			continue;
		}
		Result<SheetStats> stats = sheetMesh(session, frame.slice, s);
		if (!stats)
			return stats.error();
		frame.sheets.push_back(std::move(*stats));
		if (frame.sheets.back().hangs())
			break;
	}
	return Nothing{};
}

void addFigures(const Session& session, Wants::Figures wanted, const std::vector<bool>& kept, Frame& frame)
{
	if (wanted == Wants::Figures::none)
		return;
	for (std::size_t s = 0; s < frame.sheets.size(); ++s)
		if (!kept[s])
			(wanted == Wants::Figures::all ? measureSheet : measureForPicture)(session, frame.slice, s,
			                                                                   frame.sheets[s]);
}

} // namespace

Result<std::shared_ptr<const Frame>> Session::frame(const FrameRequest& request, std::stop_token stop)
try
{
	const parts::Stoppable reading(stop);
	if (Status ready = prepareFor(request, stop); !ready)
		return ready.error();
	expected_ = request.expect;
	const Frame* last = usableLast(request);
	const bool has_contours = last && (!request.wants.contours || last->contour == spec_.look.contour);
	if (has_contours && last->stamp == stamp_ && last->made_for.isPlacedAs(request) &&
	    last->made_for.wants == request.wants)
		return request.last;

	grid::startCountingParts(blocks_);
	auto frame = std::make_shared<Frame>();
	frame->made_for = request;
	frame->made_for.last.reset();
	frame->stamp = stamp_;
	frame->contour = spec_.look.contour;
	std::vector<bool> kept; // per sheet
	{
		const TimedSection section(timeline_.get(), "cut");
		FrameScope::comesTo(FrameScope::Stop::cut, timeline_.get());
		Result<cut::Cut> found = find(request, last, stop);
		if (!found)
			return found.error();
		frame->slice = std::move(*found);
		if (Status told = request.wants.warns ? reportWarnings(*this, frame->slice) : Nothing{}; !told)
			return told.error();
		if (Status added = addMeshes(*this, last, *frame, kept); !added)
			return added.error();
	}
	if (!frame->sheets.empty() && frame->sheets.back().hangs())
	{
		if (!ranks::shareAPack(ranks_))
			return ranks::sizesDiffer();
		if (Status read = readUndivided(); !read)
			return read.error();
		return this->frame(request, stop);
	}
	addFigures(*this, request.wants.figures, kept, *frame);
	if (stop.stop_requested())
		return Error{ErrorKind::cancelled, "cutting was cancelled"};
	if (request.wants.contours)
	{
		Result<Contours> contours = growContours(*this, frame->slice, frame->sheets, spec_.look.contour,
		                                         request.wants.warns ? Tell::all : Tell::unfit);
		if (!contours)
			return contours.error();
		frame->contours = std::move(*contours);
	}
	return std::shared_ptr<const Frame>(std::move(frame));
}
catch (const parts::Stopped&)
{
	return Error{ErrorKind::cancelled, "cutting was cancelled"};
}
catch (const parts::Unreadable& unreadable)
{
	return Error{ErrorKind::input, unreadable.what()};
}

// Returns the frame before if it was made of the same cells by the same settings, otherwise null.
const Frame* Session::usableLast(const FrameRequest& request) const
{
	const Frame* last = request.last.get();
	return last && last->stamp.cells == stamp_.cells && last->stamp.settings == stamp_.settings &&
	               last->made_for.wants.figures == request.wants.figures
	           ? last
	           : nullptr;
}

// Finds the cut cells, or gathers the new values for those of the frame before.
Result<cut::Cut> Session::find(const FrameRequest& request, const Frame* last, const std::stop_token& stop)
{
	const bool has_new_values = last && last->stamp.values != stamp_.values;
	if (has_new_values && last->stamp.place == stamp_.place && last->made_for.isPlacedAs(request) &&
	    keepsCells(view_, *last))
		return cutter_->regather(last->slice, timeline_.get());
	std::shared_ptr<const cut::Cut> before;
	if (last && !has_new_values)
		before = std::shared_ptr<const cut::Cut>(request.last, &last->slice);
	return cut(request, std::move(before), stop);
}

} // namespace vp::session
