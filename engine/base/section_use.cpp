#include "base/section_use.h"

#include "base/processor_counters.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <time.h>

namespace vp
{

namespace
{

struct Counted
{
	std::mutex mutex;
	SectionUses uses;
	std::optional<ProcessorCounters> counters;
	std::string why_no_counters;
};

Counted& counted()
{
	static Counted all;
	return all;
}

std::atomic<bool> counts_use = false;
// A value for each open section of this thread, nothing if its use was not counted when it began.
thread_local std::vector<std::optional<SectionUse>> use_at_begin;

// The use of the process since its start.
std::optional<SectionUse> useSoFar()
{
	if (!counts_use.load(std::memory_order_relaxed))
		return {};
	timespec cpu{};
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	SectionUse use{.cpu_ms = 1e3 * static_cast<double>(cpu.tv_sec) + 1e-6 * static_cast<double>(cpu.tv_nsec),
	               .page_faults = static_cast<double>(usage.ru_minflt),
	               .major_faults = static_cast<double>(usage.ru_majflt)};
	if (counted().counters)
	{
		const ProcessorCounters::Counts counts = counted().counters->read();
		use.instructions = static_cast<double>(counts[ProcessorCounters::instructions]);
		use.cache_misses = static_cast<double>(counts[ProcessorCounters::cache_misses]);
	}
	return use;
}

} // namespace

SectionMeter::SectionMeter()
{
	counted().uses.clear();
	Result<ProcessorCounters> opened = ProcessorCounters::open();
	counted().why_no_counters = opened ? std::string() : opened.error().message;
	if (opened)
		counted().counters.emplace(std::move(*opened));
	counts_use = true;
}

SectionMeter::~SectionMeter()
{
	counts_use = false;
	counted().counters.reset();
}

SectionUses SectionMeter::take()
{
	const std::lock_guard lock(counted().mutex);
	return std::exchange(counted().uses, {});
}

const std::string& SectionMeter::whyNoCounters() const
{
	return counted().why_no_counters;
}

void beginUse()
{
	use_at_begin.push_back(useSoFar());
}

void endUse(std::string_view name)
{
	const std::optional<SectionUse> begin = use_at_begin.back();
	use_at_begin.pop_back();
	const std::optional<SectionUse> end = begin ? useSoFar() : std::nullopt;
	if (!end)
		return;
	const std::lock_guard lock(counted().mutex);
	SectionUses& uses = counted().uses;
	const auto known = uses.find(name);
	SectionUse& sum = known != uses.end() ? known->second : uses[std::string(name)];
	sum.cpu_ms += end->cpu_ms - begin->cpu_ms;
	sum.page_faults += end->page_faults - begin->page_faults;
	sum.major_faults += end->major_faults - begin->major_faults;
	sum.instructions += end->instructions - begin->instructions;
	sum.cache_misses += end->cache_misses - begin->cache_misses;
}

} // namespace vp
