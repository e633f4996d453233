#include "session/session.h"

#include "base/messages.h"
#include "base/progress.h"
#include "base/stop_scope.h"
#include "ranks/data/share.h"
#include "ranks/particles/particle_borders.h"
#include "ranks/search/rank_to_rank.h"
#include "ranks/team.h"
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
	if (session.team || !session.device || asked == view::Classify::cpu || leavesDeviceIdle(session.spec.probe) ||
	    !grid::hasNeighbors(session.blocks))
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
	const std::vector<std::string>& files = session.spec.input.files;
	if (!session.team)
		return read::readInputs(files, options, session.timeline.get());
	auto share = std::make_shared<ranks::Share>();
	Result<grid::BlockSet> blocks = ranks::readShare(*session.team, files, options, session.timeline.get(), *share);
	session.share = std::move(share);
	return blocks;
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

Status buildNeighbors(Session& session, const std::stop_token& stop)
try
{
	if (grid::isComplete(session.blocks))
		return Nothing{};
	{
		const Progress progress("finding neighbors");
		if (stop.stop_possible() || !std::ranges::all_of(session.blocks.blocks, hasCheckedIds)) // it may fail
		{
			const auto build = [&] { return buildNeighborsOfCopy(session); };
			if (Status built = endingOnRequest(stop, "finding neighbors", build); !built)
				return built;
		}
		else
		{
			session.cutter.reset();
			read::buildNeighbors(session.blocks, session.timeline.get());
		}
	}
	return makeCutter(session);
}
catch (const grid::WrongPoint& wrong)
{
	return Error{ErrorKind::input, wrong.what()};
}

Status makeCutter(Session& session)
{
	session.particle_borders = std::make_shared<ranks::LazyParticleBorders>();
	if (!classifiesOnGpu(session))
	{
		session.cutter = std::make_unique<cut::Cutter>(session.blocks);
		return Nothing{};
	}
	const Progress progress("uploading");
	Result<std::unique_ptr<cut::Cutter>> cutter =
	    cut::Cutter::onDevice(*session.device, session.blocks, session.view.field, session.timeline.get());
	if (!cutter)
		return cutter.error();
	session.cutter = std::move(*cutter);
	return Nothing{};
}

Status resolveAgain(Session& session, view::ViewSpec spec)
{
	Result<view::ResolvedView> view = view::resolve(spec, session.blocks);
	if (!view)
		return view.error();
	session.spec = std::move(spec);
	session.view = std::move(*view);
	return prepareLaunch(session);
}

namespace
{

cut::CutRequest requestOf(const Session& session)
{
	const view::ResolvedView& view = session.view;
	const view::MachineSpec& machine = session.spec.machine;
	// For a device few generations are wanted; where the traversal is asked for by name it goes as the paper has it.
	seed::SeedOptions seeds = view.seeds;
	seeds.lattice = session.cutter->usesGpu() && session.finder != find::Finder::traversal &&
	                machine.strategy != find::Strategy::generations;
	return {.probe = view.probe,
	        .corners = view.corners,
	        .hanging = view.hanging,
	        .field = view.field,
	        .sheet_fields = view.sheet_fields,
	        .seeds = seeds,
	        .threshold = view.threshold,
	        .finder = session.finder,
	        .strategy = machine.strategy,
	        .another_follows = session.another_follows,
	        .visited = machine.visited.value_or(find::VisitedSet::stamps),
	        .surface = view::listedSurface(view.surface, session.swept),
	        .last = nullptr,
	        .timeline = session.timeline.get()};
}

// A traversal knows when it met a cell, and a device goes by generations, as the paper does, unless it is left to
// choose what is fastest.
find::Finder finderFor(const Session& session)
{
	const view::MachineSpec& machine = session.spec.machine;
	if (machine.visited || session.spec.look.color_by == view::ColorBy::generation)
		return find::Finder::traversal;
	const bool on_device =
	    machine.classify == view::Classify::gpu && session.device && !leavesDeviceIdle(session.spec.probe);
	return on_device ? find::Finder::direct : find::Finder::automatic;
}

Result<grid::BlockSet> readBlocks(Session& session, const OpenOptions& options)
{
	const view::ViewSpec& spec = session.spec;
	const Progress progress(fmt::format("reading {}", fmt::join(spec.input.files, ", ")));
	read::ReadOptions reading = readOptions(session, spec.input.time);
	reading.identifies_geometry = options.reads_again || spec.probe.vectors.path_lines;
	reading.stop = options.stop;
	const bool needs_neighbors = !options.may_scan || needsNeighbors(spec);
	reading.builds_neighbors = needs_neighbors && !options.team; // a rank joins its pieces first
	reading.for_one_cut = !needs_neighbors && (!options.reads_again || options.completes_later) && servesOneCut(spec);
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
	session->team = options.team;
	if (Status fits = options.team ? ranks::fitsTeam(session->spec) : Nothing{}; !fits)
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
	session->finder = finderFor(*session);
	if (Status made = makeCutter(*session); !made)
		return made.error();
	const auto plan = session->cutter->plan(requestOf(*session));
	const bool is_joined = session->team && (!options.may_scan || needsNeighbors(session->spec));
	if (is_joined || (plan && plan->needs_neighbors))
		if (Status built = buildNeighbors(*session, options.stop); !built)
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

Result<cut::Cut> cut(const Session& session, std::shared_ptr<const cut::Cut> last, std::stop_token stop)
{
	if (session.spec.machine.strategy)
		if (const Result<find::CutPlan> plan = planOf(session); !plan)
			return plan.error();
	cut::CutRequest request = requestOf(session);
	request.last = std::move(last);
	Result<cut::Cut> cut =
	    session.team && ranks::goesFromRankToRank(request)
	        ? ranks::cutFromRankToRank(*session.team, session.share->whole, *session.cutter, std::move(request), stop)
	        : session.cutter->cut(request, stop);
	if (stop.stop_requested())
		return Error{ErrorKind::cancelled, "cutting was cancelled"};
	if (session.team && cut && session.view.seeds.outside != seed::OutsidePolicy::nearest)
		ranks::agreeOnHotSpots(*session.team, *cut);
	return cut;
}

Result<find::CutPlan> planOf(const Session& session)
{
	Result<find::CutPlan> plan = session.cutter->plan(requestOf(session));
	if (!plan)
		return Error{plan.error().kind, fmt::format("`strategy` {}", plan.error().message)};
	return plan;
}

const char* classifierName(const Session& session)
{
	return !session.cutter->usesGpu()                                     ? "cpu"
	       : session.cutter->blocksOnGpu() < session.blocks.blocks.size() ? "mixed"
	                                                                      : "gpu";
}

} // namespace vp::session
