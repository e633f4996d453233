#pragma once

#include "base/result.h"
#include "base/section_use.h"
#include "gpu/device_speed.h"
#include "profile/touched_lines.h"
#include "session/frame.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// The most that this machine can do, measured beside a profile.
struct Floor
{
	double bytes_per_second = 0.0;            // read in sequence, by all threads that the program may use
	double line_ns = 0.0;                     // for each line of 64 bytes read at random, by all threads together
	std::optional<gpu::DeviceSpeed> device{}; // empty without one
};

// Measures at most some 0.2 s. device: or null.
Result<Floor> measureFloor(gpu::Device* device);

// The memory that the stages of a profile have touched on each plane, and the CPU time and what else they have used.
class StageWork
{
public:
	void addTouched(const grid::BlockSet& blocks, const session::Frame& frame,
	                std::size_t pixels);  // 0 without a picture
	void addUse(const SectionUses& uses); // for one plane
	void setWhyNoCounters(const std::string& why) { why_no_counters_ = why; }

	// Adds `floor` to a profile, and to its stages cpu_ms, cores, bytes, lines, runs, floor_ms, times_floor, bound_by,
	// page_faults, major_faults, instructions and cache_misses. Its `not_counted` says what is missing.
	void put(nlohmann::json& profile, const Floor& floor) const;

private:
	std::optional<Touched> medianTouched(const std::string& stage) const;
	double floorMs(const std::string& stage, const Floor& floor) const;

	std::size_t pixels_ = 0;
	std::map<std::string, std::vector<SectionUse>, std::less<>> uses_; // per plane
	std::string why_no_counters_;                                      // empty if there are counters
	std::map<std::string, std::vector<Touched>, std::less<>> touched_; // per plane
};

// Returns the table's lines about the floor; an empty text without one.
std::string floorText(const nlohmann::json& profile);

} // namespace vp::app
