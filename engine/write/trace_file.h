#pragma once

#include "base/result.h"
#include "base/timeline.h"
#include "write/atomic_file.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vp::write
{

// A timeline in the Trace Event Format of Chrome, which chrome://tracing, ui.perfetto.dev and Speedscope show: an
// object whose "traceEvents" are complete events ("X", times in microseconds), counters ("C"), points of flows ("s",
// "t", "f") and metadata ("M": the names of process and rows, and their order), and whose "otherData" says of what the
// trace is. On one row events are nested or apart. The time of a section in none of its parts is an event of its own,
// "other", so the parts add up to the section.
//
// Sections are written as they come; what is kept is a row's last group of nested ones.
class TraceFile
{
public:
	// Tells at once where nothing can be written. "-" is standard output.
	static Result<TraceFile> create(const std::string& path);

	// As Timeline::takeSections() and takeMarks() give them, each section with a row.
	void add(std::vector<Timeline::Section> sections, const std::vector<Timeline::Mark>& marks = {});
	// Adds a line to "otherData".
	void describe(std::string key, std::string value) { about_.emplace_back(std::move(key), std::move(value)); }
	Status commit();

private:
	struct Row
	{
		std::vector<Timeline::Section> waiting; // for the one that they lie in
		std::vector<std::int64_t> open;         // ends of the events that the next may lie in, ns
	};
	struct Event
	{
		const Timeline::Section* section; // null: the rest
		std::int64_t begin;               // ns
		std::int64_t end;
		std::uint32_t depth;
	};

	explicit TraceFile(AtomicFile file) : file_(std::move(file)) {}

	static std::vector<Event> restsOf(const std::vector<Event>& events);
	static std::vector<Event> eventsOf(const std::vector<Timeline::Section>& group);
	void writeGroup(std::uint32_t number, Row& row);
	void writeEvent(std::uint32_t number, const Event& event);
	void writeMark(const Timeline::Mark& mark);
	void writeName(const char* of, std::uint32_t number, const std::string& name);
	void writeRow(std::uint32_t number);
	void startEvent();
	void flushFull();

	AtomicFile file_;
	std::map<std::uint32_t, Row> rows_;
	std::string text_; // not written yet
	bool has_events_ = false;
	std::vector<std::pair<std::string, std::string>> about_;
};

} // namespace vp::write
