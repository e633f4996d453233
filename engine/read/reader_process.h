#pragma once

#include "read/mapping.h"

#include <array>
#include <chrono>
#include <stop_token>
#include <string>

#include <sys/resource.h>
#include <sys/types.h>

namespace vp::read
{

struct Pipe
{
	Descriptor read_end;
	Descriptor write_end;
};

// Duplicates of descriptors, with numbers above those that the child expects. So passing them on overwrites none.
// `lifted` takes over its argument. Both are empty if the system refuses.
Descriptor lifted(int fd);
Pipe makePipe();

// Everything that a child needs between fork and exec, since it must not allocate there.
struct ChildSetup
{
	const char* program;
	std::array<char*, 17> arguments; // ends with null
	char* const* environment;        // likewise
	int null;
	int errors;
	int arrays;
	int manifest;
	int cells;
	pid_t parent;
	rlimit memory;
	rlimit file_size;
	rlimit time;
};

// Runs in the child after fork. If the program cannot be started, writes the reason to standard error and ends with
// exit code 127.
[[noreturn]] void becomeReader(const ChildSetup& setup);

// The child and its two pipes, until it has ended.
class Reader
{
public:
	Reader(pid_t pid, Descriptor manifest, Descriptor errors)
	    : pid_(pid), manifest_pipe_(std::move(manifest)), error_pipe_(std::move(errors))
	{
	}
	~Reader()
	{
		if (!ended_)
			end();
	}
	Reader(const Reader&) = delete;
	Reader& operator=(const Reader&) = delete;

	// Reads what the child writes until both pipes are closed and it has ended. Kills the child and returns false if
	// the time is over, without that in which it waited for a processor, if it writes too much, or if somebody asks it
	// to stop.
	bool finish(std::chrono::steady_clock::time_point deadline, const std::stop_token& stop = {});
	bool wroteTooMuch() const;

	std::string manifest;
	std::string errors; // the end of its standard error
	int status = 0;     // from waitpid()

private:
	bool hasEnded() const;
	bool isLate(std::chrono::steady_clock::time_point deadline) const;
	std::chrono::nanoseconds waitedForProcessor() const;
	void end();

	pid_t pid_;
	bool ended_ = false;
	Descriptor manifest_pipe_;
	Descriptor error_pipe_;
};

} // namespace vp::read
