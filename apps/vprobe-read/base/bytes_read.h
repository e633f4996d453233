#pragma once

#include <cstdint>

// How many bytes this process has asked the system for by reading, since its start; of whatever file (rchar of
// /proc/self/io). What is mapped counts only where countMapped() says so. 0 where the system does not tell.
std::uint64_t bytesRead();

// Adds bytes that were taken from a mapped file.
void countMapped(std::uint64_t bytes);

// Begins to count anew. What was read before was the program itself.
void startCounting();
