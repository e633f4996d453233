#pragma once

#include "base/result.h"
#include "read/mapping.h"

#include <chrono>
#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

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

// The two ends of a socket by which a child gets requests.
struct RequestEnds
{
	Descriptor own;
	Descriptor childs;
};
Result<RequestEnds> requestEnds(const std::string& file);

// For the system's functions, which take lists that end with null.
std::vector<char*> pointersTo(std::vector<std::string>& texts);

// Everything that a child needs between fork and exec, since it must not allocate there.
struct ChildSetup
{
	const char* program;
	char* const* arguments;   // ends with null
	char* const* environment; // likewise
	int null;
	int requests; // what it has as standard input
	int errors;
	int arrays;
	int manifest;
	int cells;
	int life; // the end of a pipe; the parent keeps the other one as long as it wants the child to live
	pid_t parent;
	rlimit memory;
	rlimit file_size;
	rlimit time;
	rlimit files;
};

// Gives this process, a child, what the setup says. Ends it if the parent is gone.
void takeUp(const ChildSetup& setup);
// Runs in the child after fork. If the program cannot be started, writes the reason to standard error and ends with
// exit code 127.
[[noreturn]] void becomeReader(const ChildSetup& setup);
// The same for a program with these arguments that has nothing but a socket, as standard input; see ready_reader.h.
[[noreturn]] void becomeReadyReader(const ChildSetup& setup, char* const* arguments, int socket);

// The child and its two pipes, until it has ended. Whoever forks this process leaves the child to it.
class Reader
{
public:
	// time: how long it may take, without that in which it waited for a processor.
	Reader(pid_t pid, Descriptor manifest, Descriptor errors, std::chrono::seconds time);
	~Reader();
	Reader(const Reader&) = delete;
	Reader& operator=(const Reader&) = delete;

	// The time counts from now on.
	void startAnew(std::chrono::seconds time);
	// Reads what the child writes until both pipes are closed and it has ended. Kills the child and returns false if
	// the time is over, if it writes too much, or if somebody asks it to stop.
	bool finish(const std::stop_token& stop);
	// Reads so many bytes from a child that stays. If it does not stay, ends as finish() does.
	enum class Answer
	{
		whole,
		ended,
		late
	};
	Answer answer(std::span<std::byte> to, const std::stop_token& stop);
	bool wroteTooMuch() const;

	std::string manifest;
	std::string errors; // the end of its standard error
	int status = 0;     // from waitpid()

private:
	bool mayGoOn(const std::stop_token& stop) const;
	void takeWhatComes();
	bool hasEnded() const;
	bool isLate() const;
	std::chrono::nanoseconds waitedForProcessor() const;
	void end();

	pid_t pid_;
	pid_t parent_;
	std::chrono::steady_clock::time_point deadline_{};
	std::chrono::nanoseconds waited_before_{0}; // for a processor, when the time began to count
	bool ended_ = false;
	Descriptor manifest_pipe_;
	Descriptor error_pipe_;
};

} // namespace vp::read
