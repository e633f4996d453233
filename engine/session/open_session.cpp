#include "session/session.h"

#include "base/progress.h"
#include "base/stop_scope.h"
#include "ranks/data/share.h"
#include "read/ready_reader.h"
#include "session/met_parts.h"
#include "view/validate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <future>
#include <memory>
#include <utility>

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

// To read an array of fewer bytes takes less than a tenth of a second.
constexpr std::uint64_t kStaysAbove = 64 << 20;

// All sessions of a process share it, so the last one that was opened has its way.
parts::KeptParts& keptParts(const view::ViewSpec& spec)
{
	static const std::uint64_t usual = parts::KeptParts::halfOfFreeMemory();
	parts::KeptParts& kept = parts::KeptParts::ofProcess();
	kept.setBudget(spec.machine.memory > 0.0 ? static_cast<std::uint64_t>(spec.machine.memory) : usual);
	return kept;
}

bool namesPatch(const view::ViewSpec& spec)
{
	return std::holds_alternative<find::PatchName>(spec.probe.surface) ||
	       std::ranges::any_of(spec.look.context, [](const view::ContextSpec& context)
	                           { return context.kind == view::ContextKind::patch; });
}

} // namespace

std::uint64_t memoryForParts(const view::ViewSpec& spec)
{
	return keptParts(spec).budget();
}

read::ReadOptions readOptions(const view::ViewSpec& spec, const read::TimeChoice& time)
{
	const view::InputSpec& input = spec.input;
	return {.time = time,
	        .solution = input.solution,
	        .refine = input.refine,
	        .level = input.level,
	        .displace = input.displace.value_or(input.displace_by.empty() ? 0.0 : 1.0),
	        .displace_by = input.displace_by,
	        .patches = namesPatch(spec),
	        .format = input.format,
	        .raw = input.raw,
	        .cell_to_point = input.cell_to_point,
	        .ready = std::make_shared<read::ReadyReaders>()};
}

namespace
{

Result<grid::BlockSet> readInputs(const view::ViewSpec& spec, read::ReadOptions reading)
{
	reading.stays_above = memoryForParts(spec);
	const Result<std::vector<std::string>> inputs =
	    read::takeInputs(spec.input.files, spec.input.inputs_as, readOptions(spec, spec.input.time));
	if (!inputs)
		return inputs.error();
	return read::readInputs(*inputs, reading, nullptr);
}

} // namespace

Result<grid::BlockSet> readInputs(const view::ViewSpec& spec)
{
	return readInputs(spec, readOptions(spec, spec.input.time));
}

Result<grid::BlockSet> readFacts(const view::ViewSpec& spec)
{
	read::ReadOptions reading = readOptions(spec, spec.input.time);
	reading.patches = true;
	if (spec.input.files.size() == 1 && !spec.input.displace && spec.input.displace_by.empty())
		reading.keeps_in_runs = true;
	return readInputs(spec, std::move(reading));
}

read::ReadOptions Session::readOptions(const read::TimeChoice& time) const
{
	read::ReadOptions reading = session::readOptions(spec_, time);
	reading.follow = follow_;
	if (!reads_all_arrays_)
		reading.arrays = wishedArrays(spec_.probe);
	reading.stays_above = stays_above_;
	reading.ready = ready_;
	return reading;
}

// Reads the inputs: all of them, or the share of this rank.
Result<grid::BlockSet> Session::readInputs(const read::ReadOptions& options)
{
	return ranks::readInputs(ranks_, inputs_, options, timeline_.get());
}

Result<grid::BlockSet> Session::readBlocks(const OpenOptions& options)
{
	const Progress progress(fmt::format("reading {}", fmt::join(spec_.input.files, ", ")));
	ready_ = std::make_shared<read::ReadyReaders>();
	read::ReadOptions reading = readOptions(spec_.input.time);
	Result<std::vector<std::string>> inputs = read::takeInputs(spec_.input.files, spec_.input.inputs_as, reading);
	if (!inputs)
		return inputs.error();
	inputs_ = std::move(*inputs);
	reading.identifies_geometry = options.time_may_change || spec_.probe.vectors.path_lines;
	reading.stop = options.stop;
	const parts::KeptParts& kept = keptParts(spec_);
	// A device takes whole arrays, and ranks share out a file by themselves.
	if (options.ranks.holdsAll() && spec_.machine.classify != view::Classify::gpu)
		stays_above_ = (options.expect == Expect::one_cut || options.one_cut_a_time) && meetsFewValues(spec_)
		                   ? std::min(kept.budget(), kStaysAbove)
		                   : kept.budget();
	reading.stays_above = stays_above_;
	is_for_one_frame_ = options.expect == Expect::one_cut && options.frames_alone && !options.time_may_change;
	// Faces of whole cells need neighbors, where other ranks have some.
	reading.keeps_in_runs =
	    options.frames_alone && inputs_.size() == 1 &&
	    (options.ranks.holdsAll() ? looksAtCutAlone(spec_) || (is_for_one_frame_ && looksNearPlanes(spec_))
	                              : looksAtCutAlone(spec_) && !spec_.probe.crinkle);
	const bool needs_neighbors = options.expect == Expect::more || needsNeighbors(spec_);
	reading.builds_neighbors = needs_neighbors && options.ranks.buildsWhileReading();
	reading.for_one_cut = !needs_neighbors && options.expect == Expect::one_cut && servesOneCut(spec_);
	return readInputs(reading);
}

// Makes a session with the blocks that `take` gives, while the device opens.
template <class Take>
Result<std::unique_ptr<Session>> Session::make(view::ViewSpec spec, OpenOptions options, Take&& take)
try
{
	limitThreads(spec.machine.threads);
	std::unique_ptr<Session> session(new Session());
	session->timeline_ = std::make_unique<Timeline>(options.keep);
	session->reads_all_arrays_ = options.reads_all_arrays;
	session->follow_ = options.follow;
	session->spec_ = std::move(spec);
	// What can be wrong with the settings is told before a large file is read.
	if (Status fits = view::validate(session->spec_); !fits)
		return fits.error();
	session->ranks_ = options.ranks;
	if (Status fits = ranks::canCarryOut(session->ranks_, session->spec_); !fits)
		return fits.error();
	std::future<Result<OpenedDevice>> opening;
	if (!options.device)
		opening = session::openDevice(session->spec_, options.use, session->timeline_.get());
	Result<grid::BlockSet> blocks = endingOnRequest(options.stop, "opening", [&] { return take(*session); });
	if (!blocks)
		return blocks.error();
	session->blocks_ = std::move(*blocks);
	session->lookForCategories();
	session->takeTime(session->spec_.input.time);
	session->device_ = std::move(options.device);
	if (Status resolved = session->resolve(session->spec_); !resolved)
		return resolved.error();
	if (opening.valid())
	{
		Result<OpenedDevice> opened = opening.get();
		if (!opened)
			return opened.error();
		session->device_ = std::move(opened->device);
		session->renderer_ = std::move(opened->renderer);
	}
	if (Status made = session->makeCutter(); !made)
		return made.error();
	if (grid::lacksParts(session->blocks_) && !session->doesWithParts(session->spec_))
		if (Status read = session->readAllParts(options.stop); !read)
			return read.error();
	const auto plan = session->plan({.expect = Expect::first_of_many});
	const bool is_joined = !session->ranks_.buildsWhileReading() && !grid::lacksParts(session->blocks_) &&
	                       (options.expect == Expect::more || needsNeighbors(session->spec_));
	if (!session->mayLinkNear() && (is_joined || (plan && plan->needs_neighbors)))
		if (Status built = session->buildNeighbors(options.stop); !built)
			return built.error();
	return session;
}
catch (const parts::Unreadable& unreadable)
{
	return Error{ErrorKind::input, unreadable.what()};
}

Result<std::unique_ptr<Session>> Session::open(view::ViewSpec spec, OpenOptions options)
{
	return make(std::move(spec), options, [&](Session& session) { return session.readBlocks(options); });
}

Result<std::unique_ptr<Session>> Session::of(grid::BlockSet blocks, view::ViewSpec spec, OpenOptions options)
{
	return make(std::move(spec), std::move(options),
	            [&](const Session&) -> Result<grid::BlockSet> { return std::move(blocks); });
}

} // namespace vp::session
