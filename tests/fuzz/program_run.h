#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace fuzz
{

struct ProgramRun
{
	int exit_code = -1; // -1: ended by the signal
	int signal = 0;
	bool ran_out_of_time = false;
	std::uint64_t peak_bytes = 0; // resident, of the program or of the reader it started
	double seconds = 0.0;
	std::string out;
	std::string err;
};

// Runs a program to its end, or until the time is over. What it prints goes through files in `folder`. Callable from
// several threads.
ProgramRun runProgram(const std::vector<std::string>& command, const std::string& folder, std::chrono::seconds limit);

std::string contentsOf(const std::string& path);

} // namespace fuzz
