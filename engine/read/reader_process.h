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

// Descriptors above those the child is to find its own under, so that handing them down overwrites none. `lifted` takes
// the descriptor it is given; neither holds anything where the system refuses.
Descriptor lifted(int fd);
Pipe makePipe();

// All that a child needs between fork and exec, where nothing may be allocated.
struct ChildSetup
{
	const char* program;
	std::array<char*, 10> arguments; // ends with null
	int null;
	int errors;
	int arrays;
	int manifest;
	int cells;
	pid_t parent;
	rlimit memory;
	rlimit time;
};

// In the child, after fork. Ends with exit code 127, and why on standard error, where the program cannot be started.
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

	// Takes in what the child writes until both pipes are closed and it has ended; false, with the child killed, when
	// the time is over, it writes too much or it is asked to stop.
	bool finish(std::chrono::steady_clock::time_point deadline, const std::stop_token& stop = {});
	bool wroteTooMuch() const;

	std::string manifest;
	std::string errors; // the last of them
	int status = 0;     // as waitpid() gives it

private:
	bool hasEnded() const;
	void end();

	pid_t pid_;
	bool ended_ = false;
	Descriptor manifest_pipe_;
	Descriptor error_pipe_;
};

} // namespace vp::read
