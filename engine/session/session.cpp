#include "session/session.h"

#include "base/messages.h"
#include "base/progress.h"
#include "base/stop_scope.h"
#include "ranks/data/share.h"
#include "ranks/search/rank_to_rank.h"
#include "session/frame.h"
#include "session/sheet_traces.h"
#include "view/validate.h"
#include "view/words.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

namespace vp::session
{

namespace
{

// tbb's limit holds as long as its object lives, and the program needs it to the end.
void limitThreads(int threads)
{
	static std::unique_ptr<tbb::global_control> limit;
	if (threads > 0)
		limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
}

// auto takes what is faster on the fronts to come, which was measured on a part of the grid: all sheets go to the
// device at once, and a plane cuts some N^(2/3) of N cells. Chosen once, since a device must be given the whole grid
// first.
bool isWorthDevice(const Session& session)
{
	const double front = static_cast<double>(session.view.probe.sheets.size()) *
	                     std::pow(static_cast<double>(session.blocks.cellCount()), 2.0 / 3.0);
	const std::optional<std::size_t> from = session.break_even->cells;
	return from && static_cast<double>(*from) <= front;
}

bool classifiesOnGpu(Session& session)
{
	const view::Classify asked = session.spec.machine.classify;
	if (!session.ranks.mayUseDevice() || !session.device || asked == view::Classify::cpu ||
	    leavesDeviceIdle(session.spec.probe) || !grid::hasNeighbors(session.blocks))
		return false;
	if (asked == view::Classify::gpu)
		return true;
	if (session.device->isSoftware())
		return false;
	if (!session.break_even)
	{
		const TimedSection section(session.timeline.get(), "upload");
		const Result<classify::BreakEven> measured = classify::measureBreakEven(*session.device, session.blocks);
		if (!measured)
			warn("{}; the CPU classifies instead", measured.error().message);
		session.break_even = measured ? *measured : classify::BreakEven{};
	}
	return isWorthDevice(session);
}

// Those that are shown, where no others are wanted. Vectors have colors by any array, and start with the first that
// fits.
read::ArrayWish wishedArrays(const view::ProbeSpec& probe)
{
	if (probe.vectors.on())
		return {};
	read::ArrayWish wish{.all = false, .names = {}, .first = probe.array.empty()};
	if (!probe.array.empty())
		wish.names.push_back(probe.array);
	if (!probe.vectors.array.empty())
		wish.names.push_back(probe.vectors.array);
	if (probe.own)
		for (const probe::Sheet& sheet : probe.own->probe.sheets)
			if (sheet.wishes.array)
				wish.names.push_back(*sheet.wishes.array);
	return wish;
}

bool namesPatch(const view::ViewSpec& spec)
{
	return std::holds_alternative<find::PatchName>(spec.probe.surface) ||
	       std::ranges::any_of(spec.look.context, [](const view::ContextSpec& context)
	                           { return context.kind == view::ContextKind::patch; });
}

} // namespace

bool servesOneCut(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	const view::MachineSpec& machine = spec.machine;
	return !probe.threshold && !probe.window && !probe.own && std::holds_alternative<std::monostate>(probe.surface) &&
	       probe.seeds == seed::SeedMode::automatic && probe.outside == seed::OutsidePolicy::nearest &&
	       !machine.visited && machine.classify != view::Classify::gpu &&
	       (!machine.strategy || machine.strategy == find::Strategy::spans);
}

read::ReadOptions readOptions(const view::ViewSpec& spec, const read::TimeChoice& time)
{
	const view::InputSpec& input = spec.input;
	return {.time = time,
	        .solution = input.solution,
	        .refine = input.refine,
	        .displace = input.displace,
	        .patches = namesPatch(spec),
	        .format = input.format,
	        .raw = input.raw};
}

read::ReadOptions readOptions(const Session& session, const read::TimeChoice& time)
{
	read::ReadOptions reading = readOptions(session.spec, time);
	if (!session.reads_all_arrays)
		reading.arrays = wishedArrays(session.spec.probe);
	return reading;
}

Result<grid::BlockSet> readInputs(Session& session, const read::ReadOptions& options)
{
	return ranks::readInputs(session.ranks, session.spec.input.files, options, session.timeline.get());
}

bool needsNeighbors(const view::ViewSpec& spec)
{
	const view::ProbeSpec& probe = spec.probe;
	const view::LookSpec& look = spec.look;
	return probe.crinkle || probe.vectors.on() || view::replacesSheets(probe.surface) ||
	       look.color_by == view::ColorBy::generation || look.outline == render::Outline::edges ||
	       !look.context.empty() || look.contour.isGiven();
}

namespace
{

bool hasCheckedIds(const grid::Block& block)
{
	const auto* cells = std::get_if<grid::UnstructuredGrid>(&block.grid);
	return !cells || !cells->list() || cells->list()->has_checked_ids;
}

// Replaces the blocks when all of them are complete. They share what does not change.
Status buildNeighborsOfCopy(Session& session)
{
	grid::BlockSet blocks = session.blocks;
	read::buildNeighbors(blocks, session.timeline.get());
	session.cutter.reset();
	session.blocks = std::move(blocks);
	return Nothing{};
}

} // namespace

Status Session::buildNeighbors(const std::stop_token& stop)
try
{
	if (grid::isComplete(blocks))
		return Nothing{};
	{
		const Progress progress("finding neighbors");
		if (stop.stop_possible() || !std::ranges::all_of(blocks.blocks, hasCheckedIds)) // it may fail
		{
			const auto build = [&] { return buildNeighborsOfCopy(*this); };
			if (Status built = endingOnRequest(stop, "finding neighbors", build); !built)
				return built;
		}
		else
		{
			cutter.reset();
			read::buildNeighbors(blocks, timeline.get());
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
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		built.blocks[b].fields = std::move(blocks.blocks[b].fields);
	cutter.reset();
	blocks = std::move(built);
	return makeCutter();
}

Status Session::makeCutter()
{
	++stamp.cells;
	ranks.forgetBorders();
	if (!classifiesOnGpu(*this))
	{
		cutter = std::make_unique<cut::Cutter>(blocks);
		return Nothing{};
	}
	const Progress progress("uploading");
	Result<std::unique_ptr<cut::Cutter>> made = cut::Cutter::onDevice(*device, blocks, view.field, timeline.get());
	if (!made)
		return made.error();
	cutter = std::move(*made);
	return Nothing{};
}

void Session::forgetValues()
{
	++stamp.values;
	cutter->forgetValues();
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
	       (a.look.range_of == b.look.range_of || b.look.range_of == view::RangeOf::data); // of a slice: measured
}

/// Returns true if resolving the probe for the same blocks gives the same.
bool resolveAlike(const view::ViewSpec& a, const view::ViewSpec& b)
{
	view::InputSpec input = a.input;
	input.time = b.input.time;
	return a.probe == b.probe && input == b.input && a.machine == b.machine;
}

} // namespace

Status Session::set(view::ViewSpec other)
{
	if (!cutAlike(spec, other))
		++stamp.settings;
	if (is_resolved && resolveAlike(spec, other))
	{
		spec = std::move(other);
		return Nothing{};
	}
	++stamp.place;
	return resolveAgain(*this, std::move(other));
}

Status resolveAgain(Session& session, view::ViewSpec spec)
{
	session.is_resolved = false;
	Result<view::ResolvedView> view = view::resolve(spec, session.blocks);
	if (!view)
		return view.error();
	session.spec = std::move(spec);
	session.view = std::move(*view);
	const Status prepared = prepareLaunch(session);
	session.is_resolved = bool(prepared);
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
	return session.spec.machine.classify == view::Classify::gpu && session.device &&
	       !leavesDeviceIdle(session.spec.probe);
}

} // namespace

cut::CutRequest Session::cutRequest(const FrameRequest& request) const
{
	const view::MachineSpec& machine = spec.machine;
	const bool in_generations = asksForGenerations(spec);
	// For a device few generations are wanted; where the traversal is asked for by name it goes as the paper has it.
	seed::SeedOptions seeds = view.seeds;
	seeds.lattice = cutter->usesGpu() && !in_generations && machine.strategy != find::Strategy::generations;
	probe::Probe probe = view.probe;
	if (request.pose)
		probe.frame = *request.pose;
	return {.probe = std::move(probe),
	        .corners = view.corners,
	        .hanging = view.hanging,
	        .field = view.field,
	        .sheet_fields = view.sheet_fields,
	        .seeds = seeds,
	        .threshold = view.threshold,
	        .in_generations = in_generations,
	        .device_first = asksForDevice(*this),
	        .strategy = machine.strategy,
	        .another_follows = request.expect == Expect::more,
	        .visited = machine.visited.value_or(find::VisitedSet::stamps),
	        .surface = view::listedSurface(view.surface, request.done),
	        .last = nullptr,
	        .timeline = timeline.get()};
}

namespace
{

Result<grid::BlockSet> readBlocks(Session& session, const OpenOptions& options)
{
	const view::ViewSpec& spec = session.spec;
	const Progress progress(fmt::format("reading {}", fmt::join(spec.input.files, ", ")));
	read::ReadOptions reading = readOptions(session, spec.input.time);
	reading.identifies_geometry = options.reads_again || spec.probe.vectors.path_lines;
	reading.stop = options.stop;
	const bool needs_neighbors = options.expect == Expect::more || needsNeighbors(spec);
	reading.builds_neighbors = needs_neighbors && options.ranks.buildsWhileReading();
	reading.for_one_cut = !needs_neighbors && options.expect == Expect::one_cut && servesOneCut(spec);
	return readInputs(session, reading);
}

// The session with blocks by `take`, while the device opens.
template <class Take>
Result<std::unique_ptr<Session>> makeSession(view::ViewSpec spec, OpenOptions options, Take&& take)
{
	limitThreads(spec.machine.threads);
	auto session = std::make_unique<Session>();
	session->timeline = std::make_unique<Timeline>(options.keep);
	session->reads_all_arrays = options.reads_all_arrays;
	session->spec = std::move(spec);
	// What can be wrong with the settings is told before a large file is read.
	if (Status fits = view::validate(session->spec); !fits)
		return fits.error();
	session->ranks = options.ranks;
	if (Status fits = ranks::canCarryOut(session->ranks, session->spec); !fits)
		return fits.error();
	std::future<Result<OpenedDevice>> opening;
	if (!options.device)
		opening = openDevice(session->spec, options.use);
	Result<grid::BlockSet> blocks = endingOnRequest(options.stop, "opening", [&] { return take(*session); });
	if (!blocks)
		return blocks.error();
	session->blocks = std::move(*blocks);
	session->device = std::move(options.device);
	if (Status resolved = resolveAgain(*session, session->spec); !resolved)
		return resolved.error();
	if (opening.valid())
	{
		Result<OpenedDevice> opened = opening.get();
		if (!opened)
			return opened.error();
		session->device = std::move(opened->device);
		session->renderer = std::move(opened->renderer);
	}
	if (Status made = session->makeCutter(); !made)
		return made.error();
	const auto plan = session->plan({.expect = Expect::first_of_many});
	const bool is_joined =
	    !session->ranks.buildsWhileReading() && (options.expect == Expect::more || needsNeighbors(session->spec));
	if (is_joined || (plan && plan->needs_neighbors))
		if (Status built = session->buildNeighbors(options.stop); !built)
			return built.error();
	return session;
}

} // namespace

Result<std::unique_ptr<Session>> openSession(view::ViewSpec spec, OpenOptions options)
{
	return makeSession(std::move(spec), options, [&](Session& session) { return readBlocks(session, options); });
}

Result<std::unique_ptr<Session>> sessionOf(grid::BlockSet blocks, view::ViewSpec spec, OpenOptions options)
{
	return makeSession(std::move(spec), std::move(options),
	                   [&](const Session&) -> Result<grid::BlockSet> { return std::move(blocks); });
}

Status drawOn(Session& session)
{
	if (session.device)
		return Nothing{};
	Result<OpenedDevice> opened = openDevice(session.spec, DeviceUse::draw).get();
	if (!opened)
		return opened.error();
	session.device = std::move(opened->device);
	session.renderer = std::move(opened->renderer);
	return Nothing{};
}

Result<cut::Cut> Session::cut(const FrameRequest& request, std::shared_ptr<const cut::Cut> last, std::stop_token stop)
{
	if (spec.machine.strategy)
		if (const Result<find::CutPlan> possible = plan(request); !possible)
			return possible.error();
	cut::CutRequest asked = cutRequest(request);
	asked.last = std::move(last);
	Result<cut::Cut> cut = ranks::carryOut(ranks, *cutter, std::move(asked), stop);
	if (stop.stop_requested())
		return Error{ErrorKind::cancelled, "cutting was cancelled"};
	return cut;
}

Result<find::CutPlan> Session::plan(const FrameRequest& request) const
{
	Result<find::CutPlan> plan = cutter->plan(cutRequest(request));
	if (!plan)
		return Error{plan.error().kind, fmt::format("`strategy` {}", plan.error().message)};
	return plan;
}

Result<bool> Session::needsNeighborsFor(const FrameRequest& request) const
{
	if (grid::isComplete(blocks))
		return false;
	const Result<find::CutPlan> planned = plan(request);
	if (!planned)
		return planned.error();
	// Structured blocks have neighbors by themselves. What they may lack are folds and seams, which one cut does
	// without.
	const bool does_without = grid::hasNeighbors(blocks) ? request.expect == Expect::one_cut && servesOneCut(spec)
	                                                     : !planned->needs_neighbors;
	return !does_without || needsNeighbors(spec);
}

Status Session::prepareFor(const FrameRequest& request, const std::stop_token& stop)
{
	const Result<bool> lacks = needsNeighborsFor(request);
	if (!lacks)
		return lacks.error();
	return *lacks ? buildNeighbors(stop) : Nothing{};
}

const char* classifierName(const Session& session)
{
	return !session.cutter->usesGpu()                                     ? "cpu"
	       : session.cutter->blocksOnGpu() < session.blocks.blocks.size() ? "mixed"
	                                                                      : "gpu";
}

} // namespace vp::session
