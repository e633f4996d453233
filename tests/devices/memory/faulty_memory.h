#pragma once

#include "memory_calls.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vp::memory
{

/// The environment of a program that runs out of memory. fault: see failing_new.cpp. calls: a file that tells of the
/// calls.
inline std::map<std::string, std::string> faultyMemory(const std::string& fault, const std::string& calls)
{
	return {{"LD_PRELOAD", VPROBE_FAILING_NEW}, {"VPROBE_MEMORY_FAULT", fault}, {"VPROBE_MEMORY_CALLS", calls}};
}

/// Reads such a file. There are no calls if it is missing.
inline std::unique_ptr<MemoryCalls> toldCalls(const std::string& file)
{
	auto calls = std::make_unique<MemoryCalls>();
	std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(calls.get()), sizeof(MemoryCalls));
	calls->places = std::min<std::uint64_t>(calls->places, kMaxPlaces);
	return calls;
}

} // namespace vp::memory
