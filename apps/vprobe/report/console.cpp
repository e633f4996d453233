#include "report/console.h"

#include "base/control_letters.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <ctime>

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

namespace vp::app
{

namespace
{

std::string program_name = "vprobe";

// A key of settings: what else stands between backquotes, as a part of a file's name, is none.
bool isKey(std::string_view text)
{
	return !text.empty() && text.front() >= 'a' && text.front() <= 'z' &&
	       std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

// While one lives, writing to a pipe that nobody reads raises no signal in this thread.
class GuardedPipe
{
public:
	GuardedPipe()
	{
		sigemptyset(&pipe_);
		sigaddset(&pipe_, SIGPIPE);
		sigset_t waiting;
		sigpending(&waiting);
		waited_ = sigismember(&waiting, SIGPIPE) == 1;
		pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
	}
	~GuardedPipe()
	{
		constexpr timespec at_once{0, 0};
		while (!waited_ && sigtimedwait(&pipe_, nullptr, &at_once) < 0 && errno == EINTR)
			;
		pthread_sigmask(SIG_SETMASK, &before_, nullptr);
	}
	GuardedPipe(const GuardedPipe&) = delete;
	GuardedPipe& operator=(const GuardedPipe&) = delete;

private:
	sigset_t pipe_;
	sigset_t before_;
	bool waited_;
};

} // namespace

std::string withOptionNames(std::string_view message)
{
	std::string text;
	for (;;)
	{
		const std::size_t begin = message.find('`');
		const std::size_t end = begin == message.npos ? message.npos : message.find('`', begin + 1);
		if (end == message.npos)
			return text.append(message);
		const std::string_view key = message.substr(begin + 1, end - begin - 1);
		if (isKey(key))
		{
			text.append(message.substr(0, begin)).append("--").append(key);
			std::replace(text.end() - static_cast<std::ptrdiff_t>(key.size()), text.end(), '_', '-');
			message.remove_prefix(end + 1);
		}
		else
		{
			text.append(message.substr(0, end)); // the second one may begin a key
			message.remove_prefix(end);
		}
	}
}

void setProgramName(std::string name)
{
	program_name = std::move(name);
}

void printLine(std::string_view line)
{
	printError(fmt::format("{}: {}\n", program_name, withEscapes(withOptionNames(line))));
}

void printError(std::string_view text)
{
	const GuardedPipe guard;
	while (!text.empty())
	{
		const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
		if (written < 0 && errno == EINTR)
			continue;
		if (written <= 0)
			return;
		text.remove_prefix(static_cast<std::size_t>(written));
	}
}

Status flushOutput()
{
	if (std::fflush(stdout) == 0 && !std::ferror(stdout))
		return Nothing{};
	return Error{ErrorKind::output, "standard output: cannot be written; make room or choose another place"};
}

void fillClosedStreams()
{
	for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
		if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
		{
			// The lowest free number is this one.
			const int nothing = ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
			if (nothing >= 0 && nothing != stream)
				::close(nothing);
		}
}

} // namespace vp::app
