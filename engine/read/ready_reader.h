#pragma once

#include "read/mapping.h"
#include "read/reader_process.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace vp::read
{

// A reader program whose libraries are linked, and that has looked at no file. It makes copies of itself. Each copy
// does what a program does that was started for one file, in a sandbox of its own, and is a child of this process.
// Most of a start is spent on the libraries: a copy takes some 1 ms, a start 20 (vprobe-read) or 100
// (vprobe-read-more).
class ReadyReader
{
public:
	ReadyReader() = default;
	~ReadyReader();
	ReadyReader(const ReadyReader&) = delete;
	ReadyReader& operator=(const ReadyReader&) = delete;

	// Starts the program at the first call. Returns the copy's number. Returns nothing where the system or the program
	// makes no copies, and in a process that was forked from the one of the first call; then a program must be started.
	std::optional<pid_t> copy(const ChildSetup& setup);

private:
	void start(const ChildSetup& setup);
	void end();

	bool is_started_ = false;
	pid_t parent_ = -1;
	pid_t pid_ = -1;
	Descriptor socket_; // empty once it is of no use
};

// Those of all programs that somebody starts, who may read one file, or many. Thread safe.
class ReadyReaders
{
public:
	// As ReadyReader::copy(), but a program gets ready only when it is asked for the third time: two are started side
	// by side in the time in which one gets ready.
	std::optional<pid_t> copy(const ChildSetup& setup);

private:
	struct OfProgram
	{
		int asked = 0;
		ReadyReader ready;
	};
	std::mutex mutex_;
	std::map<std::string, OfProgram> of_programs_;
};

// The other end, for main() of a reader program.
bool isAskedForCopies(int argument_count, char** arguments);
// Makes copies as long as the parent asks for some, then ends the process. Returns in each copy, with its arguments.
std::vector<std::string> makeCopies();

} // namespace vp::read
