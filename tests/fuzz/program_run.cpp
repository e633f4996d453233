#include "program_run.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fuzz
{

namespace
{

using Clock = std::chrono::steady_clock;

pid_t start(const std::vector<std::string>& command, const std::string& out, const std::string& err)
{
	std::vector<char*> arguments;
	for (const std::string& argument : command)
		arguments.push_back(const_cast<char*>(argument.c_str()));
	arguments.push_back(nullptr);
	posix_spawn_file_actions_t files;
	posix_spawn_file_actions_init(&files);
	posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
	posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
	posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
	pid_t pid = -1;
	const int error = posix_spawn(&pid, arguments[0], &files, nullptr, arguments.data(), environ);
	posix_spawn_file_actions_destroy(&files);
	if (error != 0)
		throw std::runtime_error(command[0] + ": " + std::strerror(error));
	return pid;
}

// False when the time is over first.
bool waitFor(pid_t pid, std::chrono::seconds limit)
{
	const int handle = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
	if (handle < 0)
		throw std::runtime_error(std::string("pidfd_open: ") + std::strerror(errno));
	const auto deadline = Clock::now() + limit;
	int ended = 0;
	while (ended == 0 && Clock::now() < deadline)
	{
		pollfd ready = {handle, POLLIN, 0};
		const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
		ended = std::max(0, poll(&ready, 1, static_cast<int>(std::max<long long>(left, 0))));
	}
	close(handle);
	return ended != 0;
}

} // namespace

std::string contentsOf(const std::string& path)
{
	std::ostringstream text;
	text << std::ifstream(path, std::ios::binary).rdbuf();
	return text.str();
}

ProgramRun runProgram(const std::vector<std::string>& command, const std::string& folder, std::chrono::seconds limit)
{
	ProgramRun run;
	const auto began = Clock::now();
	const pid_t pid = start(command, folder + "/stdout", folder + "/stderr");
	run.ran_out_of_time = !waitFor(pid, limit);
	if (run.ran_out_of_time)
		kill(pid, SIGKILL); // its reader dies with it
	int status = 0;
	rusage used = {};
	while (wait4(pid, &status, 0, &used) < 0 && errno == EINTR)
	{
	}
	run.seconds = std::chrono::duration<double>(Clock::now() - began).count();
	run.peak_bytes = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
	if (WIFSIGNALED(status))
		run.signal = WTERMSIG(status);
	else
		run.exit_code = WEXITSTATUS(status);
	run.out = contentsOf(folder + "/stdout");
	run.err = contentsOf(folder + "/stderr");
	return run;
}

} // namespace fuzz
