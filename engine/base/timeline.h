#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <set>
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
		gpu,
		worker, // a worker's part of a parallel loop (worker_piece.h); only in traces, never in sums
		setup   // opening the device and making pipelines; only in traces, never in sums
	};
	enum class Keep
	{
		totals,
		sections,
		trace // sections, and all else that a trace shows
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
		int frame = kNoFrame;    // see FrameScope; only where no other section lies around it
	};
	static constexpr int kNoFrame = -1;
	// A trace shows these besides sections. The values of a counter hold until the next one. The points of a flow have
	// the number of their frame as value, and lie in the section that was open at that time.
	struct Mark
	{
		enum class Kind
		{
			counter,
			flow_begin,
			flow_step,
			flow_end
		};
		Kind kind;
		const char* name;
		double at_ms;
		std::uint64_t value;
		std::uint32_t row = 0; // where a point of a flow lies
	};

	explicit Timeline(Keep keep = Keep::totals) : keep_(keep) {}

	// Returns the timeline of the innermost open section of this thread if it traces, otherwise null.
	static Timeline* tracingHere();

	bool traces() const { return keep_ == Keep::trace; }
	double now() const;
	void add(Section section);
	void add(std::string_view name, Track track, double start_ms, double duration_ms);
	double total(std::string_view name, Track track = Track::cpu) const; // sum of the sections of that name
	double totalGpu() const;                                             // sum of all GPU sections
	// Returns the sections that ended since the last call, in the order of their ends. Returns none if only totals are
	// kept.
	std::vector<Section> takeSections();

	// These do nothing unless the timeline traces. name: a literal.
	void count(const char* name, std::uint64_t value);
	// Counts the memory in use and the bytes read, unless it has done so within the last millisecond.
	void countResources();
	void addFlowPoint(Mark::Kind kind, std::uint64_t frame);
	// Adds a worker's part of a loop. It joins the part before if that has the same name and ended just now.
	void addPiece(std::string_view name, std::uint32_t row, double start_ms, double end_ms);
	std::vector<Mark> takeMarks(); // as takeSections()

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
	std::vector<Section> pieces_; // the last one of each worker, which may grow
	std::vector<Mark> marks_;
	std::set<std::uint64_t> open_flows_;
	double resources_at_ms_ = -1.0;
};

// The rows of sections: one for each thread that asks, and others for work elsewhere.
std::uint32_t threadRow();
void nameThreadRow(std::string name); // names the calling thread's row
std::uint32_t addRow(std::string name);
std::string rowName(std::uint32_t row); // "thread 3" if it has no name

// The innermost open section of a thread.
struct OpenSection
{
	Timeline* timeline = nullptr;
	std::string_view name{};
	std::uint32_t depth = 0; // number of open sections, parts of loops included
};
OpenSection& openSection(); // that of this thread

// Adds the time between its constructor and its destructor. A null timeline measures nothing.
class TimedSection
{
public:
	TimedSection(Timeline* timeline, std::string_view name, std::uint64_t cells = 0,
	             Timeline::Track track = Timeline::Track::cpu)
	    : timeline_(timeline), name_(name), cells_(cells), track_(track), start_(timeline ? begin() : 0.0)
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
	double begin();
	void end() const;

	Timeline* timeline_;
	std::string_view name_; // a literal, or text that lives longer
	std::uint64_t cells_;
	Timeline::Track track_;
	OpenSection outer_{}; // the open section of this thread before
	double start_;
};

} // namespace vp
