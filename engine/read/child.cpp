#include "read/child.h"

#include "read/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

using Clock = std::chrono::steady_clock;

// A manifest is about 200 bytes an array; 64 MiB describe more arrays than any program could show.
constexpr std::size_t kMaxManifestBytes = 64u << 20;
// Of standard error, only the last line is used.
constexpr std::size_t kKeptErrorBytes = 4096;
constexpr std::size_t kMaxReasonLength = 300;

// Sanitizers reserve terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitAddressSpace = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kLimitAddressSpace = false;
#else
constexpr bool kLimitAddressSpace = true;
#endif
#else
constexpr bool kLimitAddressSpace = true;
#endif

struct Pipe
{
	Descriptor read_end;
	Descriptor write_end;
};

// Descriptors above those the child is to find its own under, so that handing them down overwrites none.
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

struct ChildSetup
{
	const char* program;
	std::array<char*, 7> arguments;
	int null;
	int errors;
	int arrays;
	int manifest;
	int cells;
	pid_t parent;
	rlimit memory;
	rlimit time;
};

// Between fork and exec: only calls that are safe there.
[[noreturn]] void becomeReader(const ChildSetup& setup)
{
	setpgid(0, 0); // so that whatever it starts can be ended with it
	prctl(PR_SET_PDEATHSIG, SIGKILL);
	if (getppid() != setup.parent)
		_exit(127);
	dup2(setup.null, STDIN_FILENO);
	dup2(setup.null, STDOUT_FILENO);
	dup2(setup.errors, STDERR_FILENO);
	dup2(setup.arrays, kArraysFd);
	dup2(setup.manifest, kManifestFd);
	dup2(setup.cells, kCellsFd);
	close_range(kCellsFd + 1, UINT_MAX, 0);

	const rlimit none = {0, 0};
	setrlimit(RLIMIT_CORE, &none);
	setrlimit(RLIMIT_CPU, &setup.time);
	setrlimit(RLIMIT_FSIZE, &setup.memory);
	if (kLimitAddressSpace)
		setrlimit(RLIMIT_AS, &setup.memory);
	// Where memory runs out after all, this process is the one to go.
	if (const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0)
	{
		[[maybe_unused]] const ssize_t written = write(score, "1000", 4);
		close(score);
	}
	// The parent may have blocked or ignored signals, which exec would pass on.
	sigset_t no_signals;
	sigemptyset(&no_signals);
	sigprocmask(SIG_SETMASK, &no_signals, nullptr);
	std::signal(SIGPIPE, SIG_DFL);
	execv(setup.program, setup.arguments.data());
	const char* why = std::strerror(errno);
	if (write(STDERR_FILENO, why, std::strlen(why)) < 0)
		_exit(127);
	_exit(127);
}

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
	// the time is over or it writes too much.
	bool finish(Clock::time_point deadline)
	{
		while (manifest_pipe_ || error_pipe_)
		{
			std::array<pollfd, 2> ready = {pollfd{manifest_pipe_.get(), POLLIN, 0},
			                               pollfd{error_pipe_.get(), POLLIN, 0}};
			const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
			if (left <= 0 || manifest.size() > kMaxManifestBytes)
			{
				end();
				return false;
			}
			poll(ready.data(), ready.size(), static_cast<int>(std::min<long long>(left, 1000)));
			if (ready[0].revents)
				take(manifest_pipe_, manifest);
			if (ready[1].revents)
			{
				take(error_pipe_, errors);
				if (errors.size() > 2 * kKeptErrorBytes)
					errors.erase(0, errors.size() - kKeptErrorBytes);
			}
		}
		while (!hasEnded())
		{
			if (Clock::now() > deadline)
			{
				end();
				return false;
			}
			std::this_thread::sleep_for(std::chrono::microseconds(200));
		}
		end();
		return true;
	}

	std::string manifest;
	std::string errors;
	int status = 0;

private:
	bool hasEnded() const
	{
		siginfo_t about = {};
		return waitid(P_PID, static_cast<id_t>(pid_), &about, WEXITED | WNOHANG | WNOWAIT) != 0 || about.si_pid == pid_;
	}

	// Ends what still runs of the child and of what it started. Only the wait lets go of its number, so nobody else is
	// hit.
	void end()
	{
		kill(-pid_, SIGKILL);
		kill(pid_, SIGKILL); // where it has no group of its own yet
		while (waitpid(pid_, &status, 0) < 0 && errno == EINTR)
		{
		}
		ended_ = true;
	}

	static void take(Descriptor& pipe, std::string& text)
	{
		std::array<char, 65536> buffer;
		const ssize_t n = ::read(pipe.get(), buffer.data(), buffer.size());
		if (n > 0)
			text.append(buffer.data(), static_cast<std::size_t>(n));
		else if (n == 0 || errno != EINTR)
			pipe.reset();
	}

	pid_t pid_;
	bool ended_ = false;
	Descriptor manifest_pipe_;
	Descriptor error_pipe_;
};

std::string lastLine(std::string_view text)
{
	while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
		text.remove_suffix(1);
	if (const auto line_end = text.rfind('\n'); line_end != text.npos)
		text.remove_prefix(line_end + 1);
	std::string line(text.substr(0, kMaxReasonLength + kReasonMark.size()));
	std::replace_if(
	    line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
	return line;
}

Error notStarted(const std::string& why)
{
	return {ExitCode::output, fmt::format("vprobe-read cannot be started: {}", why)};
}

// What the child's end means for the user.
Error explain(const std::string& file, const Reader& reader, const InputLimits& limits)
{
	const auto input = [&](const std::string& reason) {
		return Error{ExitCode::input, fmt::format("{}: {}", file, reason)};
	};
	const std::string line = lastLine(reader.errors);
	if (WIFSIGNALED(reader.status))
	{
		const int signal = WTERMSIG(reader.status);
		if (signal == SIGXCPU)
			return input(fmt::format("the reader ran over its time limit of {} s", limits.time.count()));
		return input(
		    fmt::format("the reader crashed (signal {}); the file is damaged or not what its ending says", signal));
	}
	const int code = WEXITSTATUS(reader.status);
	if (code == kRefusedExitCode && line.starts_with(kReasonMark) && line.size() > kReasonMark.size())
		return input(line.substr(kReasonMark.size()));
	if (code == 127)
		return notStarted(line);
	return input(
	    fmt::format("the reader gave up (exit code {}); the file is damaged or not what its ending says", code));
}

std::string timeArgument(const TimeChoice& time)
{
	switch (time.kind)
	{
	case TimeChoice::Kind::first:
		return "first";
	case TimeChoice::Kind::value:
		return fmt::format("{:.17g}", time.value);
	case TimeChoice::Kind::index:
		return fmt::format("#{}", time.index);
	default:
		return "last";
	}
}

rlimit limitOf(std::uint64_t value, int resource)
{
	rlimit limit = {};
	getrlimit(static_cast<__rlimit_resource>(resource), &limit);
	limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(value, limit.rlim_max);
	return limit;
}

} // namespace

Result<HandedOver> runReader(const std::string& file, const ReadOptions& options, const InputLimits& limits)
{
	const Result<std::string> program = readerProgram();
	if (!program)
		return program.error();

	const Descriptor arrays = lifted(memfd_create("vprobe-arrays", MFD_CLOEXEC | MFD_ALLOW_SEALING));
	const Descriptor cells = lifted(memfd_create("vprobe-cells", MFD_CLOEXEC | MFD_ALLOW_SEALING));
	const Descriptor null = lifted(open("/dev/null", O_RDWR | O_CLOEXEC));
	Pipe manifest = makePipe();
	Pipe errors = makePipe();
	if (!arrays || !cells || !null || !manifest.write_end || !errors.write_end)
		return notStarted(std::strerror(errno));

	std::string name = "vprobe-read";
	std::string time = timeArgument(options.time);
	std::string solution = options.solution;
	std::string refine = std::to_string(options.refine);
	std::string path = file;
	std::string displace = fmt::format("{:.17g}", options.displace);
	ChildSetup setup = {};
	setup.program = program->c_str();
	setup.arguments = {name.data(), time.data(), solution.data(), refine.data(), displace.data(), path.data(), nullptr};
	setup.null = null.get();
	setup.errors = errors.write_end.get();
	setup.arrays = arrays.get();
	setup.manifest = manifest.write_end.get();
	setup.cells = cells.get();
	setup.parent = getpid();
	setup.memory = limitOf(limits.memory, RLIMIT_AS);
	// A stalled disk shows on the wall clock only; this one ends a child whose parent was stopped.
	setup.time = limitOf(2 * static_cast<std::uint64_t>(limits.time.count()), RLIMIT_CPU);

	const auto deadline = Clock::now() + limits.time;
	const pid_t pid = fork();
	if (pid < 0)
		return notStarted(std::strerror(errno));
	if (pid == 0)
		becomeReader(setup);

	Reader reader(pid, std::move(manifest.read_end), std::move(errors.read_end));
	manifest.write_end.reset();
	errors.write_end.reset();
	if (!reader.finish(deadline))
	{
		const char* reason = reader.manifest.size() > kMaxManifestBytes ? "describes more arrays than can be"
		                                                                : "the reader ran over its time limit of {} s";
		return Error{ExitCode::input,
		             fmt::format("{}: {}", file, fmt::format(fmt::runtime(reason), limits.time.count()))};
	}
	if (!WIFEXITED(reader.status) || WEXITSTATUS(reader.status) != 0)
		return explain(file, reader, limits);

	HandedOver handed{std::move(reader.manifest), mapSealed(arrays), mapSealed(cells)};
	if (!handed.arrays.owner || !handed.cells.owner)
		return Error{ExitCode::input,
		             fmt::format("{}: the reader's arrays cannot be mapped: {}", file, std::strerror(errno))};
	return handed;
}

} // namespace vp::read
