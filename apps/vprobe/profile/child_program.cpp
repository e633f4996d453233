#include "profile/child_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vp::app
{

Result<ChildProgram> ChildProgram::start(const std::string& program, const std::vector<std::string>& arguments)
{
	std::vector<const char*> words{program.c_str()};
	for (const std::string& argument : arguments)
		words.push_back(argument.c_str());
	words.push_back(nullptr);
	ChildProgram child;
	std::array<int, 2> ends;
	// A socket, not pipes: send() can do without the signal that a pipe to an ended program raises.
	if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
		return Error{ErrorKind::output, fmt::format("{}: cannot be connected; close other programs", program)};
	child.socket_ = ends[1];
	child.errors_ = memfd_create("errors", MFD_CLOEXEC);
	posix_spawn_file_actions_t actions;
	posix_spawn_file_actions_init(&actions);
	posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
	posix_spawn_file_actions_adddup2(&actions, ends[0], STDOUT_FILENO);
	posix_spawn_file_actions_adddup2(&actions, child.errors_, STDERR_FILENO);
	const int failed = posix_spawn(&child.process_, program.c_str(), &actions, nullptr,
	                               const_cast<char* const*>(words.data()), environ);
	posix_spawn_file_actions_destroy(&actions);
	close(ends[0]);
	if (failed == 0)
		return child;
	child.process_ = -1;
	return Error{ErrorKind::input, fmt::format("{}: cannot be run ({}); name a program", program, strerror(failed))};
}

ChildProgram::ChildProgram(ChildProgram&& other) noexcept
    : process_(std::exchange(other.process_, -1)), socket_(std::exchange(other.socket_, -1)),
      errors_(std::exchange(other.errors_, -1)), heard_(std::move(other.heard_))
{
}

ChildProgram::~ChildProgram()
{
	if (process_ > 0)
	{
		kill(process_, SIGTERM);
		end();
	}
	for (const int descriptor : {socket_, errors_})
		if (descriptor >= 0)
			close(descriptor);
}

void ChildProgram::say(std::string_view text) const
{
	while (!text.empty())
	{
		const ssize_t sent = send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
		if (sent < 0 && errno == EINTR)
			continue;
		if (sent <= 0)
			return;
		text.remove_prefix(static_cast<std::size_t>(sent));
	}
}

std::optional<std::string> ChildProgram::hearLine()
{
	std::array<char, 4096> buffer;
	std::size_t end = heard_.find('\n');
	while (end == heard_.npos)
	{
		const ssize_t received = ::read(socket_, buffer.data(), buffer.size());
		if (received < 0 && errno == EINTR)
			continue;
		if (received <= 0)
			return std::nullopt;
		heard_.append(buffer.data(), static_cast<std::size_t>(received));
		end = heard_.find('\n');
	}
	std::string line = heard_.substr(0, end);
	heard_.erase(0, end + 1);
	return line;
}

std::string ChildProgram::hearAll()
{
	std::string all;
	while (const std::optional<std::string> line = hearLine())
		all += *line + "\n";
	return all + std::exchange(heard_, {});
}

ChildProgram::End ChildProgram::end()
{
	shutdown(socket_, SHUT_WR);
	int status = 0;
	while (process_ > 0 && waitpid(process_, &status, 0) < 0 && errno == EINTR)
		;
	process_ = -1;
	return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), saidOnErrors()};
}

std::vector<std::string> ChildProgram::saidOnErrors() const
{
	std::string text;
	std::array<char, 4096> buffer;
	for (ssize_t got; (got = pread(errors_, buffer.data(), buffer.size(), static_cast<off_t>(text.size()))) > 0;)
		text.append(buffer.data(), static_cast<std::size_t>(got));
	std::vector<std::string> lines;
	for (std::size_t begin = 0; begin < text.size();)
	{
		const std::size_t end = std::min(text.find('\n', begin), text.size());
		lines.push_back(text.substr(begin, end - begin));
		begin = end + 1;
	}
	return lines;
}

} // namespace vp::app
