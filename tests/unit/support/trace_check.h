#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace trace
{

// Holds a trace against the Trace Event Format: "complete" events, counters, flows and metadata are all that a file may
// have here.
struct Event
{
	std::string name;
	std::string category;
	std::int64_t begin; // ns
	std::int64_t end;
	std::uint64_t cells;
	int frame; // or -1
};

// A value of a counter.
struct Count
{
	std::int64_t at; // ns
	std::uint64_t value;
};

// A point of a flow.
struct FlowPoint
{
	char phase; // s, t or f
	std::int64_t at;
	std::string row;   // the name of its row
	std::string event; // the innermost event around it
};

struct Rows
{
	std::map<std::string, std::vector<Count>> counters;
	std::map<int, std::vector<FlowPoint>> flows; // by their numbers, in the order of time
	std::map<std::string, std::string> about;    // otherData
	std::map<int, std::string> names;
	std::map<int, std::vector<Event>> events; // events of each row, by their beginnings, outer ones first

	const std::vector<Event>& named(const std::string& name) const
	{
		static const std::vector<Event> none;
		for (const auto& [row, of_row] : names)
			if (of_row == name && events.contains(row))
				return events.at(row);
		return none;
	}
};

inline std::int64_t nanoseconds(const nlohmann::json& us)
{
	return std::llround(us.get<double>() * 1000.0);
}

inline void takeMetadata(const nlohmann::json& event, Rows& rows, int& processes)
{
	ASSERT_TRUE(event.contains("args") && event["args"].is_object()) << event;
	if (event["name"] == "thread_sort_index")
	{
		EXPECT_TRUE(event["args"]["sort_index"].is_number_integer()) << event;
		return;
	}
	ASSERT_TRUE(event["args"].contains("name") && event["args"]["name"].is_string()) << event;
	ASSERT_TRUE(event["name"] == "process_name" || event["name"] == "thread_name") << event;
	if (event["name"] == "process_name")
		++processes;
	else
		EXPECT_TRUE(rows.names.emplace(event["tid"], event["args"]["name"]).second) << "named twice: " << event;
}

inline void takeCounter(const nlohmann::json& event, Rows& rows)
{
	ASSERT_TRUE(event.contains("ts") && event["ts"].is_number() && event["ts"] >= 0.0) << event;
	ASSERT_TRUE(event.contains("args") && event["args"].size() == 1) << event;
	const nlohmann::json& value = *event["args"].begin();
	ASSERT_TRUE(value.is_number_unsigned()) << event;
	rows.counters[event["name"]].push_back({nanoseconds(event["ts"]), value});
}

// Its row and event are known later.
inline void takeFlowPoint(const nlohmann::json& event, Rows& rows, std::map<int, std::vector<int>>& rows_of_flows)
{
	for (const char* number : {"ts", "id"})
		ASSERT_TRUE(event.contains(number) && event[number].is_number()) << event;
	ASSERT_TRUE(event.contains("cat") && event["cat"] == "flow") << event;
	// Without it, the end of a flow belongs to the next event.
	EXPECT_EQ(event.value("bp", ""), event["ph"] == "f" ? "e" : "") << event;
	rows.flows[event["id"]].push_back({event["ph"].get<std::string>()[0], nanoseconds(event["ts"]), {}, {}});
	rows_of_flows[event["id"]].push_back(event["tid"]);
}

inline void takeComplete(const nlohmann::json& event, Rows& rows)
{
	for (const char* number : {"ts", "dur"})
	{
		ASSERT_TRUE(event.contains(number) && event[number].is_number()) << event;
		EXPECT_GE(event[number].get<double>(), 0.0) << event;
	}
	ASSERT_TRUE(event.contains("cat") && event["cat"].is_string()) << event;
	std::uint64_t cells = 0;
	int frame = -1;
	if (event.contains("args"))
	{
		ASSERT_TRUE(event["args"].is_object()) << event;
		cells = event["args"].value("cells", 0u);
		frame = event["args"].value("frame", -1);
	}
	const std::int64_t begin = nanoseconds(event["ts"]);
	rows.events[event["tid"]].push_back(
	    {event["name"], event["cat"], begin, begin + nanoseconds(event["dur"]), cells, frame});
}

inline void expectNested(const std::string& row, std::vector<Event>& events)
{
	std::ranges::stable_sort(events, [](const Event& a, const Event& b)
	                         { return a.begin != b.begin ? a.begin < b.begin : a.end > b.end; });
	std::vector<const Event*> open;
	for (const Event& event : events)
	{
		while (!open.empty() && open.back()->end <= event.begin)
			open.pop_back();
		if (!open.empty())
		{
			EXPECT_LE(event.end, open.back()->end)
			    << row << ": " << event.name << " begins within " << open.back()->name << " and ends after it";
		}
		open.push_back(&event);
	}
}

// Expects that each flow begins once, ends once, and has each of its points in an event.
inline void expectFlows(Rows& rows, const std::map<int, std::vector<int>>& rows_of_flows)
{
	for (auto& [flow, points] : rows.flows)
	{
		for (std::size_t p = 0; p < points.size(); ++p)
		{
			const int row = rows_of_flows.at(flow)[p];
			points[p].row = rows.names[row];
			for (const Event& event : rows.events[row]) // outer ones first
				if (event.begin <= points[p].at && points[p].at <= event.end && event.name != "other")
					points[p].event = event.name;
			EXPECT_NE(points[p].event, "") << "flow " << flow << " has a point in no event of " << points[p].row;
		}
		std::ranges::stable_sort(points, {}, &FlowPoint::at);
		std::string phases;
		for (const FlowPoint& point : points)
			phases += point.phase;
		EXPECT_TRUE(phases.size() >= 2 && phases.front() == 's' && phases.back() == 'f' &&
		            std::ranges::count(phases, 's') == 1 && std::ranges::count(phases, 'f') == 1)
		    << "flow " << flow << ": " << phases;
	}
}

// Fails the test where something is against the format; gives what is there.
inline Rows check(const std::string& text)
{
	Rows rows;
	const auto document = nlohmann::json::parse(text, nullptr, false);
	EXPECT_TRUE(document.is_object()) << text.substr(0, 300);
	if (!document.is_object() || !document.contains("traceEvents") || !document["traceEvents"].is_array())
	{
		ADD_FAILURE() << "no traceEvents";
		return rows;
	}
	EXPECT_TRUE(!document.contains("displayTimeUnit") || document["displayTimeUnit"] == "ms" ||
	            document["displayTimeUnit"] == "ns");
	int processes = 0;
	std::map<int, std::vector<int>> rows_of_flows;
	for (const nlohmann::json& event : document["traceEvents"])
	{
		const bool is_event = event.is_object() && event.contains("name") && event["name"].is_string() &&
		                      event.contains("pid") && event["pid"].is_number_integer() && event.contains("tid") &&
		                      event["tid"].is_number_integer();
		EXPECT_TRUE(is_event) << event;
		if (!is_event)
			return rows;
		const std::string phase = event.value("ph", "");
		if (phase == "M")
			takeMetadata(event, rows, processes);
		else if (phase == "X")
			takeComplete(event, rows);
		else if (phase == "C")
			takeCounter(event, rows);
		else if (phase == "s" || phase == "t" || phase == "f")
			takeFlowPoint(event, rows, rows_of_flows);
		else
			ADD_FAILURE() << "a phase that is not written: " << event;
	}
	EXPECT_EQ(processes, 1);
	for (auto& [row, events] : rows.events)
	{
		EXPECT_TRUE(rows.names.contains(row)) << "row " << row << " has no name";
		expectNested(rows.names[row], events);
	}
	expectFlows(rows, rows_of_flows);
	if (document.contains("otherData"))
		rows.about = document["otherData"].get<std::map<std::string, std::string>>();
	return rows;
}

// The events that lie in `outer` and in no other one of it, in order.
inline std::vector<Event> partsOf(const std::vector<Event>& row, const Event& outer)
{
	std::vector<Event> parts;
	std::int64_t told = outer.begin;
	for (const Event& event : row)
		if (&event != &outer && event.begin >= told && event.end <= outer.end && event.name != outer.name)
		{
			parts.push_back(event);
			told = event.end;
		}
	return parts;
}

// Expects that the events within an event, with "other", add up to it within a hundredth and ten microseconds.
inline void expectWhole(const std::vector<Event>& row, const Event& outer)
{
	std::int64_t sum = 0;
	std::string names;
	for (const Event& part : partsOf(row, outer))
	{
		sum += part.end - part.begin;
		names += part.name + " ";
	}
	const auto whole = static_cast<double>(outer.end - outer.begin);
	EXPECT_NEAR(static_cast<double>(sum), whole, 0.01 * whole + 10'000.0) << outer.name << ": " << names;
}

} // namespace trace
