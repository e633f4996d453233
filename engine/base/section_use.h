#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace vp
{

// The use of the whole process, all threads together, while sections of work ran (timeline.h), the sections in them
// included.
struct SectionUse
{
	double cpu_ms = 0.0;
	double page_faults = 0.0;  // pages of memory that were not there yet, and needed no file
	double major_faults = 0.0; // pages that were read from a file
	double instructions = 0.0; // 0 if they are not counted
	double cache_misses = 0.0; // those of the last cache; 0 if they are not counted
};
using SectionUses = std::map<std::string, SectionUse, std::less<>>; // by the name of a section

// While one lives, the use of sections is counted. It costs some calls of the system at both ends of each section. It
// belongs to the process, as the clock does: so only one profile at a time may have one.
class SectionMeter
{
public:
	SectionMeter();
	~SectionMeter();
	SectionMeter(const SectionMeter&) = delete;
	SectionMeter& operator=(const SectionMeter&) = delete;

	// Returns the uses since the last call.
	SectionUses take();
	// Why instructions and cache misses are not counted; empty if they are.
	const std::string& whyNoCounters() const;
};

// A timeline calls these at the ends of each section.
void beginUse();
void endUse(std::string_view name);

} // namespace vp
