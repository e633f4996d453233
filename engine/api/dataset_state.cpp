#include "api/border.h"
#include "api/states.h"
#include "gpu/instance.h"
#include "session/sheet_traces.h"
#include "session/time_steps.h"
#include "view/validate.h"

#include <algorithm>

namespace vprobe
{

Result<std::shared_ptr<DatasetState>> DatasetState::of(vp::Result<std::unique_ptr<vp::session::Session>> opened)
{
	if (!opened)
		return publicError(opened.error());
	auto state = std::make_shared<DatasetState>();
	state->session = std::move(*opened);
	return state;
}

std::shared_ptr<CutBlocks> DatasetState::blocksOfCut()
{
	// When the blocks are complete, cells keep their numbers. Before that a copy is cheap, and nothing changes it.
	if (!vp::grid::isComplete(session->blocks()))
		return std::make_shared<CutBlocks>(std::make_shared<const vp::grid::BlockSet>(session->blocks()));
	std::shared_ptr<CutBlocks> shared = blocks_of_cuts.lock();
	if (!shared)
	{
		shared = std::make_shared<CutBlocks>(
		    std::shared_ptr<const vp::grid::BlockSet>(shared_from_this(), &session->blocks()));
		blocks_of_cuts = shared;
	}
	return shared;
}

void DatasetState::keepBlocksOfCuts()
{
	if (const std::shared_ptr<CutBlocks> shared = blocks_of_cuts.lock())
	{
		const std::lock_guard lock(shared->mutex); // nobody reads them now
		shared->blocks = std::make_shared<const vp::grid::BlockSet>(session->blocks());
	}
	blocks_of_cuts.reset();
	++linking; // such a cut cannot be drawn on the blocks to come
}

std::vector<ArraySizes> DatasetState::sizes() const
{
	return array_sizes.empty() ? arraySizes(session->blocks()) : array_sizes;
}

vp::Status DatasetState::moveTo(const vp::read::TimeChoice& time)
{
	keepBlocksOfCuts();
	if (vp::Status moved = session->goTo(time); !moved)
		return moved;
	// Arrays of the caller's stay where the grid of that time is as large.
	const std::vector<ArraySizes> now = sizes();
	for (const std::vector<vp::grid::Field>& array : added)
	{
		bool fits = array.size() == now.size();
		for (std::size_t b = 0; fits && b < now.size(); ++b)
			fits = array[b].tuples() ==
			       (array[b].association == vp::grid::Association::point ? now[b].points : now[b].cells);
		if (fits)
			session->setArray(array);
	}
	return vp::Nothing{};
}

vp::Status DatasetState::returnToItsTime()
{
	if (!moved_to)
		return vp::Nothing{};
	if (vp::Status moved = moveTo(session->spec().input.time); !moved)
		return moved;
	moved_to.reset();
	return vp::Nothing{};
}

vp::Status DatasetState::take(const View& view, bool for_sweep)
{
	sweeps = for_sweep;
	if (!for_sweep || !view.state_->spec.sweep.over_times)
		if (vp::Status returned = returnToItsTime(); !returned)
			return returned;
	vp::view::ViewSpec spec = view.state_->spec;
	if (spec.input.cell_to_point && !session->spec().input.cell_to_point)
		return vp::Error{
		    vp::ErrorKind::usage,
		    "`cell_to_point`: is said when data are opened; give it to open(), or smooth the arrays before"};
	spec.input = session->spec().input;
	spec.machine.classify = session->spec().machine.classify;
	spec.machine.device = session->spec().machine.device;
	if (vp::Status fits = vp::view::validate(spec); !fits)
		return fits;
	if (vp::Status one = vp::view::requireOneSurface(spec.probe); !one && spec.sweep == vp::view::SweepSpec())
		return one;
	if (vp::Status known = vp::view::refuseGenerations(spec.probe, spec.look.color_by); !known)
		return known;
	if (spec.probe.interpolate != session->spec().probe.interpolate)
		keepBlocksOfCuts(); // their figures are measured later, with their arrays marked as they were
	request = {};
	return session->set(std::move(spec));
}

vp::Status DatasetState::link(const std::stop_token& stop)
{
	if (vp::grid::isComplete(session->blocks()))
		return vp::Nothing{};
	if (vp::Status built = session->buildNeighbors(stop); !built)
		return built;
	++linking;
	return vp::Nothing{};
}

vp::session::FrameRequest DatasetState::nextRequest() const
{
	vp::session::FrameRequest next = request;
	next.expect = cuts > 0 ? vp::session::Expect::more
	              : sweeps ? vp::session::Expect::first_of_many
	                       : vp::session::Expect::one_cut;
	next.wants.figures = vp::session::Wants::Figures::for_picture; // a cut measures the others when it is asked
	return next;
}

vp::Result<Cut> DatasetState::cut(std::stop_token stop)
{
	const vp::session::FrameRequest next = nextRequest();
	const vp::Result<bool> needs_neighbors = session->needsNeighborsFor(next);
	if (!needs_neighbors)
		return needs_neighbors.error();
	if (*needs_neighbors)
		if (vp::Status linked = link(stop); !linked)
			return linked.error();
	vp::Result<std::shared_ptr<const vp::session::Frame>> frame = session->frame(next, stop);
	session->timeline()->takeSections();
	if (!frame)
		return frame.error();
	vp::session::reportBoundarySheets(*session, (*frame)->sheets);
	vp::session::reportOverlap(*session, (*frame)->slice, (*frame)->sheets);
	vp::session::reportRowsAcross(*session);
	++cuts;
	auto state = std::make_shared<Cut::State>();
	state->device = session->device();
	state->frame = std::move(*frame);
	const vp::session::Frame& made = *state->frame;
	state->blocks = made.slice.refined ? std::make_shared<CutBlocks>(made.slice.refined) : blocksOfCut();
	state->figures.resize(made.sheets.size());
	for (const vp::cut::SheetCut& sheet : made.slice.sheets)
		state->flux_arrays.push_back(vp::session::fluxArray(*session, sheet));
	state->made_by = this;
	state->linking = linking;
	state->probe = session->spec().probe;
	state->contour = session->spec().look.contour;
	state->color_by = session->spec().look.color_by;
	return Cut(std::move(state));
}

vp::Status DatasetState::takeDevice(std::shared_ptr<vp::gpu::Device> callers)
{
	target.reset();
	painter.reset();
	has_callers_device = callers != nullptr;
	++linking; // cuts may have their polygons on the device before
	return session->takeDevice(std::move(callers));
}

bool DatasetState::fits(const Cut& cut) const
{
	const Cut::State& state = *cut.state_;
	return state.made_by == this && state.linking == linking && state.probe == session->spec().probe &&
	       state.contour == session->spec().look.contour && state.color_by == session->spec().look.color_by;
}

vp::Status DatasetState::readyPainter()
{
	vp::Result<vp::view::ResolvedLook> look = vp::view::resolveLook(session->spec());
	if (!look)
		return look.error();
	if (session->device() && session->device()->isInherited())
		return vp::gpu::forkedError();
	if (vp::Status opened = session->openDevice(); !opened)
		return opened.error();
	if (painter)
	{
		if (vp::Status taken = painter->setLook(std::move(*look)); !taken)
			return taken.error();
	}
	else
	{
		vp::Result<vp::picture::Painter> made = vp::picture::Painter::create(*session, std::move(*look));
		if (!made)
			return made.error();
		painter.emplace(std::move(*made));
	}
	return vp::Nothing{};
}

vp::Result<Cut> DatasetState::readyToDraw(const Cut& cut, const std::stop_token& stop)
{
	if (vp::Status ready = readyPainter(); !ready)
		return ready.error();
	return fits(cut) ? vp::Result<Cut>(cut) : this->cut(stop);
}

vp::Error DatasetState::afterFailure(const vp::Error& error)
{
	// A lost device is replaced for the next picture. Cells are classified without a device.
	if (error.kind == vp::ErrorKind::device)
		if (vp::Status left = takeDevice(nullptr); !left)
			return left.error();
	return error;
}

vp::Result<Image> DatasetState::draw(const Cut& cut, const std::stop_token& stop)
{
	const vp::Result<Cut> drawn = readyToDraw(cut, stop);
	if (!drawn)
		return drawn.error();
	const vp::session::Frame& frame = *drawn->state_->frame;
	vp::Result<vp::render::Picture> picture = painter->draw(frame.slice, frame.sheets, frame.contours, stop);
	session->timeline()->takeSections();
	if (!picture)
		return afterFailure(picture.error());
	return Image{picture->width, picture->height, std::move(picture->rgba)};
}

} // namespace vprobe
