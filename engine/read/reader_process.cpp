#include "read/reader_process.h"

#include "base/sanitized.h"
#include "read/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

using Clock = std::chrono::steady_clock;

// A manifest is about 200 bytes an array; 64 MiB describe more arrays than any program could show.
constexpr std::size_t kMaxManifestBytes = 64u << 20;
// Bytes of standard error that are kept. Only the last line is used.
constexpr std::size_t kKeptErrorBytes = 4096;
// Longest time in milliseconds until a stop request is noticed.
constexpr long long kLongestWait = 100;

// Sanitizers reserve terabytes of address space.
constexpr bool kLimitAddressSpace = !kSanitized;

void take(Descriptor& pipe, std::string& text)
{
	std::array<char, 65536> buffer;
	const ssize_t n = ::read(pipe.get(), buffer.data(), buffer.size());
	if (n > 0)
		text.append(buffer.data(), static_cast<std::size_t>(n));
	else if (n == 0 || errno != EINTR)
		pipe.reset();
}

// The system kills this process, and what it starts, when the other end of the pipe closes: at the latest when the
// parent ends. PR_SET_PDEATHSIG kills it when the thread ends that started it, so it serves only where there is no such
// signal.
void endWithPipe(int pipe, pid_t parent)
{
	const bool is_asked = fcntl(pipe, F_SETSIG, SIGKILL) == 0 && fcntl(pipe, F_SETOWN, -getpgrp()) == 0 &&
	                      fcntl(pipe, F_SETFL, O_ASYNC) == 0;
	if (!is_asked)
		prctl(PR_SET_PDEATHSIG, SIGKILL);
	pollfd closed = {pipe, 0, 0};
	if (getppid() != parent || poll(&closed, 1, 0) != 0)
		_exit(127);
}

// Ends this process with exit code 127 if it cannot become the program.
[[noreturn]] void execute(const char* program, char* const* arguments, char* const* environment)
{
	// The parent may have blocked or ignored signals, which exec would pass on.
	sigset_t no_signals;
	sigemptyset(&no_signals);
	sigprocmask(SIG_SETMASK, &no_signals, nullptr);
	std::signal(SIGPIPE, SIG_DFL);
	execve(program, arguments, environment);
	const char* why = std::strerror(errno);
	if (write(STDERR_FILENO, why, std::strlen(why)) < 0)
		_exit(127);
	_exit(127);
}

} // namespace

Descriptor lifted(int fd)
{
	Descriptor low(fd);
	return Descriptor(fd < 0 ? -1 : fcntl(fd, F_DUPFD_CLOEXEC, 10));
}

Pipe makePipe()
{
	std::array<int, 2> ends = {-1, -1};
	if (pipe2(ends.data(), O_CLOEXEC) != 0)
		return {};
	return {lifted(ends[0]), lifted(ends[1])};
}

Result<RequestEnds> requestEnds(const std::string& file)
{
	std::array<int, 2> ends = {-1, -1};
	// Not a pipe: whoever writes into a pipe that nobody reads any more gets a signal.
	if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
		return Error{ErrorKind::internal, fmt::format("{}: no socket for its reader ({})", file, std::strerror(errno))};
	return RequestEnds{lifted(ends[0]), lifted(ends[1])};
}

std::vector<char*> pointersTo(std::vector<std::string>& texts)
{
	std::vector<char*> pointers;
	for (std::string& text : texts)
		pointers.push_back(text.data());
	pointers.push_back(nullptr);
	return pointers;
}

void takeUp(const ChildSetup& setup)
{
	setpgid(0, 0); // so that whatever it starts can be ended with it
	dup2(setup.requests, STDIN_FILENO);
	dup2(setup.null, STDOUT_FILENO);
	dup2(setup.errors, STDERR_FILENO);
	dup2(setup.arrays, kArraysFd);
	dup2(setup.manifest, kManifestFd);
	dup2(setup.cells, kCellsFd);
	dup2(setup.life, kLifeFd);
	close_range(kCellsFd + 1, kLifeFd - 1, 0);
	close_range(kLifeFd + 1, UINT_MAX, 0);
	endWithPipe(kLifeFd, setup.parent);

	const rlimit none = {0, 0};
	setrlimit(RLIMIT_CORE, &none);
	setrlimit(RLIMIT_CPU, &setup.time);
	setrlimit(RLIMIT_FSIZE, &setup.file_size);
	setrlimit(RLIMIT_NOFILE, &setup.files);
	if (kLimitAddressSpace)
		setrlimit(RLIMIT_AS, &setup.memory);
	// Where memory runs out after all, this process is the one to go.
	if (const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0)
	{
		[[maybe_unused]] const ssize_t written = write(score, "1000", 4);
		close(score);
	}
}

void becomeReader(const ChildSetup& setup)
{
	takeUp(setup);
	execute(setup.program, setup.arguments, setup.environment);
}

void becomeReadyReader(const ChildSetup& setup, char* const* arguments, int socket)
{
	setpgid(0, 0); // so that a signal to the parent's group leaves it to the parent
	dup2(socket, STDIN_FILENO);
	dup2(setup.null, STDOUT_FILENO);
	dup2(setup.null, STDERR_FILENO);
	close_range(STDERR_FILENO + 1, UINT_MAX, 0);
	execute(setup.program, arguments, setup.environment);
}

Reader::Reader(pid_t pid, Descriptor manifest, Descriptor errors, std::chrono::seconds time)
    : pid_(pid), parent_(getpid()), manifest_pipe_(std::move(manifest)), error_pipe_(std::move(errors))
{
	startAnew(time);
}

Reader::~Reader()
{
	if (!ended_ && getpid() == parent_)
		end();
}

void Reader::startAnew(std::chrono::seconds time)
{
	deadline_ = Clock::now() + time;
	waited_before_ = waitedForProcessor();
}

// A program on a busy machine may wait longer for a processor than it runs. 0 where the system does not tell.
std::chrono::nanoseconds Reader::waitedForProcessor() const
{
	std::ifstream about("/proc/" + std::to_string(pid_) + "/schedstat");
	long long ran = 0, waited = 0;
	return std::chrono::nanoseconds(about >> ran >> waited ? waited : 0);
}

bool Reader::isLate() const
{
	const auto now = Clock::now();
	return now > deadline_ && now > deadline_ + (waitedForProcessor() - waited_before_);
}

bool Reader::mayGoOn(const std::stop_token& stop) const
{
	return !isLate() && !wroteTooMuch() && !stop.stop_requested();
}

void Reader::takeWhatComes()
{
	std::array<pollfd, 2> ready = {pollfd{manifest_pipe_.get(), POLLIN, 0}, pollfd{error_pipe_.get(), POLLIN, 0}};
	const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
	poll(ready.data(), ready.size(),
	     static_cast<int>(left > 0 ? std::min<long long>(left, kLongestWait) : kLongestWait));
	if (ready[0].revents)
		take(manifest_pipe_, manifest);
	if (ready[1].revents)
	{
		take(error_pipe_, errors);
		if (errors.size() > 2 * kKeptErrorBytes)
			errors.erase(0, errors.size() - kKeptErrorBytes);
	}
}

Reader::Answer Reader::answer(std::span<std::byte> to, const std::stop_token& stop)
{
	while (manifest.size() < to.size())
	{
		if (!mayGoOn(stop))
		{
			end();
			return Answer::late;
		}
		takeWhatComes();
		if (!manifest_pipe_ && manifest.size() < to.size())
			return finish(stop) ? Answer::ended : Answer::late;
	}
	std::memcpy(to.data(), manifest.data(), to.size());
	manifest.erase(0, to.size());
	return Answer::whole;
}

bool Reader::finish(const std::stop_token& stop)
{
	while (manifest_pipe_ || error_pipe_)
	{
		if (!mayGoOn(stop))
		{
			end();
			return false;
		}
		takeWhatComes();
	}
	while (!hasEnded())
	{
		if (isLate() || stop.stop_requested())
		{
			end();
			return false;
		}
		std::this_thread::sleep_for(std::chrono::microseconds(200));
	}
	end();
	return true;
}

bool Reader::wroteTooMuch() const
{
	return manifest.size() > kMaxManifestBytes;
}

bool Reader::hasEnded() const
{
	siginfo_t about = {};
	return waitid(P_PID, static_cast<id_t>(pid_), &about, WEXITED | WNOHANG | WNOWAIT) != 0 || about.si_pid == pid_;
}

// Ends what still runs of the child and of what it started. Only the wait lets go of its number, so nobody else is
// hit.
void Reader::end()
{
	kill(-pid_, SIGKILL);
	kill(pid_, SIGKILL); // where it has no group of its own yet
	while (waitpid(pid_, &status, 0) < 0 && errno == EINTR)
	{
	}
	ended_ = true;
}

} // namespace vp::read
