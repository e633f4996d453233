#include "session/session.h"

#include "base/messages.h"
#include "base/progress.h"
#include "base/stop_scope.h"
#include "ranks/search/rank_to_rank.h"
#include "session/frame.h"
#include "session/met_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::session
{

bool servesOneCut(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	const view::MachineSpec& machine = spec.machine;
	return !probe.threshold && !probe.window && !probe.own && std::holds_alternative<std::monostate>(probe.surface) &&
	       probe.seeds == seed::SeedMode::automatic && probe.outside == seed::OutsidePolicy::nearest &&
	       !machine.visited && machine.classify != view::Classify::gpu &&
	       (!machine.strategy || machine.strategy == find::Strategy::spans);
}

bool needsNeighbors(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	const view::LookSpec& look = spec.look;
	return probe.vectors.on() || view::replacesSheets(probe.surface) || look.color_by == view::ColorBy::generation ||
	       look.outline == render::Outline::edges || !look.context.empty() || look.contour.isGiven();
}

bool needsNeighbors(const view::ViewSpec& spec, const grid::BlockSet& blocks)
{
	return needsNeighbors(spec) || (spec.probe.crinkle && blocks.blocks.size() > 1);
}

namespace
{

bool hasCheckedIds(const grid::Block& block)
{
	const auto* cells = std::get_if<grid::UnstructuredGrid>(&block.grid);
	return !cells || !cells->list() || cells->list()->has_checked_ids;
}

} // namespace

// Replaces the blocks when all of them are complete. They share what does not change.
Status Session::buildNeighborsOfCopy()
{
	grid::BlockSet blocks = blocks_;
	read::buildNeighbors(blocks, timeline_.get());
	cutter_.reset();
	blocks_ = std::move(blocks);
	return Nothing{};
}

Status Session::buildNeighbors(const std::stop_token& stop)
try
{
	if (grid::isComplete(blocks_))
		return Nothing{};
	if (Status read = readAllParts(stop); !read)
		return read;
	{
		const Progress progress("finding neighbors");
		if (stop.stop_possible() || !std::ranges::all_of(blocks_.blocks, hasCheckedIds)) // it may fail
		{
			const auto build = [&] { return buildNeighborsOfCopy(); };
			if (Status built = endingOnRequest(stop, "finding neighbors", build); !built)
				return built;
		}
		else
		{
			cutter_.reset();
			read::buildNeighbors(blocks_, timeline_.get());
		}
	}
	return makeCutter();
}
catch (const grid::WrongPoint& wrong)
{
	return Error{ErrorKind::input, wrong.what()};
}

Status Session::takeNeighbors(grid::BlockSet built)
{
	for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
	{
		built.blocks[b].fields = std::move(blocks_.blocks[b].fields);
		for (grid::Field& field : built.blocks[b].fields)
			field.is_in_runs = field.is_in_runs && built.blocks[b].runs;
	}
	cutter_.reset();
	blocks_ = std::move(built);
	return makeCutter();
}

// auto takes what is faster on the fronts to come, which was measured on a part of the grid: all sheets go to the
// device at once, and a plane cuts some N^(2/3) of N cells. Chosen once, since a device must be given the whole grid
// first.
bool Session::classifiesOnGpu()
{
	const view::Classify asked = spec_.machine.classify;
	if (!ranks_.mayUseDevice() || !device_ || asked == view::Classify::cpu || leavesDeviceIdle(spec_.probe) ||
	    !grid::hasNeighbors(blocks_) || grid::staysInFile(blocks_))
		return false;
	if (asked == view::Classify::gpu)
		return true;
	if (device_->isSoftware())
		return false;
	if (!break_even_)
	{
		const TimedSection section(timeline_.get(), "upload");
		const Result<classify::BreakEven> measured = classify::measureBreakEven(*device_, blocks_);
		if (!measured)
			warn("{}; the CPU classifies instead", measured.error().message);
		break_even_ = measured ? *measured : classify::BreakEven{};
	}
	const double front =
	    static_cast<double>(view_.probe.sheets.size()) * std::pow(static_cast<double>(blocks_.cellCount()), 2.0 / 3.0);
	return break_even_->cells && static_cast<double>(*break_even_->cells) <= front;
}

// Makes a cutter for the blocks that are there now. Frames that were made before become invalid.
Status Session::makeCutter()
{
	++stamp_.cells;
	markCategories(blocks_, categories_, spec_.probe.interpolate); // blocks that were finished anew have lost the marks
	ranks_.forgetBorders();
	if (!classifiesOnGpu())
	{
		cutter_ = std::make_unique<cut::Cutter>(blocks_);
		return Nothing{};
	}
	const Progress progress("uploading");
	Result<std::unique_ptr<cut::Cutter>> made = cut::Cutter::onDevice(*device_, blocks_, view_.field, timeline_.get());
	if (!made)
		return made.error();
	cutter_ = std::move(*made);
	return Nothing{};
}

// To be called when blocks or values were read.
void Session::lookForCategories()
{
	categories_ = findCategories(blocks_, ranks_);
	markCategories(blocks_, categories_, spec_.probe.interpolate);
}

void Session::takeNewValues()
{
	++stamp_.values;
	cutter_->forgetValues();
	finite_fields_ = std::make_unique<measure::FiniteFields>();
}

void Session::forgetValues()
{
	takeNewValues();
	launch_.fastest.reset();
	is_resolved_ = false; // the step of particles follows from the values
}

Status Session::replaceFields(std::vector<std::vector<grid::Field>> fields)
{
	for (std::size_t b = 0; b < fields.size(); ++b)
		grid::replaceFields(blocks_.blocks[b], std::move(fields[b]));
	lookForCategories();
	// What was resolved may name fields that are gone.
	if (Status resolved = resolve({.input = spec_.input, .machine = spec_.machine}); !resolved)
		return resolved;
	forgetValues();
	return Nothing{};
}

void Session::setArray(const std::vector<grid::Field>& of_each)
{
	for (std::size_t b = 0; b < of_each.size(); ++b)
	{
		std::vector<grid::Field> fields = blocks_.blocks[b].fields;
		const auto known = std::ranges::find_if(
		    fields, [&](const grid::Field& field)
		    { return field.name == of_each[b].name && field.association == of_each[b].association; });
		if (known == fields.end())
			fields.push_back(of_each[b]);
		else
			*known = of_each[b];
		grid::replaceFields(blocks_.blocks[b], std::move(fields));
	}
	forgetValues();
}

Status Session::openDevice()
{
	if (device_)
		return Nothing{};
	Result<OpenedDevice> opened = session::openDevice(spec_, DeviceUse::draw, timeline_.get()).get();
	if (!opened)
		return opened.error();
	device_ = std::move(opened->device);
	renderer_ = std::move(opened->renderer);
	return Nothing{};
}

Status Session::takeDevice(std::shared_ptr<gpu::Device> device)
{
	renderer_.reset();
	cutter_.reset();
	break_even_.reset();
	device_ = std::move(device);
	return makeCutter();
}

Result<render::Renderer> Session::takeRenderer()
{
	Result<render::Renderer> taken = renderer_ ? std::move(*renderer_) : render::Renderer::create(*device_);
	renderer_.reset();
	return taken;
}

bool Session::colorsOverShown(const std::optional<grid::FieldChoice>& field) const
{
	const view::LookSpec& look = spec_.look;
	if (look.range_of != view::RangeOf::automatic || look.logarithmic || !field)
		return look.range_of == view::RangeOf::slice;
	std::uint64_t bytes = 0;
	for (const grid::Field* of_block : field->inEach(blocks_))
		bytes += of_block && of_block->stored ? of_block->stored->layout().byteCount() : 0;
	return bytes > parts::KeptParts::ofProcess().budget();
}

namespace
{

/// Returns true if the same cells are cut in the same way, wherever the probe is.
bool cutAlike(view::ViewSpec a, const view::ViewSpec& b)
{
	a.input.time = b.input.time;
	view::takePlace(a.probe, b.probe);
	const bool in_generations = a.look.color_by == view::ColorBy::generation;
	return a.probe == b.probe && a.input == b.input && a.machine == b.machine &&
	       in_generations == (b.look.color_by == view::ColorBy::generation) &&
	       (a.look.range_of == b.look.range_of || b.look.range_of != view::RangeOf::slice); // of a slice: measured
}

/// Returns true if resolving the probe for the same blocks gives the same.
bool resolveAlike(const view::ViewSpec& a, const view::ViewSpec& b)
{
	view::InputSpec input = a.input;
	input.time = b.input.time;
	return a.probe == b.probe && input == b.input && a.machine == b.machine;
}

} // namespace

Status Session::set(view::ViewSpec spec)
{
	// Whoever draws by these settings may look at all values before there is a frame.
	if (grid::lacksParts(blocks_) && !doesWithParts(spec))
		if (Status read = readAllParts(); !read)
			return read;
	if (!cutAlike(spec_, spec))
		++stamp_.settings;
	if (is_resolved_ && resolveAlike(spec_, spec))
	{
		spec_ = std::move(spec);
		return Nothing{};
	}
	++stamp_.place;
	return resolve(std::move(spec));
}

Status Session::resolve(view::ViewSpec spec)
{
	is_resolved_ = false;
	Result<view::ResolvedView> view = view::resolve(spec, blocks_);
	if (!view)
		return view.error();
	spec_ = std::move(spec);
	view_ = std::move(*view);
	if (markCategories(blocks_, categories_, spec_.probe.interpolate) && cutter_)
		takeNewValues();
	const Status prepared = prepareLaunch();
	is_resolved_ = bool(prepared);
	return prepared;
}

namespace
{

// A traversal knows when it met a cell, and so does the paper's kind of visited set.
bool asksForGenerations(const view::ViewSpec& spec)
{
	return spec.machine.visited || spec.look.color_by == view::ColorBy::generation;
}

// A device that was asked for by name goes by generations, as the paper does.
bool asksForDevice(const Session& session)
{
	return session.spec().machine.classify == view::Classify::gpu && session.device() &&
	       !leavesDeviceIdle(session.spec().probe);
}

} // namespace

cut::CutRequest Session::cutRequest(const FrameRequest& request) const
{
	const view::MachineSpec& machine = spec_.machine;
	const bool in_generations = asksForGenerations(spec_);
	// For a device few generations are wanted; where the traversal is asked for by name it goes as the paper has it.
	seed::SeedOptions seeds = view_.seeds;
	seeds.lattice = cutter_->usesGpu() && !in_generations && machine.strategy != find::Strategy::generations;
	probe::Probe probe = view_.probe;
	if (request.pose)
		probe.frame = *request.pose;
	return {.probe = std::move(probe),
	        .corners = view_.corners,
	        .hanging = view_.hanging,
	        .field = view_.field,
	        .sheet_fields = view_.sheet_fields,
	        .seeds = seeds,
	        .threshold = view_.threshold,
	        .in_generations = in_generations,
	        .device_first = asksForDevice(*this),
	        .strategy = machine.strategy,
	        .another_follows = request.expect == Expect::more,
	        .visited = machine.visited.value_or(find::VisitedSet::stamps),
	        .surface = view::listedSurface(view_.surface, request.done),
	        .last = nullptr,
	        .timeline = timeline_.get()};
}

Result<cut::Cut> Session::cut(const FrameRequest& request, std::shared_ptr<const cut::Cut> last, std::stop_token stop)
{
	if (spec_.machine.strategy)
		if (const Result<find::CutPlan> possible = plan(request); !possible)
			return possible.error();
	cut::CutRequest asked = cutRequest(request);
	asked.last = std::move(last);
	Result<cut::Cut> cut = ranks::carryOut(ranks_, *cutter_, std::move(asked), stop);
	if (stop.stop_requested())
		return Error{ErrorKind::cancelled, "cutting was cancelled"};
	return cut;
}

Result<find::CutPlan> Session::plan(const FrameRequest& request) const
{
	Result<find::CutPlan> plan = cutter_->plan(cutRequest(request));
	if (!plan)
		return Error{plan.error().kind, fmt::format("`strategy` {}", plan.error().message)};
	return plan;
}

Result<bool> Session::needsNeighborsFor(const FrameRequest& request) const
{
	if (grid::isComplete(blocks_))
		return false;
	const Result<find::CutPlan> planned = plan(request);
	if (!planned)
		return planned.error();
	// Structured blocks have neighbors by themselves. What they may lack are folds and seams, which one cut does
	// without.
	const bool does_without = grid::hasNeighbors(blocks_) ? request.expect == Expect::one_cut && servesOneCut(spec_)
	                                                      : !planned->needs_neighbors;
	return !does_without || needsNeighbors(spec_, blocks_) || (spec_.probe.crinkle && !ranks_.holdsAll());
}

Status Session::prepareFor(const FrameRequest& request, const std::stop_token& stop)
{
	Result<bool> lacks = needsNeighborsFor(request);
	if (lacks && *lacks && grid::lacksParts(blocks_) && mayLinkNear())
	{
		const Result<bool> linked = linkNear(request);
		if (!linked)
			return linked.error();
		lacks = !*linked;
	}
	if (!lacks)
		return lacks.error();
	if (grid::lacksParts(blocks_))
		if (Status read = readParts(request, stop); !read)
			return read;
	return *lacks ? buildNeighbors(stop) : Nothing{};
}

const char* classifierName(const Session& session)
{
	return !session.cutter().usesGpu()                                       ? "cpu"
	       : session.cutter().blocksOnGpu() < session.blocks().blocks.size() ? "mixed"
	                                                                         : "gpu";
}

} // namespace vp::session
