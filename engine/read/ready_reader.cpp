#include "read/ready_reader.h"

#include "base/sanitized.h"
#include "read/protocol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

#include <fcntl.h>
#include <linux/sched.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

constexpr std::string_view kCopies = "copies"; // the only argument of a program that makes copies
constexpr std::size_t kMostBytes = 1 << 16;    // the longest order; others are for a program of its own
constexpr int kPatience = 10000;               // milliseconds to wait for a copy
constexpr int kWorthIt = 3;

// A message that asks for a copy, with these descriptors. The arguments stand behind it, each with a zero at its end.
struct Order
{
	pid_t parent;
	rlimit memory;
	rlimit file_size;
	rlimit time;
	rlimit files;
};
constexpr std::array kDescriptors = {&ChildSetup::null,   &ChildSetup::requests, &ChildSetup::errors,
                                     &ChildSetup::arrays, &ChildSetup::manifest, &ChildSetup::cells,
                                     &ChildSetup::life};

struct Message
{
	std::array<char, sizeof(Order) + kMostBytes> bytes;
	alignas(cmsghdr) std::array<char, CMSG_SPACE(kDescriptors.size() * sizeof(int))> descriptors;
};

std::string textOf(char* const* arguments)
{
	std::string text;
	for (; *arguments; ++arguments)
		text.append(*arguments, std::strlen(*arguments) + 1);
	return text;
}

bool send(int socket, const ChildSetup& setup, std::string& text)
{
	Order order = {setup.parent, setup.memory, setup.file_size, setup.time, setup.files};
	std::array<iovec, 2> parts = {iovec{&order, sizeof(order)}, iovec{text.data(), text.size()}};
	alignas(cmsghdr) decltype(Message::descriptors) descriptors = {};
	msghdr message = {};
	message.msg_iov = parts.data();
	message.msg_iovlen = parts.size();
	message.msg_control = descriptors.data();
	message.msg_controllen = descriptors.size();
	cmsghdr* const header = CMSG_FIRSTHDR(&message);
	header->cmsg_level = SOL_SOCKET;
	header->cmsg_type = SCM_RIGHTS;
	header->cmsg_len = CMSG_LEN(kDescriptors.size() * sizeof(int));
	for (std::size_t i = 0; i < kDescriptors.size(); ++i)
		std::memcpy(CMSG_DATA(header) + i * sizeof(int), &(setup.*kDescriptors[i]), sizeof(int));
	return sendmsg(socket, &message, MSG_NOSIGNAL) >= 0;
}

// Returns what the program answers: the number of the copy, a negative error of the system, or 0 if it does not answer.
pid_t answerOf(int socket)
{
	pollfd answer = {socket, POLLIN, 0};
	while (poll(&answer, 1, kPatience) < 0)
		if (errno != EINTR)
			return 0;
	pid_t pid = 0;
	return recv(socket, &pid, sizeof(pid), MSG_DONTWAIT) == sizeof(pid) ? pid : 0;
}

bool isOwnChild(pid_t pid)
{
	siginfo_t about = {};
	return waitid(P_PID, static_cast<id_t>(pid), &about, WEXITED | WNOHANG | WNOWAIT) == 0;
}

// fork() for a child of the parent of this process, which has one thread. Returns as fork() does.
pid_t forkForParent()
{
	// The C library keeps the number of the thread where the system clears it at the end of a thread.
	int* number = nullptr;
	if (prctl(PR_GET_TID_ADDRESS, &number, 0, 0, 0) != 0)
		return -1;
	clone_args how = {};
	how.flags = CLONE_PARENT | CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID;
	how.child_tid = reinterpret_cast<std::uintptr_t>(number);
	return static_cast<pid_t>(syscall(SYS_clone3, &how, sizeof(how)));
}

} // namespace

void ReadyReader::start(const ChildSetup& setup)
{
	is_started_ = true;
	parent_ = getpid();
	if (kThreadSanitized) // its own thread would be missing in a copy
		return;
	std::array<int, 2> ends = {-1, -1};
	if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
		return;
	Descriptor own = lifted(ends[0]);
	const Descriptor childs = lifted(ends[1]);
	std::string name(kCopies);
	std::array<char*, 3> arguments = {setup.arguments[0], name.data(), nullptr};
	if (!own || !childs)
		return;
	pid_ = fork();
	if (pid_ == 0)
		becomeReadyReader(setup, arguments.data(), childs.get());
	if (pid_ > 0)
		socket_ = std::move(own);
}

std::optional<pid_t> ReadyReader::copy(const ChildSetup& setup)
{
	if (!is_started_)
		start(setup);
	std::string text = textOf(setup.arguments);
	if (!socket_ || getpid() != parent_ || text.size() > kMostBytes)
		return {};
	const pid_t pid = send(socket_.get(), setup, text) ? answerOf(socket_.get()) : 0;
	if (pid > 0 && isOwnChild(pid))
		return pid;
	end();
	return {};
}

// A reader ends by itself when its socket closes. Any other program may not.
void ReadyReader::end()
{
	socket_.reset();
	kill(pid_, SIGKILL);
	while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR)
	{
	}
}

ReadyReader::~ReadyReader()
{
	if (socket_ && getpid() == parent_)
		end();
}

std::optional<pid_t> ReadyReaders::copy(const ChildSetup& setup)
{
	const std::lock_guard lock(mutex_);
	OfProgram& program = of_programs_[setup.program];
	return ++program.asked < kWorthIt ? std::nullopt : program.ready.copy(setup);
}

bool isAskedForCopies(int argument_count, char** arguments)
{
	return argument_count == 2 && arguments[1] == kCopies;
}

std::vector<std::string> makeCopies()
{
	// A copy expects descriptors with low numbers, so those that come must not have them.
	for (int low = STDERR_FILENO + 1; low <= kLifeFd; ++low)
		dup2(STDOUT_FILENO, low);
	static Message message;
	for (;;)
	{
		iovec bytes = {message.bytes.data(), message.bytes.size()};
		msghdr about = {};
		about.msg_iov = &bytes;
		about.msg_iovlen = 1;
		about.msg_control = message.descriptors.data();
		about.msg_controllen = message.descriptors.size();
		const ssize_t size = recvmsg(STDIN_FILENO, &about, MSG_CMSG_CLOEXEC);
		if (size < 0 && errno == EINTR)
			continue;
		const cmsghdr* const header = CMSG_FIRSTHDR(&about);
		if (size <= static_cast<ssize_t>(sizeof(Order)) || !header || header->cmsg_type != SCM_RIGHTS ||
		    header->cmsg_len != CMSG_LEN(kDescriptors.size() * sizeof(int)))
			_exit(0); // mostly since the parent has closed its end
		ChildSetup setup = {};
		for (std::size_t i = 0; i < kDescriptors.size(); ++i)
			std::memcpy(&(setup.*kDescriptors[i]), CMSG_DATA(header) + i * sizeof(int), sizeof(int));
		const pid_t pid = forkForParent();
		if (pid == 0)
		{
			Order order;
			std::memcpy(&order, message.bytes.data(), sizeof(order));
			setup.parent = order.parent;
			setup.memory = order.memory;
			setup.file_size = order.file_size;
			setup.time = order.time;
			setup.files = order.files;
			takeUp(setup);
			std::vector<std::string> arguments;
			const char* const end = message.bytes.data() + size;
			for (const char* at = message.bytes.data() + sizeof(order); at < end; at += arguments.back().size() + 1)
				arguments.emplace_back(at);
			return arguments;
		}
		for (const auto each : kDescriptors)
			close(setup.*each);
		const pid_t answer = pid < 0 ? -errno : pid;
		if (::send(STDIN_FILENO, &answer, sizeof(answer), MSG_NOSIGNAL) < 0)
			_exit(0);
	}
}

} // namespace vp::read
