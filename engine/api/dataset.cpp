#include "api/border.h"
#include "api/states.h"
#include "grid/memory.h"
#include "locate/place.h"
#include "probe/probe_file.h"
#include "read/check_mesh.h"
#include "session/time_steps.h"
#include "view/validate.h"
#include "view/words.h"
#include "write/place_values.h"
#include "write/set_arrays.h"

#include <vprobe/dataset.h>

#include <cmath>
#include <limits>

namespace vprobe
{

ArrayInfo infoOf(const vp::grid::Field& field)
{
	return {field.name, field.association == vp::grid::Association::point ? Association::point : Association::cell,
	        static_cast<NumberType>(field.type), field.components, field.units};
}

namespace
{

vp::view::MachineSpec machineOf(Classify classify, const std::string& device)
{
	vp::view::MachineSpec machine;
	machine.classify = static_cast<vp::view::Classify>(classify);
	machine.device = device;
	return machine;
}

} // namespace

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
	// When neighbors are known, cells keep their numbers. Before that a copy is cheap, and nothing changes it.
	if (!vp::grid::hasNeighbors(session->blocks))
		return std::make_shared<CutBlocks>(std::make_shared<const vp::grid::BlockSet>(session->blocks));
	std::shared_ptr<CutBlocks> shared = blocks_of_cuts.lock();
	if (!shared)
	{
		shared = std::make_shared<CutBlocks>(
		    std::shared_ptr<const vp::grid::BlockSet>(shared_from_this(), &session->blocks));
		blocks_of_cuts = shared;
	}
	return shared;
}

void DatasetState::keepBlocksOfCuts()
{
	if (const std::shared_ptr<CutBlocks> shared = blocks_of_cuts.lock())
	{
		const std::lock_guard lock(shared->mutex); // nobody reads them now
		shared->blocks = std::make_shared<const vp::grid::BlockSet>(session->blocks);
	}
	blocks_of_cuts.reset();
	++linking; // such a cut cannot be drawn on the blocks to come
}

vp::Status DatasetState::moveTo(const vp::read::TimeChoice& time)
{
	keepBlocksOfCuts();
	const vp::Result<bool> moved = vp::session::moveToTime(*session, time, painter ? &*painter : nullptr);
	if (!moved)
		return moved.error();
	forgetValues();
	return vp::Nothing{};
}

vp::Status DatasetState::returnToItsTime()
{
	if (!moved_to)
		return vp::Nothing{};
	if (vp::Status moved = moveTo(session->spec.input.time); !moved)
		return moved;
	moved_to.reset();
	return vp::Nothing{};
}

vp::Status DatasetState::take(const View& view, bool sweeps)
{
	if (!sweeps || !view.state_->spec.sweep.over_times)
		if (vp::Status returned = returnToItsTime(); !returned)
			return returned;
	vp::view::ViewSpec spec = view.state_->spec;
	spec.input = session->spec.input;
	spec.machine.classify = session->spec.machine.classify;
	spec.machine.device = session->spec.machine.device;
	if (vp::Status fits = vp::view::validate(spec); !fits)
		return fits;
	if (vp::Status one = vp::view::requireOneSurface(spec.probe); !one && spec.sweep == vp::view::SweepSpec())
		return one;
	if (vp::Status known = vp::view::refuseGenerations(spec.probe, spec.look.color_by); !known)
		return known;
	if (vp::Status resolved = vp::session::resolveAgain(*session, std::move(spec)); !resolved)
		return resolved;
	session->finder = session->spec.machine.visited || session->spec.look.color_by == vp::view::ColorBy::generation
	                      ? vp::find::Finder::traversal
	                  : session->cutter->usesGpu() ? vp::find::Finder::direct
	                                               : vp::find::Finder::automatic;
	session->swept = 0.0;
	return vp::Nothing{};
}

vp::Status DatasetState::link()
{
	if (vp::grid::hasNeighbors(session->blocks))
		return vp::Nothing{};
	session->another_follows = cuts > 0;
	const vp::Result<vp::find::CutPlan> plan = vp::session::planOf(*session);
	if (!plan)
		return plan.error();
	if (!plan->needs_neighbors && !vp::session::needsNeighbors(session->spec))
		return vp::Nothing{};
	if (vp::Status built = vp::session::buildNeighbors(*session); !built)
		return built;
	++linking;
	return painter ? painter->takeBlocks() : vp::Nothing{};
}

namespace
{

// As session::cutFrame(), but for the figures: a sheet that is shown or exported needs none. wants_figures: it does.
vp::Result<vp::session::CutFrame> cutFrame(const vp::session::Session& session, const std::stop_token& stop,
                                           bool wants_figures)
{
	vp::Result<vp::cut::Cut> slice = vp::session::cut(session, nullptr, stop);
	if (!slice)
		return slice.error();
	if (vp::Status told = vp::session::reportWarnings(session, *slice); !told)
		return told.error();
	auto sheets = vp::session::statsSince(session, *slice, nullptr, wants_figures);
	if (!sheets)
		return sheets.error();
	if (stop.stop_requested())
		return vp::Error{vp::ErrorKind::cancelled, "cutting was cancelled"};
	auto contours =
	    vp::session::growContours(session, *slice, *sheets, session.spec.look.contour, vp::session::Tell::all);
	if (!contours)
		return contours.error();
	return vp::session::CutFrame{std::move(*slice), std::move(*sheets), std::move(*contours)};
}

} // namespace

vp::Result<Cut> DatasetState::cut(std::stop_token stop)
{
	if (vp::Status linked = link(); !linked)
		return linked.error();
	const bool wants_figures = session->spec.probe.vectors.on(); // the flux depends on settings
	vp::Result<vp::session::CutFrame> frame = cutFrame(*session, stop, wants_figures);
	session->timeline->takeSections();
	if (!frame)
		return frame.error();
	++cuts;
	auto state = std::make_shared<Cut::State>();
	state->device = session->device;
	state->blocks = frame->slice.refined ? std::make_shared<CutBlocks>(frame->slice.refined) : blocksOfCut();
	state->frame = std::move(*frame);
	state->figures.resize(state->frame.sheets.size());
	if (wants_figures)
		for (std::size_t s = 0; s < state->figures.size(); ++s)
			state->figures[s] = state->frame.sheets[s].measure;
	state->made_by = this;
	state->linking = linking;
	state->probe = session->spec.probe;
	state->contour = session->spec.look.contour;
	state->color_by = session->spec.look.color_by;
	return Cut(std::move(state));
}

vp::Status DatasetState::takeDevice(std::shared_ptr<vp::gpu::Device> callers)
{
	target.reset();
	painter.reset();
	session->renderer.reset();
	session->cutter.reset();
	session->break_even.reset();
	has_callers_device = callers != nullptr;
	session->device = std::move(callers);
	++linking; // cuts may have their polygons on the device before
	return vp::session::makeCutter(*session);
}

bool DatasetState::fits(const Cut& cut) const
{
	const Cut::State& state = *cut.state_;
	return state.made_by == this && state.linking == linking && state.probe == session->spec.probe &&
	       state.contour == session->spec.look.contour && state.color_by == session->spec.look.color_by;
}

vp::Result<Cut> DatasetState::readyToDraw(const Cut& cut)
{
	vp::Result<vp::view::ResolvedLook> look = vp::view::resolveLook(session->spec);
	if (!look)
		return look.error();
	if (vp::Status opened = vp::session::drawOn(*session); !opened)
		return opened.error();
	if (painter)
	{
		if (vp::Status taken = painter->setLook(std::move(*look)); !taken)
			return taken.error();
	}
	else
	{
		vp::Result<vp::session::Painter> made = vp::session::Painter::create(*session, std::move(*look));
		if (!made)
			return made.error();
		painter.emplace(std::move(*made));
	}
	return fits(cut) ? vp::Result<Cut>(cut) : this->cut({});
}

vp::Error DatasetState::afterFailure(const vp::Error& error)
{
	// A lost device is replaced for the next picture. Cells are classified without a device.
	if (error.kind == vp::ErrorKind::device)
		if (vp::Status left = takeDevice(nullptr); !left)
			return left.error();
	return error;
}

vp::Result<Image> DatasetState::draw(const Cut& cut)
{
	const vp::Result<Cut> drawn = readyToDraw(cut);
	if (!drawn)
		return drawn.error();
	const vp::session::CutFrame& frame = drawn->state_->frame;
	vp::Result<vp::render::Picture> picture = painter->draw(frame.slice, frame.sheets, frame.contours);
	session->timeline->takeSections();
	if (!picture)
		return afterFailure(picture.error());
	return Image{picture->width, picture->height, std::move(picture->rgba)};
}

Result<Dataset> Dataset::open(const std::vector<std::string>& files, const OpenOptions& options)
{
	return guarded(
	    [&]() -> Result<Dataset>
	    {
		    vp::view::ViewSpec spec;
		    spec.input.files = files;
		    const vp::Result<vp::read::TimeChoice> time = vp::read::parseTime(options.time);
		    if (!time)
			    return Error{ErrorKind::usage, "`time` " + options.time + ": " + time.error().message};
		    if (files.empty())
			    return Error{ErrorKind::usage, "there is no file to open; name one, or demo:NAME"};
		    spec.input.time = *time;
		    spec.input.solution = options.solution;
		    spec.input.refine = options.refine;
		    spec.input.displace = options.displace;
		    spec.input.format = options.format;
		    spec.machine = machineOf(options.classify, options.device);
		    Result<std::shared_ptr<DatasetState>> state =
		        DatasetState::of(vp::session::openSession(std::move(spec), {.may_scan = true, .stop = options.stop}));
		    return state ? Result<Dataset>(Dataset(std::move(*state))) : state.error();
	    });
}

Result<Dataset> Dataset::open(const std::string& file, const OpenOptions& options)
{
	return open(std::vector{file}, options);
}

Result<Dataset> Dataset::wrap(std::vector<Block> blocks, Classify classify, const std::string& device)
{
	return guarded(
	    [&]() -> Result<Dataset>
	    {
		    try
		    {
			    vp::view::ViewSpec spec;
			    spec.machine = machineOf(classify, device);
			    Result<std::shared_ptr<DatasetState>> state = DatasetState::of(
			        vp::session::sessionOf(wrapped(std::move(blocks)), std::move(spec), {.may_scan = true}));
			    return state ? Result<Dataset>(Dataset(std::move(*state))) : state.error();
		    }
		    catch (const vp::read::Unusable& unusable)
		    {
			    return Error{ErrorKind::input, unusable.what()};
		    }
	    });
}

const char* Dataset::kind() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks.kind();
}

std::size_t Dataset::cellCount() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks.sourceCellCount();
}

std::size_t Dataset::pointCount() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks.sourcePointCount();
}

std::size_t Dataset::blockCount() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks.blocks.size();
}

std::pair<Vector3, Vector3> Dataset::bounds() const
{
	const std::lock_guard lock(state_->mutex);
	const vp::Box bounds = state_->session->blocks.bounds();
	return {{bounds.lo.x, bounds.lo.y, bounds.lo.z}, {bounds.hi.x, bounds.hi.y, bounds.hi.z}};
}

std::vector<double> Dataset::times() const
{
	const std::lock_guard lock(state_->mutex);
	return state_->session->blocks.times;
}

std::vector<ArrayInfo> Dataset::arrays() const
{
	const std::lock_guard lock(state_->mutex);
	std::vector<ArrayInfo> arrays;
	const auto isKnown = [&](const ArrayInfo& info)
	{
		return std::ranges::any_of(arrays, [&](const ArrayInfo& known)
		                           { return known.name == info.name && known.association == info.association; });
	};
	for (const vp::grid::Block& block : state_->session->blocks.blocks)
		for (const vp::grid::Field& field : block.fields)
			if (const ArrayInfo info = infoOf(field); !isKnown(info))
				arrays.push_back(info);
	return arrays;
}

HeldBlock Dataset::block(std::size_t index) const
{
	const std::lock_guard lock(state_->mutex);
	return heldBlock(state_->session->blocks.blocks[index]);
}

MemoryUse Dataset::memory() const
{
	const std::lock_guard lock(state_->mutex);
	const vp::grid::BlockSet& blocks = state_->session->blocks;
	const vp::grid::Memory grid = vp::grid::memoryOf(blocks);
	const vp::cut::Cutter::Memory cutter = state_->session->cutter->memory();
	const bool copied = std::ranges::any_of(
	    blocks.blocks, [](const vp::grid::Block& block)
	    { return std::holds_alternative<vp::grid::UnstructuredGrid>(block.grid) && vp::grid::hasNeighbors(block); });
	return {grid.geometry, grid.arrays, grid.built(), cutter.marks, cutter.device, copied};
}

void DatasetState::forgetValues()
{
	session->cutter->forgetValues();
	session->finite_fields = std::make_unique<vp::measure::FiniteFields>();
	session->launch.fastest.reset();
	if (painter)
		painter->forgetScales();
}

void Dataset::modified()
{
	const std::lock_guard lock(state_->mutex);
	state_->forgetValues();
}

Status Dataset::setFields(std::vector<std::vector<Field>> fields)
{
	return guarded(
	    [&]() -> Status
	    {
		    const std::lock_guard lock(state_->mutex);
		    vp::session::Session& session = *state_->session;
		    vp::Result<std::vector<std::vector<vp::grid::Field>>> checked = checkedFields(session.blocks, fields);
		    if (!checked)
			    return publicError(checked.error());
		    state_->keepBlocksOfCuts();
		    for (std::size_t b = 0; b < checked->size(); ++b)
			    vp::grid::replaceFields(session.blocks.blocks[b], std::move((*checked)[b]));
		    // What was resolved may name fields that are gone.
		    if (vp::Status resolved =
		            vp::session::resolveAgain(session, {.input = session.spec.input, .machine = session.spec.machine});
		        !resolved)
			    return publicError(resolved.error());
		    state_->forgetValues();
		    return Nothing{};
	    });
}

Result<Cut> Dataset::cut(const View& view, std::stop_token stop) const
{
	return withView<Cut>(*state_, view, [&] { return state_->cut(stop); });
}

Result<std::vector<PlanRow>> Dataset::plan(const View& view) const
{
	const auto rows = [&]() -> vp::Result<std::vector<PlanRow>>
	{
		state_->session->another_follows = state_->cuts > 0;
		const vp::Result<vp::find::CutPlan> plan = vp::session::planOf(*state_->session);
		if (!plan)
			return plan.error();
		std::vector<PlanRow> found;
		for (std::size_t s = 0; s < plan->sheets.size(); ++s)
			for (std::size_t b = 0; b < plan->sheets[s].size(); ++b)
			{
				const vp::find::BlockPlan& way = plan->sheets[s][b];
				found.push_back({s, b, nameOf(way.strategy), nameOf(way.classifier), way.reason()});
			}
		return found;
	};
	return withView<std::vector<PlanRow>>(*state_, view, rows);
}

namespace
{

// Fills one column at a point.
struct SampleAt
{
	const vp::write::SetArray& array;
	const vp::locate::Place& place;
	std::vector<double>& values;

	template <vp::grid::Grid G>
	void operator()(const G& grid) const
	{
		const vp::grid::Field* field = array.per_block[place.block];
		for (int c = 0; c < array.components; ++c)
		{
			double value = std::numeric_limits<double>::quiet_NaN();
			if (field && c < field->components)
				value = field->association == vp::grid::Association::point
				            ? vp::write::valueAt(grid, *field, c, place.weights)
				            : field->value(grid.sourceCell(place.cell), c);
			values.push_back(value);
		}
	}
};

vp::Result<std::vector<vp::write::SetArray>> sampledArrays(const vp::grid::BlockSet& blocks,
                                                           const std::vector<std::string>& names)
{
	std::vector<vp::write::SetArray> all = vp::write::arraysOf(blocks, vp::grid::Association::point);
	for (vp::write::SetArray& array : vp::write::arraysOf(blocks, vp::grid::Association::cell))
		all.push_back(std::move(array));
	if (names.empty())
		return all;
	std::vector<vp::write::SetArray> chosen;
	for (const std::string& name : names)
	{
		const auto choice = vp::grid::chooseField(blocks, name);
		if (!choice)
			return choice.error();
		for (const vp::write::SetArray& array : all)
			for (const vp::grid::Field* field : array.per_block)
				if (field && *choice && array.name == (*choice)->name && field->association == (*choice)->association)
				{
					chosen.push_back(array);
					break;
				}
	}
	return chosen;
}

} // namespace

Result<std::string> Dataset::probeText(const View& view) const
{
	return withView<std::string>(
	    *state_, view, [&]() -> vp::Result<std::string> { return vp::probe::probeText(state_->session->view.probe); });
}

Result<Samples> Dataset::sample(std::span<const Vector3> points, const std::vector<std::string>& names) const
{
	return guarded(
	    [&]() -> Result<Samples>
	    {
		    const std::lock_guard lock(state_->mutex);
		    if (vp::Status returned = state_->returnToItsTime(); !returned)
			    return publicError(returned.error());
		    if (!vp::grid::hasNeighbors(state_->session->blocks))
		    {
			    if (vp::Status built = vp::session::buildNeighbors(*state_->session); !built)
				    return publicError(built.error());
			    ++state_->linking;
			    if (state_->painter)
				    if (vp::Status taken = state_->painter->takeBlocks(); !taken)
					    return publicError(taken.error());
		    }
		    const vp::grid::BlockSet& blocks = state_->session->blocks;
		    const auto arrays = sampledArrays(blocks, names);
		    if (!arrays)
			    return publicError(arrays.error());
		    Samples samples;
		    for (const vp::write::SetArray& array : *arrays)
			    for (const vp::grid::Field* field : array.per_block)
				    if (field)
				    {
					    ArrayInfo info = infoOf(*field);
					    info.components = array.components;
					    samples.columns.push_back({std::move(info), {}});
					    break;
				    }
		    vp::locate::PlaceFinder finder(blocks);
		    for (const Vector3& point : points)
		    {
			    const vp::locate::Place& place = finder.find({point[0], point[1], point[2]});
			    samples.blocks.push_back(place.found() ? static_cast<std::int32_t>(place.block) : -1);
			    std::int64_t cell = -1;
			    if (place.found())
				    std::visit([&](const auto& grid) { cell = static_cast<std::int64_t>(grid.sourceCell(place.cell)); },
				               blocks.blocks[place.block].grid);
			    samples.cells.push_back(cell);
			    for (std::size_t a = 0; a < arrays->size(); ++a)
			    {
				    std::vector<double>& values = samples.columns[a].values;
				    if (place.found())
					    std::visit(SampleAt{(*arrays)[a], place, values}, blocks.blocks[place.block].grid);
				    else
					    values.resize(values.size() + static_cast<std::size_t>((*arrays)[a].components),
					                  std::numeric_limits<double>::quiet_NaN());
			    }
		    }
		    return samples;
	    });
}

Result<Image> Dataset::render(const Cut& cut, const View& view) const
{
	return withView<Image>(*state_, view, [&] { return state_->draw(cut); });
}

Result<Image> Dataset::render(const View& view) const
{
	return withView<Image>(*state_, view,
	                       [&]() -> vp::Result<Image>
	                       {
		                       vp::Result<Cut> cut = state_->cut({});
		                       return cut ? state_->draw(*cut) : cut.error();
	                       });
}

} // namespace vprobe
