#pragma once

#include <cstdint>

namespace vp::reader
{

// Returns how many bytes this process has read from files since its start (rchar of /proc/self/io). Mapped bytes count
// only if countMapped() adds them. Returns 0 if the system does not say it.
std::uint64_t bytesRead();

// Adds bytes that were taken from a mapped file.
void countMapped(std::uint64_t bytes);

// Begins to count anew. Before this, the process has read only the program itself.
void startCounting();

} // namespace vp::reader
