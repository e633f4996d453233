#include "run_watched.h"

#include <vprobe/result.h>

#include <vtkAlgorithm.h>

#include <chrono>
#include <future>
#include <mutex>

namespace vprobe_paraview
{

std::vector<std::string> runWatched(vtkAlgorithm& filter, double progress,
                                    const std::function<void(std::stop_token)>& work)
{
	// Longer than most cuts take: they end before anything is reported.
	constexpr std::chrono::milliseconds kBetweenReports{50};
	std::mutex mutex; // guards what the listeners hear
	std::vector<std::string> warnings;
	std::string busy_with;
	const vprobe::MessageListener messages(
	    [&](std::string_view line)
	    {
		    const std::lock_guard lock(mutex);
		    warnings.emplace_back(line);
	    });
	const vprobe::ProgressListener stages(
	    [&](std::string_view what)
	    {
		    const std::lock_guard lock(mutex);
		    busy_with = what;
	    });
	std::stop_source stop;
	std::future<void> done = std::async(std::launch::async, work, stop.get_token());
	while (done.wait_for(kBetweenReports) != std::future_status::ready)
	{
		{
			const std::lock_guard lock(mutex);
			filter.SetProgressText(busy_with.empty() ? "cutting" : busy_with.c_str());
		}
		filter.UpdateProgress(progress);
		if (filter.CheckAbort())
			stop.request_stop();
	}
	done.get();
	filter.SetProgressText(nullptr);
	return warnings;
}

} // namespace vprobe_paraview
