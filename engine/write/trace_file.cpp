#include "write/trace_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vp::write
{

namespace
{

constexpr std::size_t kBufferBytes = 1 << 16;
constexpr std::int64_t kMinRest = 1000; // ns: a shorter one is the clock's own time

std::int64_t nanoseconds(double ms)
{
	return std::max<std::int64_t>(0, std::llround(ms * 1e6));
}

// Microseconds, as the format has them, to the nanosecond.
std::string microseconds(std::int64_t ns)
{
	return fmt::format("{}.{:03}", ns / 1000, ns % 1000);
}

// With its quotation marks.
std::string jsonText(const std::string& text)
{
	return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

const char* categoryOf(const Timeline::Section* section)
{
	if (!section)
		return "cpu";
	switch (section->track)
	{
	case Timeline::Track::gpu:
		return "gpu";
	case Timeline::Track::worker:
		return "worker";
	case Timeline::Track::setup:
		return "setup";
	default:
		return "cpu";
	}
}

const char* phaseOf(Timeline::Mark::Kind kind)
{
	switch (kind)
	{
	case Timeline::Mark::Kind::flow_begin:
		return "s";
	case Timeline::Mark::Kind::flow_step:
		return "t";
	case Timeline::Mark::Kind::flow_end:
		return "f";
	default:
		return "C";
	}
}

} // namespace

Result<TraceFile> TraceFile::create(const std::string& path)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	TraceFile trace(std::move(*file));
	trace.text_ = "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[";
	trace.writeName("process_name", 0, "vprobe");
	return trace;
}

void TraceFile::add(std::vector<Timeline::Section> sections, const std::vector<Timeline::Mark>& marks)
{
	for (const Timeline::Mark& mark : marks)
		writeMark(mark);
	for (Timeline::Section& section : sections)
	{
		const auto [at, is_new] = rows_.try_emplace(section.row);
		if (is_new)
			writeRow(section.row);
		const bool is_top = section.depth == 0;
		at->second.waiting.push_back(std::move(section));
		if (is_top)
			writeGroup(at->first, at->second);
	}
}

// The time in which an event holds no other, where it holds any. events: in the order of their beginnings, outer ones
// first.
std::vector<TraceFile::Event> TraceFile::restsOf(const std::vector<Event>& events)
{
	struct Open
	{
		const Event* event;
		std::int64_t told; // until then its time is told
	};
	std::vector<Open> open;
	std::vector<Event> rests;
	const auto tellRest = [&](const Open& of, std::int64_t until)
	{
		if (until - of.told >= kMinRest)
			rests.push_back({nullptr, of.told, until, of.event->depth + 1});
	};
	const auto close = [&](std::uint32_t depth) // and what is deeper
	{
		for (; !open.empty() && open.back().event->depth >= depth; open.pop_back())
			if (open.back().told > open.back().event->begin)
				tellRest(open.back(), open.back().event->end);
	};
	for (const Event& event : events)
	{
		close(event.depth);
		if (!open.empty())
		{
			tellRest(open.back(), event.begin);
			open.back().told = event.end;
		}
		open.push_back({&event, event.begin});
	}
	close(0);
	return rests;
}

// The sections of a group, and the rests between them.
std::vector<TraceFile::Event> TraceFile::eventsOf(const std::vector<Timeline::Section>& group)
{
	std::vector<Event> events;
	for (const Timeline::Section& section : group)
		events.push_back({&section, nanoseconds(section.start_ms), nanoseconds(section.start_ms + section.duration_ms),
		                  section.depth});
	const auto order = [](const Event& a, const Event& b)
	{ return a.begin != b.begin ? a.begin < b.begin : a.depth < b.depth; };
	std::ranges::stable_sort(events, order);
	const std::vector<Event> rests = restsOf(events);
	events.insert(events.end(), rests.begin(), rests.end());
	std::ranges::stable_sort(events, order);
	return events;
}

void TraceFile::writeGroup(std::uint32_t number, Row& row)
{
	for (Event& event : eventsOf(row.waiting))
	{
		// Sections of the CPU are nested as they are. The GPU's clock is held against the CPU's again and again, and
		// may differ by a little.
		while (!row.open.empty() && (event.begin >= row.open.back() || event.end > row.open.back()))
		{
			event.begin = std::max(event.begin, row.open.back());
			event.end = std::max(event.end, event.begin);
			row.open.pop_back();
		}
		row.open.push_back(event.end);
		writeEvent(number, event);
	}
	row.waiting.clear();
}

void TraceFile::writeEvent(std::uint32_t number, const Event& event)
{
	const Timeline::Section* section = event.section;
	startEvent();
	text_ += fmt::format(R"({{"name":{},"cat":"{}","ph":"X","pid":1,"tid":{},"ts":{},"dur":{})",
	                     section ? jsonText(section->name) : "\"other\"", categoryOf(section), number,
	                     microseconds(event.begin), microseconds(event.end - event.begin));
	if (section && section->cells > 0)
		text_ += fmt::format(R"(,"args":{{"cells":{}}})", section->cells);
	else if (section && section->frame != Timeline::kNoFrame)
		text_ += fmt::format(R"(,"args":{{"frame":{}}})", section->frame);
	text_ += '}';
	flushFull();
}

// A point of a flow belongs to the event that lies around it in its row; "bp" says so where the flow ends.
void TraceFile::writeMark(const Timeline::Mark& mark)
{
	startEvent();
	text_ += fmt::format(R"({{"name":"{}","cat":"{}","ph":"{}","pid":1,"tid":{},"ts":{})", mark.name,
	                     mark.kind == Timeline::Mark::Kind::counter ? "counter" : "flow", phaseOf(mark.kind), mark.row,
	                     microseconds(nanoseconds(mark.at_ms)));
	if (mark.kind == Timeline::Mark::Kind::counter)
		text_ += fmt::format(R"(,"args":{{"value":{}}}}})", mark.value);
	else
		text_ += fmt::format(R"(,"id":{}{}}})", mark.value,
		                     mark.kind == Timeline::Mark::Kind::flow_end ? R"(,"bp":"e")" : "");
	flushFull();
}

void TraceFile::writeName(const char* of, std::uint32_t number, const std::string& name)
{
	startEvent();
	text_ +=
	    fmt::format(R"({{"name":"{}","ph":"M","pid":1,"tid":{},"args":{{"name":{}}}}})", of, number, jsonText(name));
}

// Rows stand in the order of their numbers, not of their names.
void TraceFile::writeRow(std::uint32_t number)
{
	writeName("thread_name", number, rowName(number));
	startEvent();
	text_ +=
	    fmt::format(R"({{"name":"thread_sort_index","ph":"M","pid":1,"tid":{0},"args":{{"sort_index":{0}}}}})", number);
}

void TraceFile::startEvent()
{
	text_ += has_events_ ? ",\n" : "\n";
	has_events_ = true;
}

void TraceFile::flushFull()
{
	if (text_.size() < kBufferBytes)
		return;
	file_.write(text_);
	text_.clear();
}

Status TraceFile::commit()
{
	text_ += "\n],\"otherData\":{";
	for (std::size_t i = 0; i < about_.size(); ++i)
		text_ += fmt::format("{}\n{}:{}", i > 0 ? "," : "", jsonText(about_[i].first), jsonText(about_[i].second));
	file_.write(text_ + "\n}}\n");
	return file_.commit();
}

} // namespace vp::write
