#include "base/processor_counters.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <utility>

#include <unistd.h>

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/syscall.h>
#endif

namespace vp
{

#ifdef __linux__

namespace
{

std::string whyNoCounters(int error)
{
	switch (error)
	{
	case ENOENT:
	case ENODEV:
	case EOPNOTSUPP:
		return "this machine has no counters of the processor, or hides them";
	case EACCES:
	case EPERM:
		return "the system does not allow it; /proc/sys/kernel/perf_event_paranoid must be 2 or less";
	default:
		return fmt::format("perf_event_open: {}", std::strerror(error));
	}
}

// Returns -1 if it fails.
int openCounter(ProcessorCounters::Counter counter, pid_t thread)
{
	perf_event_attr wanted{};
	wanted.size = sizeof(wanted);
	wanted.type = PERF_TYPE_HARDWARE;
	wanted.config =
	    counter == ProcessorCounters::instructions ? PERF_COUNT_HW_INSTRUCTIONS : PERF_COUNT_HW_CACHE_MISSES;
	wanted.exclude_kernel = 1;
	wanted.exclude_hv = 1;
	wanted.inherit = 1;
	wanted.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
	return static_cast<int>(syscall(SYS_perf_event_open, &wanted, thread, -1, -1, PERF_FLAG_FD_CLOEXEC));
}

std::vector<pid_t> threadsOfProcess()
{
	std::vector<pid_t> threads;
	std::error_code unknown;
	for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", unknown))
	{
		const std::string name = entry.path().filename().string();
		pid_t thread = 0;
		if (std::from_chars(name.data(), name.data() + name.size(), thread).ec == std::errc())
			threads.push_back(thread);
	}
	return threads;
}

} // namespace

Result<ProcessorCounters> ProcessorCounters::open()
{
	ProcessorCounters counters;
	for (const pid_t thread : threadsOfProcess())
		for (std::uint8_t c = 0; c < count_of_counters; ++c)
		{
			const int file = openCounter(static_cast<Counter>(c), thread);
			if (file >= 0)
				counters.files_[c].push_back(file);
			else if (errno != ESRCH) // the thread has ended
				return Error{ErrorKind::input, whyNoCounters(errno)};
		}
	if (counters.files_[0].empty())
		return Error{ErrorKind::input, "the system does not list the threads of this process"};
	return counters;
}

// Several counters may share one of the processor in turns: then the count is scaled to the whole time.
ProcessorCounters::Counts ProcessorCounters::read() const
{
	struct Told
	{
		std::uint64_t count, enabled, running;
	};
	Counts counts{};
	for (std::size_t c = 0; c < files_.size(); ++c)
		for (const int file : files_[c])
			if (Told told{}; ::read(file, &told, sizeof(told)) == sizeof(told) && told.running > 0)
				counts[c] +=
				    static_cast<std::uint64_t>(static_cast<double>(told.count) * static_cast<double>(told.enabled) /
				                               static_cast<double>(told.running));
	return counts;
}

#else

Result<ProcessorCounters> ProcessorCounters::open()
{
	return Error{ErrorKind::input, "only Linux has perf_event_open"};
}

ProcessorCounters::Counts ProcessorCounters::read() const
{
	return {};
}

#endif

ProcessorCounters::~ProcessorCounters()
{
	for (const auto& of_counter : files_)
		for (const int file : of_counter)
			close(file);
}

} // namespace vp
