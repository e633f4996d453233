#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace vp
{

// Sections of work of CPU and GPU on one clock. Thread safe. Times are milliseconds since the timeline was made.
// It always keeps sums. It keeps the sections too on request; then somebody must take them from time to time.
class Timeline
{
public:
	enum class Track
	{
		cpu,
		gpu
	};
	enum class Keep
	{
		totals,
		sections
	};
	struct Section
	{
		std::string name;
		Track track;
		double start_ms;
		double duration_ms;
		std::uint32_t row = 0;   // who worked, see threadRow(); sections of one row are nested or separate
		std::uint32_t depth = 0; // number of sections of the same row around it
		std::uint64_t cells = 0; // number of cells, if known
	};

	explicit Timeline(Keep keep = Keep::totals) : keep_(keep) {}

	double now() const;
	void add(Section section);
	void add(std::string_view name, Track track, double start_ms, double duration_ms);
	double total(std::string_view name, Track track = Track::cpu) const; // sum of the sections of that name
	double totalGpu() const;                                             // sum of all GPU sections
	// Returns the sections that ended since the last call, in the order of their ends. Returns none if only totals are
	// kept.
	std::vector<Section> takeSections();

private:
	struct Total
	{
		std::string name;
		Track track;
		double ms;
	};

	using Clock = std::chrono::steady_clock;
	Clock::time_point start_ = Clock::now();
	Keep keep_;
	mutable std::mutex mutex_;
	std::vector<Total> totals_;
	std::vector<Section> sections_;
};

// The rows of sections: one for each thread that asks, and others for work elsewhere.
std::uint32_t threadRow();
void nameThreadRow(std::string name); // names the calling thread's row
std::uint32_t addRow(std::string name);
std::string rowName(std::uint32_t row); // "thread 3" if it has no name

// Adds the time between its constructor and its destructor. A null timeline measures nothing.
class TimedSection
{
public:
	TimedSection(Timeline* timeline, std::string_view name, std::uint64_t cells = 0)
	    : timeline_(timeline), name_(name), cells_(cells), start_(timeline ? begin() : 0.0)
	{
	}
	~TimedSection()
	{
		if (timeline_)
			end();
	}
	TimedSection(const TimedSection&) = delete;
	TimedSection& operator=(const TimedSection&) = delete;

private:
	double begin() const;
	void end() const;

	Timeline* timeline_;
	std::string_view name_; // a literal
	std::uint64_t cells_;
	double start_;
};

} // namespace vp
