#pragma once

#include "program_run.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace fuzz
{

enum class Command
{
	slice, // with out/cut.vtp and out/stats.json
	info,  // with --json
	check  // with --json
};

// Returns what is wrong with a run on a damaged file, or nothing. An error must be exit code 2 and one line that
// starts with "vprobe: FILE"; success must come with figures that are numbers. `out` is the folder for its output and
// `memory_limit` the most bytes that it may have had.
std::string judge(Command command, const ProgramRun& run, const std::string& file, const std::filesystem::path& out,
                  std::uint64_t memory_limit);

} // namespace fuzz
