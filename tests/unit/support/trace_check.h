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

// Holds a trace against the Trace Event Format: "complete" events and metadata are all that a file may have here.
struct Event
{
	std::string name;
	std::string category;
	std::int64_t begin; // ns
	std::int64_t end;
	std::uint64_t cells;
};

struct Rows
{
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

inline void takeMetadata(const nlohmann::json& event, Rows& rows, int& processes)
{
	ASSERT_TRUE(event.contains("args") && event["args"].is_object()) << event;
	ASSERT_TRUE(event["args"].contains("name") && event["args"]["name"].is_string()) << event;
	ASSERT_TRUE(event["name"] == "process_name" || event["name"] == "thread_name") << event;
	if (event["name"] == "process_name")
		++processes;
	else
		EXPECT_TRUE(rows.names.emplace(event["tid"], event["args"]["name"]).second) << "named twice: " << event;
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
	if (event.contains("args"))
	{
		ASSERT_TRUE(event["args"].is_object()) << event;
		cells = event["args"].value("cells", 0u);
	}
	const double ts = event["ts"];
	const double dur = event["dur"];
	const std::int64_t begin = std::llround(ts * 1000.0);
	rows.events[event["tid"]].push_back(
	    {event["name"], event["cat"], begin, begin + std::llround(dur * 1000.0), cells});
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
	for (const nlohmann::json& event : document["traceEvents"])
	{
		const bool is_event = event.is_object() && event.contains("name") && event["name"].is_string() &&
		                      event.contains("pid") && event["pid"].is_number_integer() && event.contains("tid") &&
		                      event["tid"].is_number_integer();
		EXPECT_TRUE(is_event) << event;
		if (!is_event)
			return rows;
		if (event.value("ph", "") == "M")
			takeMetadata(event, rows, processes);
		else if (event.value("ph", "") == "X")
			takeComplete(event, rows);
		else
			ADD_FAILURE() << "a phase that is not written: " << event;
	}
	EXPECT_EQ(processes, 1);
	for (auto& [row, events] : rows.events)
	{
		EXPECT_TRUE(rows.names.contains(row)) << "row " << row << " has no name";
		expectNested(rows.names[row], events);
	}
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
