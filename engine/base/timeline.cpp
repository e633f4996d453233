#include "base/timeline.h"

#include "base/bytes_read.h"
#include "base/frame_scope.h"
#include "base/section_use.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <map>
#include <new>
#include <utility>

#include <unistd.h>

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

// Returns 0 where the system does not tell.
std::uint64_t residentBytes()
{
	std::uint64_t all = 0;
	std::uint64_t resident = 0;
	std::ifstream("/proc/self/statm") >> all >> resident;
	return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// A worker takes part after part of a loop. A pause shorter than this is the time of the scheduler.
constexpr double kPieceGapMs = 0.005;
constexpr double kResourcesEveryMs = 1.0;

} // namespace

OpenSection& openSection()
{
	thread_local OpenSection open;
	return open;
}

Timeline* Timeline::tracingHere()
{
	Timeline* timeline = openSection().timeline;
	return timeline && timeline->traces() ? timeline : nullptr;
}

double Timeline::now() const
{
	return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
}

void Timeline::add(Section section)
{
	const bool is_summed = section.track == Track::cpu || section.track == Track::gpu;
	const std::lock_guard lock(mutex_);
	if (is_summed)
	{
		const auto same = [&](const Total& total)
		{ return total.track == section.track && total.name == section.name; };
		if (const auto known = std::ranges::find_if(totals_, same); known != totals_.end())
			known->ms += section.duration_ms;
		else
			totals_.push_back({section.name, section.track, section.duration_ms});
	}
	if (traces() || (is_summed && keep_ == Keep::sections))
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
	std::ranges::move(pieces_, std::back_inserter(sections_));
	pieces_.clear();
	return std::exchange(sections_, {});
}

void Timeline::count(const char* name, std::uint64_t value)
{
	if (!traces())
		return;
	const double at = now();
	const std::lock_guard lock(mutex_);
	marks_.push_back({Mark::Kind::counter, name, at, value});
}

void Timeline::countResources()
{
	if (!traces())
		return;
	const double at = now();
	{
		const std::lock_guard lock(mutex_);
		if (resources_at_ms_ >= 0.0 && at < resources_at_ms_ + kResourcesEveryMs)
			return;
		resources_at_ms_ = at;
	}
	const std::uint64_t resident = residentBytes();
	const std::uint64_t read = bytesRead().load(std::memory_order_relaxed);
	const std::lock_guard lock(mutex_);
	marks_.push_back({Mark::Kind::counter, "resident memory", at, resident});
	marks_.push_back({Mark::Kind::counter, "bytes read", at, read});
}

// A frame that was not cut, since nothing had changed, has no flow.
void Timeline::addFlowPoint(Mark::Kind kind, std::uint64_t frame)
{
	if (!traces())
		return;
	const double at = now();
	const std::lock_guard lock(mutex_);
	const bool fits = kind == Mark::Kind::flow_begin ? open_flows_.insert(frame).second : open_flows_.contains(frame);
	if (!fits)
		return;
	if (kind == Mark::Kind::flow_end)
		open_flows_.erase(frame);
	marks_.push_back({kind, "frame", at, frame, threadRow()});
}

void Timeline::addPiece(std::string_view name, std::uint32_t row, double start_ms, double end_ms)
{
	if (!traces())
		return;
	const std::lock_guard lock(mutex_);
	const auto last = std::ranges::find(pieces_, row, &Section::row);
	if (last != pieces_.end() && last->name == name && start_ms - (last->start_ms + last->duration_ms) < kPieceGapMs)
	{
		last->duration_ms = end_ms - last->start_ms;
		return;
	}
	Section piece{std::string(name), Track::worker, start_ms, end_ms - start_ms, row};
	if (last == pieces_.end())
		pieces_.push_back(std::move(piece));
	else
		sections_.push_back(std::exchange(*last, std::move(piece)));
}

std::vector<Timeline::Mark> Timeline::takeMarks()
{
	const std::lock_guard lock(mutex_);
	return std::exchange(marks_, {});
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

double TimedSection::begin()
{
	beginUse(); // may throw, and then the section is not open
	OpenSection& open = openSection();
	outer_ = open;
	open = {timeline_, name_, outer_.depth + 1};
	return timeline_->now();
}

void TimedSection::end() const
{
	const double duration = timeline_->now() - start_;
	openSection() = outer_;
	// Called by a destructor, mostly while memory runs out elsewhere: then the measurement is lost, and not the
	// program.
	try
	{
		endUse(name_);
		timeline_->add({std::string(name_), track_, start_, duration, threadRow(), outer_.depth, cells_,
		                outer_.depth == 0 ? FrameScope::frame() : Timeline::kNoFrame});
		timeline_->countResources();
	}
	catch (const std::bad_alloc&)
	{
		// nobody measures a program that ends
	}
}

} // namespace vp
