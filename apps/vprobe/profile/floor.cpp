#include "profile/floor.h"

#include "profile/spread.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <vector>

namespace vp::app
{

namespace
{

using nlohmann::json;

constexpr std::size_t kFloorBytes = std::size_t(64) << 20; // most caches are smaller
// One try reads so much by one thread: it ends before the system gives the core to others. No more than all threads
// together at this speed is possible, and a floor must not be too high.
constexpr std::size_t kStretch = std::size_t(1) << 15; // numbers of 8 bytes, in sequence
constexpr std::size_t kReads = 2048;                   // at random
constexpr double kLineBytes = 64.0;
constexpr double kLongestSeconds = 0.05; // for all tries of one kind
constexpr double kNearFloor = 4.0;       // a stage that takes no more than so many times its floor is bound by memory
constexpr double kIdleCores = 0.5;       // a stage that keeps fewer cores busy waits

double secondsSince(std::chrono::steady_clock::time_point start)
{
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Returns the least time of some tries, in seconds.
template <class Work>
double leastSeconds(const Work& work)
{
	double least = 1e9;
	for (double all = 0.0; all < kLongestSeconds;)
	{
		const auto start = std::chrono::steady_clock::now();
		work();
		const double seconds = secondsSince(start);
		least = std::min(least, seconds);
		all += seconds;
	}
	return least;
}

double medianUse(const std::vector<SectionUse>& uses, double SectionUse::*part)
{
	std::vector<double> values;
	for (const SectionUse& use : uses)
		values.push_back(use.*part);
	return medianOf(values);
}

const char* boundBy(const std::string& stage, double cores, double times_floor)
{
	if (stage == "wait")
		return "device";
	if (cores < kIdleCores)
		return "waiting";
	return times_floor > 0.0 && times_floor <= kNearFloor ? "memory" : "computing";
}

std::string remedyFor(const std::string& bound, double cores)
{
	if (bound == "device")
		return "fewer pixels help (--size, --samples), or another --device";
	if (bound == "waiting")
		return "an idle machine helps, or --classify cpu if a device is waited for";
	if (bound == "memory")
		return "a smaller --window helps; no other way of cutting can be much faster";
	const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
	return cores > 0.7 * static_cast<double>(threads) ? "more cores help, or a smaller --window"
	                                                  : "another --strategy may help; more --threads do not";
}

// Returns the time of a stage outside of the stages in it.
double ownMs(const json& stages, std::size_t k)
{
	const std::size_t depth = stages[k]["depth"];
	double own = stages[k]["median"];
	for (std::size_t part = k + 1; part < stages.size() && stages[part]["depth"] > depth; ++part)
		if (stages[part]["depth"] == depth + 1)
			own -= stages[part]["median"].get<double>();
	return own;
}

// Tells of the stage that takes longest, without the stages in it.
std::string longestText(const json& stages)
{
	std::size_t longest = 0;
	for (std::size_t k = 1; k < stages.size(); ++k)
		if (ownMs(stages, k) > ownMs(stages, longest))
			longest = k;
	if (stages.empty() || !(stages[0]["median"] > 0.0))
		return "";
	const json& stage = stages[longest];
	const bool has_parts = longest + 1 < stages.size() && stages[longest + 1]["depth"] > stage["depth"];
	const std::string bound = stage["bound_by"];
	return fmt::format("longest: {}{}, {:.0f} % of a frame, bound by {}; {}\n", stage["stage"].get<std::string>(),
	                   has_parts ? " outside of its parts" : "",
	                   100.0 * ownMs(stages, longest) / stages[0]["median"].get<double>(), bound,
	                   remedyFor(bound, stage["cores"].get<double>()));
}

} // namespace

Result<Floor> measureFloor(gpu::Device* device)
{
	std::vector<std::uint64_t> memory(kFloorBytes / sizeof(std::uint64_t), 1);
	std::uint64_t kept = 0; // so that the loops are not left out
	std::size_t next = 0;
	const double in_sequence = leastSeconds(
	    [&]
	    {
		    for (const std::size_t end = next + kStretch; next < end; ++next)
			    kept += memory[next];
		    next %= memory.size();
	    });
	std::uint64_t place = 0;
	const double at_random = leastSeconds(
	    [&]
	    {
		    // Places that follow from each other by arithmetic alone, so that reads overlap.
		    for (std::size_t i = 0; i < kReads; ++i)
		    {
			    place = place * 6364136223846793005 + 1442695040888963407;
			    kept += memory[(place >> 33) % memory.size()];
		    }
	    });
	static std::atomic<std::uint64_t> sink;
	sink = kept;
	const double threads =
	    static_cast<double>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
	Floor floor{.bytes_per_second = threads * sizeof(std::uint64_t) * kStretch / in_sequence,
	            .line_ns = 1e9 * at_random / kReads / threads};
	if (!device)
		return floor;
	const Result<gpu::DeviceSpeed> speed = gpu::measureSpeed(*device);
	if (!speed)
		return speed.error();
	floor.device = *speed;
	return floor;
}

void StageWork::addTouched(const grid::BlockSet& blocks, const session::Frame& frame, std::size_t pixels)
{
	for (const auto& [stage, touched] : touchedBy(blocks, frame))
		touched_[stage].push_back(touched);
	pixels_ = pixels;
	const double bytes = 4.0 * static_cast<double>(pixels);
	if (pixels > 0)
		touched_["pixels"].push_back({bytes / kLineBytes, 1.0});
}

void StageWork::addUse(const SectionUses& uses)
{
	for (const auto& [stage, use] : uses)
		uses_[stage].push_back(use);
}

std::optional<Touched> StageWork::medianTouched(const std::string& stage) const
{
	const auto known = touched_.find(stage);
	if (known == touched_.end())
		return std::nullopt;
	const auto median = [&](double Touched::*part)
	{
		std::vector<double> values;
		for (const Touched& touched : known->second)
			values.push_back(touched.*part);
		return medianOf(values);
	};
	return Touched{median(&Touched::lines), median(&Touched::runs)};
}

// A stage touches each line once: the first one of a run as a random line, those after it in sequence.
double StageWork::floorMs(const std::string& stage, const Floor& floor) const
{
	if (stage == "wait" && floor.device)
		return std::max(floor.device->submit_ms, 1e3 * static_cast<double>(pixels_) / floor.device->pixels_per_second);
	const std::optional<Touched> touched = medianTouched(stage);
	if (!touched)
		return 0.0;
	return 1e-6 * floor.line_ns * touched->runs +
	       1e3 * kLineBytes * (touched->lines - touched->runs) / floor.bytes_per_second;
}

void StageWork::put(json& profile, const Floor& floor) const
{
	for (json& stage : profile["stages"])
	{
		const std::string name = stage["stage"];
		const double ms = stage["median"];
		const auto uses = uses_.find(name);
		const auto used = [&](double SectionUse::*part)
		{ return uses == uses_.end() ? 0.0 : medianUse(uses->second, part); };
		const double cpu_ms = used(&SectionUse::cpu_ms);
		const double cores = ms > 0.0 ? cpu_ms / ms : 0.0;
		const double floor_ms = floorMs(name, floor);
		const double times = floor_ms > 0.0 ? ms / floor_ms : 0.0;
		const std::optional<Touched> touched = medianTouched(name);
		const auto told = [&](double Touched::*part) { return touched ? json((*touched).*part) : json(); };
		stage.update({{"cpu_ms", cpu_ms},
		              {"cores", cores},
		              {"bytes", touched ? json(kLineBytes * touched->lines) : json()},
		              {"lines", told(&Touched::lines)},
		              {"runs", told(&Touched::runs)},
		              {"floor_ms", floor_ms > 0.0 ? json(floor_ms) : json()},
		              {"times_floor", floor_ms > 0.0 ? json(times) : json()},
		              {"bound_by", boundBy(name, cores, times)},
		              {"page_faults", used(&SectionUse::page_faults)},
		              {"major_faults", used(&SectionUse::major_faults)},
		              {"instructions", why_no_counters_.empty() ? json(used(&SectionUse::instructions)) : json()},
		              {"cache_misses", why_no_counters_.empty() ? json(used(&SectionUse::cache_misses)) : json()}});
	}
	if (!why_no_counters_.empty())
		profile["not_counted"]["instructions"] = why_no_counters_;
	profile["floor"] = {{"bytes_per_second", floor.bytes_per_second},
	                    {"line_ns", floor.line_ns},
	                    {"submit_ms", floor.device ? json(floor.device->submit_ms) : json()},
	                    {"pixels_per_second", floor.device ? json(floor.device->pixels_per_second) : json()}};
}

std::string floorText(const json& profile)
{
	if (!profile.contains("floor"))
		return "";
	const json& floor = profile["floor"];
	std::string text = fmt::format("\nthis machine: {:.3g} GB a second in sequence, {:.3g} ns a random line",
	                               1e-9 * floor["bytes_per_second"].get<double>(), floor["line_ns"].get<double>());
	if (!floor["submit_ms"].is_null())
		text += fmt::format("; the device: {:.3g} ms for an empty submission, {:.3g} million pixels a second",
		                    floor["submit_ms"].get<double>(), 1e-6 * floor["pixels_per_second"].get<double>());
	text += "\n";
	for (const json& stage : profile["stages"])
		if (stage["times_floor"].is_number() && stage["times_floor"] < 1.0)
			text += fmt::format("the floor of {} is wrong: the stage was faster\n", stage["stage"].get<std::string>());
	return text + longestText(profile["stages"]);
}

} // namespace vp::app
