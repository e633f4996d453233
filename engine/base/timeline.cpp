#include "base/timeline.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

namespace vp
{

namespace
{

std::atomic<std::uint32_t> rows = 0;

struct RowNames
{
	std::mutex mutex;
	std::map<std::uint32_t, std::string> names;
};

RowNames& rowNames()
{
	static RowNames names;
	return names;
}

void nameRow(std::uint32_t row, std::string name)
{
	const std::lock_guard lock(rowNames().mutex);
	rowNames().names[row] = std::move(name);
}

thread_local std::uint32_t open_sections = 0; // number of open sections of this thread

} // namespace

double Timeline::now() const
{
	return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
}

void Timeline::add(Section section)
{
	const std::lock_guard lock(mutex_);
	const auto same = [&](const Total& total) { return total.track == section.track && total.name == section.name; };
	if (const auto known = std::ranges::find_if(totals_, same); known != totals_.end())
		known->ms += section.duration_ms;
	else
		totals_.push_back({section.name, section.track, section.duration_ms});
	if (keep_ == Keep::sections)
		sections_.push_back(std::move(section));
}

void Timeline::add(std::string_view name, Track track, double start_ms, double duration_ms)
{
	add({std::string(name), track, start_ms, duration_ms});
}

double Timeline::total(std::string_view name, Track track) const
{
	const std::lock_guard lock(mutex_);
	const auto known =
	    std::ranges::find_if(totals_, [&](const Total& total) { return total.track == track && total.name == name; });
	return known == totals_.end() ? 0.0 : known->ms;
}

double Timeline::totalGpu() const
{
	const std::lock_guard lock(mutex_);
	double sum = 0.0;
	for (const Total& total : totals_)
		if (total.track == Track::gpu)
			sum += total.ms;
	return sum;
}

std::vector<Timeline::Section> Timeline::takeSections()
{
	const std::lock_guard lock(mutex_);
	return std::exchange(sections_, {});
}

std::uint32_t threadRow()
{
	thread_local const std::uint32_t row = rows++;
	return row;
}

void nameThreadRow(std::string name)
{
	nameRow(threadRow(), std::move(name));
}

std::uint32_t addRow(std::string name)
{
	const std::uint32_t row = rows++;
	nameRow(row, std::move(name));
	return row;
}

std::string rowName(std::uint32_t row)
{
	const std::lock_guard lock(rowNames().mutex);
	const auto named = rowNames().names.find(row);
	return named == rowNames().names.end() ? "thread " + std::to_string(row) : named->second;
}

double TimedSection::begin() const
{
	++open_sections;
	return timeline_->now();
}

void TimedSection::end() const
{
	const double duration = timeline_->now() - start_;
	timeline_->add({std::string(name_), Timeline::Track::cpu, start_, duration, threadRow(), --open_sections, cells_});
}

} // namespace vp
