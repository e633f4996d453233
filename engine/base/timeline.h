#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace vp
{

// Sections of work on one clock, CPU and GPU alike; thread safe. Times are milliseconds since the timeline was made.
class Timeline
{
public:
	enum class Track
	{
		cpu,
		gpu
	};
	struct Section
	{
		std::string name;
		Track track;
		double start_ms;
		double duration_ms;
	};

	double now() const;
	void add(std::string_view name, Track track, double start_ms, double duration_ms);
	double total(std::string_view name, Track track = Track::cpu) const; // sum of the sections of that name
	double totalGpu() const;                                             // sum of all GPU sections
	std::vector<Section> sections() const;

private:
	using Clock = std::chrono::steady_clock;
	Clock::time_point start_ = Clock::now();
	mutable std::mutex mutex_;
	std::vector<Section> sections_;
};

// Adds the time from its making to its end. A null timeline measures nothing.
class TimedSection
{
public:
	TimedSection(Timeline* timeline, std::string_view name)
	    : timeline_(timeline), name_(name), start_(timeline ? timeline->now() : 0.0)
	{
	}
	~TimedSection()
	{
		if (timeline_)
			timeline_->add(name_, Timeline::Track::cpu, start_, timeline_->now() - start_);
	}
	TimedSection(const TimedSection&) = delete;
	TimedSection& operator=(const TimedSection&) = delete;

private:
	Timeline* timeline_;
	std::string name_;
	double start_;
};

} // namespace vp
