#include "session.h"

#include "base/messages.h"
#include "base/progress.h"
#include "make_probe.h"
#include "sheet_traces.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

namespace vp::app
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

Result<std::optional<find::Threshold>> parseThreshold(const std::vector<double>& numbers)
{
	if (numbers.empty())
		return std::optional<find::Threshold>();
	if (Status finite = requireFinite(numbers, "--threshold"); !finite)
		return finite.error();
	if (numbers[0] > numbers[1])
		return Error{ErrorKind::usage, fmt::format("--threshold {} {}: LO is above HI; give the lower value first",
		                                           numbers[0], numbers[1])};
	return std::optional(find::Threshold{numbers[0], numbers[1]});
}

seed::SeedOptions seedOptions(const ProbeOptions& options)
{
	seed::SeedOptions seeds;
	seeds.mode = options.seeds == "hotspot"    ? seed::SeedMode::hotspot
	             : options.seeds == "boundary" ? seed::SeedMode::boundary
	                                           : seed::SeedMode::automatic;
	seeds.outside = options.outside == "refuse"   ? seed::OutsidePolicy::refuse
	                : options.outside == "report" ? seed::OutsidePolicy::report
	                                              : seed::OutsidePolicy::nearest;
	return seeds;
}

// Of sheets that wish for an array of their own.
Status chooseSheetFields(const ProbeOptions& options, Session& session)
{
	session.sheet_fields.clear();
	for (const probe::Sheet& sheet : session.probe.sheets)
	{
		const probe::SheetWishes& wishes = sheet.wishes;
		if (!wishes.array && !wishes.component)
		{
			session.sheet_fields.push_back(session.field);
			continue;
		}
		Result<std::optional<grid::FieldChoice>> field = grid::chooseField(
		    session.blocks, wishes.array.value_or(options.array), wishes.component.value_or(options.component));
		if (!field)
			return field.error();
		session.sheet_fields.push_back(*field);
	}
	return Nothing{};
}

// auto takes what is faster on the fronts to come, which was measured on a part of the grid: all sheets go to the
// device at once, and a plane cuts some N^(2/3) of N cells. Chosen once, since a device must be given the whole grid
// first.
bool isWorthDevice(const Session& session)
{
	const double front = static_cast<double>(session.probe.sheets.size()) *
	                     std::pow(static_cast<double>(session.blocks.cellCount()), 2.0 / 3.0);
	const std::optional<std::size_t> from = session.break_even->cells;
	return from && static_cast<double>(*from) <= front;
}

bool classifiesOnGpu(const ProbeOptions& options, Session& session)
{
	if (!session.device || options.classify == "cpu" || leavesDeviceIdle(options) ||
	    !grid::hasNeighbors(session.blocks))
		return false;
	if (options.classify == "gpu")
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

} // namespace

namespace
{

// Those that are shown, where no others are wanted. Vectors have colors by any array, and start with the first that
// fits.
read::ArrayWish wishedArrays(const ProbeOptions& options)
{
	if (options.reads_all_arrays || options.vectors.on())
		return {};
	read::ArrayWish wish{.all = false, .names = {}, .first = options.array.empty()};
	if (!options.array.empty())
		wish.names.push_back(options.array);
	if (!options.vectors.array.empty())
		wish.names.push_back(options.vectors.array);
	if (options.own_probe)
		for (const probe::Sheet& sheet : options.own_probe->probe.sheets)
			if (sheet.wishes.array)
				wish.names.push_back(*sheet.wishes.array);
	return wish;
}

} // namespace

read::ReadOptions readOptions(const ProbeOptions& options, const read::TimeChoice& time)
{
	read::ReadOptions reading{time, options.solution, options.refine, options.displace,
	                          options.reads_patches || namesPatch(options)};
	reading.arrays = wishedArrays(options);
	reading.identifies_geometry = options.reads_again || options.vectors.path_lines;
	return reading;
}

bool needsNeighbors(const ProbeOptions& options)
{
	const auto surface = surfaceOf(options);
	return options.crinkle || options.vectors.on() || (surface && *surface);
}

Status buildNeighbors(Session& session, const ProbeOptions& options)
{
	if (grid::hasNeighbors(session.blocks))
		return Nothing{};
	session.cutter.reset();
	{
		const Progress progress("finding neighbors");
		read::buildNeighbors(session.blocks, session.timeline.get());
	}
	return makeCutter(session, options);
}

Status makeCutter(Session& session, const ProbeOptions& options)
{
	if (!classifiesOnGpu(options, session))
	{
		session.cutter = std::make_unique<cut::Cutter>(session.blocks);
		return Nothing{};
	}
	const Progress progress("uploading");
	Result<std::unique_ptr<cut::Cutter>> cutter =
	    cut::Cutter::onDevice(*session.device, session.blocks, session.field, session.timeline.get());
	if (!cutter)
		return cutter.error();
	session.cutter = std::move(*cutter);
	return Nothing{};
}

namespace
{

// Whether seeds from every row serve as well as those that a search would have.
bool isPlain(const ProbeOptions& options)
{
	return options.threshold.empty() && options.window.empty() && !options.own_probe && !options.surface &&
	       options.seeds == "auto" && options.outside == "nearest" && options.visited.empty() &&
	       options.classify != "gpu" && (options.strategy.empty() || options.strategy == "spans");
}

} // namespace

Status choose(Session& session, const ProbeOptions& options)
{
	session.seeds = seedOptions(options);
	session.corners = options.corners == "skip" ? mesh::Corners::skip : mesh::Corners::keep;
	session.crinkle = options.crinkle;
	Result<std::optional<SurfaceChoice>> surface = surfaceOf(options);
	if (!surface)
		return surface.error();
	session.surface = *surface;
	Result<std::optional<find::Threshold>> threshold = parseThreshold(options.threshold);
	if (!threshold)
		return threshold.error();
	session.threshold = *threshold;
	Result<std::optional<grid::FieldChoice>> field =
	    grid::chooseField(session.blocks, options.array, options.component);
	if (!field)
		return field.error();
	session.field = *field;
	if (session.surface)
		if (Status fits = checkSurface(session.blocks, *session.surface, *options.surface); !fits)
			return fits.error();
	if (session.threshold && !session.field)
		return Error{ErrorKind::input, fmt::format("{}: has no array for --threshold to look at; leave the option out",
		                                           options.inputs.front())};
	Result<probe::Probe> probe = makeProbe(options, session.blocks.bounds());
	if (!probe)
		return probe.error();
	session.probe = *probe;
	std::erase_if(session.probe.sheets, [](const probe::Sheet& sheet) { return sheet.wishes.hidden; });
	if (Status chosen = chooseSheetFields(options, session); !chosen)
		return chosen;
	if (Status fits = checkForms(session.probe.sheets, session.sheet_fields); !fits)
		return fits;
	return chooseVectors(options, session);
}

namespace
{

cut::CutRequest requestOf(const Session& session)
{
	std::optional<find::ListedSurface> surface;
	if (session.surface)
		surface = surfaceAt(*session.surface, session.swept);
	// For a device few generations are wanted; where the traversal is asked for by name it goes as the paper has it.
	seed::SeedOptions seeds = session.seeds;
	seeds.lattice = session.cutter->usesGpu() && session.finder != find::Finder::traversal &&
	                session.strategy != find::Strategy::generations;
	return {.probe = session.probe,
	        .corners = session.corners,
	        .field = session.field,
	        .sheet_fields = session.sheet_fields,
	        .seeds = seeds,
	        .threshold = session.threshold,
	        .finder = session.finder,
	        .strategy = session.strategy,
	        .another_follows = session.another_follows,
	        .visited = session.visited,
	        .surface = surface,
	        .last = nullptr,
	        .timeline = session.timeline.get()};
}

} // namespace

Result<std::unique_ptr<Session>> openSession(const ProbeOptions& options, DeviceUse use, Timeline::Keep keep,
                                             std::shared_ptr<gpu::Device> device, const std::stop_token& stop)
{
	limitThreads(options.threads);
	auto session = std::make_unique<Session>();
	session->timeline = std::make_unique<Timeline>(keep);

	Result<read::TimeChoice> time = read::parseTime(options.time);
	if (!time)
		return time.error();
	// What can be wrong on the command line is told before a large file is read.
	if (Status fits = checkProbeOptions(options); !fits)
		return fits.error();
	if (auto surface = surfaceOf(options); !surface)
		return surface.error();
	if (auto form = formOf(options); !form)
		return form.error();
	if (Status fits = checkVectors(options); !fits)
		return fits.error();
	if (auto threshold = parseThreshold(options.threshold); !threshold)
		return threshold.error();
	std::future<Result<OpenedDevice>> opening;
	if (!device)
		opening = openDevice(options, use);
	Result<grid::BlockSet> blocks = [&]
	{
		const Progress progress(fmt::format("reading {}", fmt::join(options.inputs, ", ")));
		read::ReadOptions reading = readOptions(options, *time);
		reading.stop = stop;
		reading.builds_neighbors = !options.may_scan || needsNeighbors(options);
		reading.for_one_cut = !reading.builds_neighbors && !options.reads_again && isPlain(options);
		return read::readInputs(options.inputs, reading, session->timeline.get());
	}();
	if (!blocks)
		return blocks.error();
	session->blocks = std::move(*blocks);
	if (Status chosen = choose(*session, options); !chosen)
		return chosen.error();

	session->device = std::move(device);
	if (opening.valid())
	{
		Result<OpenedDevice> opened = opening.get();
		if (!opened)
			return opened.error();
		session->device = std::move(opened->device);
		session->renderer = std::move(opened->renderer);
	}
	// The device goes by generations, as the paper does, unless it is left to choose what is fastest.
	if (options.classify == "gpu" && session->device && !leavesDeviceIdle(options))
		session->finder = find::Finder::direct;
	session->strategy = find::strategyNamed(options.strategy);
	if (!options.visited.empty())
		session->finder = find::Finder::traversal;
	if (options.visited == "octants")
		session->visited = find::VisitedSet::octants;
	if (Status made = makeCutter(*session, options); !made)
		return made.error();
	if (const auto plan = session->cutter->plan(requestOf(*session)); plan && plan->needs_neighbors)
		if (Status built = buildNeighbors(*session, options); !built)
			return built.error();
	return session;
}

Result<cut::Cut> cut(const Session& session, std::shared_ptr<const cut::Cut> last)
{
	if (session.strategy)
		if (const Result<find::CutPlan> plan = planOf(session); !plan)
			return plan.error();
	cut::CutRequest request = requestOf(session);
	request.last = std::move(last);
	return session.cutter->cut(request);
}

Result<find::CutPlan> planOf(const Session& session)
{
	Result<find::CutPlan> plan = session.cutter->plan(requestOf(session));
	if (!plan)
		return Error{plan.error().kind, fmt::format("--strategy {}", plan.error().message)};
	return plan;
}

bool isEmpty(const cut::SheetCut& sheet)
{
	for (const find::BlockCut& cut : sheet.cuts)
		if (cut.cutCells() > 0)
			return false;
	return std::ranges::all_of(sheet.seeds.faces_in_plane, [](const auto& faces) { return faces.empty(); });
}

Status reportWarnings(const Session& session, const cut::Cut& slice)
{
	for (const std::string& words : slice.warnings)
		warn("{}", words);
	for (const cut::SheetCut& sheet : slice.sheets)
	{
		const Vec3 at = sheet.sheet.origin;
		const bool outside =
		    sheet.isPlane() && session.seeds.mode != seed::SeedMode::boundary && !sheet.seeds.hot_spot_inside;
		if (outside && session.seeds.outside == seed::OutsidePolicy::refuse)
			return Error{ErrorKind::usage,
			             fmt::format("--origin {} {} {}: the hot spot lies outside the grid; choose one inside, or "
			                         "--outside nearest",
			                         at.x, at.y, at.z)};
		if (outside && session.seeds.outside == seed::OutsidePolicy::report)
			warn("--origin {} {} {}: the hot spot lies outside the grid", at.x, at.y, at.z);
		else if (outside && session.seeds.mode == seed::SeedMode::hotspot && sheet.seeds.moved_to)
			warn("--origin {} {} {}: the hot spot lies outside the grid; {} {} {} takes its place", at.x, at.y, at.z,
			     sheet.seeds.moved_to->x, sheet.seeds.moved_to->y, sheet.seeds.moved_to->z);
		if (!isEmpty(sheet))
			continue;
		const Box bounds = session.blocks.bounds();
		const std::string what =
		    slice.sheets.size() == 1 ? std::string("the slice") : fmt::format("sheet {}", &sheet - slice.sheets.data());
		if (session.threshold)
			warn("{} is empty: no cell that is reached has values between {} and {}; widen --threshold", what,
			     session.threshold->lo, session.threshold->hi);
		else if (sheet.surface)
			warn("{} is empty: {} shows no cells, or hidden ones only", what, find::nameOf(*sheet.surface));
		else if (sheet.sheet.form && sheet.sheet.form->isoValue())
			warn("{} is empty: no edge that is reached passes {}; the values of {} go from {:.6g} to {:.6g}", what,
			     sheet.sheet.form->isoValue()->value, sheet.field->title(session.blocks),
			     fieldRange(session.blocks, *sheet.field).first, fieldRange(session.blocks, *sheet.field).second);
		else
			warn("{} is empty: the {} misses the grid; its bounds are {:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} "
			     "{:.6g}",
			     what,
			     sheet.sheet.window ? "window"
			     : sheet.sheet.form ? "surface"
			                        : "plane",
			     bounds.lo.x, bounds.lo.y, bounds.lo.z, bounds.hi.x, bounds.hi.y, bounds.hi.z);
	}
	return Nothing{};
}

} // namespace vp::app
