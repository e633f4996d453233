#include "base/timeline.h"

namespace vp
{

double Timeline::now() const
{
	return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
}

void Timeline::add(std::string_view name, Track track, double start_ms, double duration_ms)
{
	const std::lock_guard lock(mutex_);
	sections_.push_back({std::string(name), track, start_ms, duration_ms});
}

double Timeline::total(std::string_view name, Track track) const
{
	const std::lock_guard lock(mutex_);
	double sum = 0.0;
	for (const Section& section : sections_)
		if (section.track == track && section.name == name)
			sum += section.duration_ms;
	return sum;
}

double Timeline::totalGpu() const
{
	const std::lock_guard lock(mutex_);
	double sum = 0.0;
	for (const Section& section : sections_)
		if (section.track == Track::gpu)
			sum += section.duration_ms;
	return sum;
}

std::vector<Timeline::Section> Timeline::sections() const
{
	const std::lock_guard lock(mutex_);
	return sections_;
}

} // namespace vp
