#include "seccomp.h"

#include "door.h"
#include "read/protocol.h"

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <asm/ioctls.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace vp::reader::door
{

namespace
{

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0; // no filter is made
#endif

// Harmless calls: they read, take memory, run threads, or tell of this process. Those with a condition are in
// addConditions().
constexpr int kAllowed[] = {
#define VP_CALL(NAME) SYS_##NAME,
#include "allowed_calls.inl"
#undef VP_CALL
};

constexpr std::uint32_t kAllow = SECCOMP_RET_ALLOW;

constexpr std::uint32_t refuseWith(int error)
{
	return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error);
}

using Code = std::vector<sock_filter>;

sock_filter answer(std::uint32_t what)
{
	return BPF_STMT(BPF_RET | BPF_K, what);
}

sock_filter load(std::size_t offset)
{
	return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

// The lower or upper half of an argument.
sock_filter loadArgument(unsigned index, bool upper = false)
{
	const bool is_second = upper == (std::endian::native == std::endian::little);
	return load(offsetof(seccomp_data, args) + index * sizeof(std::uint64_t) + (is_second ? 4 : 0));
}

sock_filter jumpIf(std::uint16_t test, std::uint32_t value, unsigned steps_if, unsigned steps_else)
{
	return BPF_JUMP(static_cast<std::uint16_t>(BPF_JMP | test | BPF_K), value, static_cast<std::uint8_t>(steps_if),
	                static_cast<std::uint8_t>(steps_else));
}

// Conditions are codes that end with an answer.

Code anyOf(unsigned argument, std::initializer_list<std::uint32_t> values, int error)
{
	Code code = {loadArgument(argument)};
	auto left = static_cast<unsigned>(values.size());
	for (const std::uint32_t value : values)
		code.push_back(jumpIf(BPF_JEQ, value, left--, 0));
	code.push_back(answer(refuseWith(error)));
	code.push_back(answer(kAllow));
	return code;
}

Code noneOf(unsigned argument, std::uint32_t bits)
{
	return {loadArgument(argument), jumpIf(BPF_JSET, bits, 0, 1), answer(refuseWith(EACCES)), answer(kAllow)};
}

// Memory that is both written and run, and memory without a file that is run.
Code notRunIfWritten()
{
	return {loadArgument(2), jumpIf(BPF_JSET, PROT_EXEC, 0, 4),     jumpIf(BPF_JSET, PROT_WRITE, 2, 0),
	        loadArgument(3), jumpIf(BPF_JSET, MAP_ANONYMOUS, 0, 1), answer(refuseWith(EACCES)),
	        answer(kAllow)};
}

// Threads of this process, but no processes and no namespaces.
Code onlyThreads()
{
	constexpr std::uint32_t kNamespaces =
	    CLONE_NEWCGROUP | CLONE_NEWIPC | CLONE_NEWNET | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWUSER | CLONE_NEWUTS;
	return {loadArgument(0), BPF_STMT(BPF_ALU | BPF_AND | BPF_K, CLONE_THREAD | kNamespaces),
	        jumpIf(BPF_JEQ, CLONE_THREAD, 1, 0), answer(refuseWith(EACCES)), answer(kAllow)};
}

// Its own limits can be asked for, and the one on open files raised.
Code ownLimits()
{
	return {loadArgument(0),
	        jumpIf(BPF_JEQ, 0, 0, 6),
	        loadArgument(1),
	        jumpIf(BPF_JEQ, RLIMIT_NOFILE, 5, 0),
	        loadArgument(2),
	        jumpIf(BPF_JEQ, 0, 0, 2),
	        loadArgument(2, true),
	        jumpIf(BPF_JEQ, 0, 1, 0),
	        answer(refuseWith(EACCES)),
	        answer(kAllow)};
}

// The pipe that ends this process with its parent stays as it is, so files are closed one by one.
Code notTheLifePipe(std::initializer_list<unsigned> arguments, const Code& rest)
{
	Code code;
	for (const unsigned argument : arguments)
	{
		code.push_back(loadArgument(argument));
		code.push_back(jumpIf(BPF_JEQ, read::kLifeFd, 0, 1));
		code.push_back(answer(refuseWith(EBADF)));
	}
	code.insert(code.end(), rest.begin(), rest.end());
	return code;
}

class Filter
{
public:
	Filter()
	{
		code_ = {load(offsetof(seccomp_data, arch)), jumpIf(BPF_JEQ, kArchitecture, 1, 0), answer(refuseWith(ENOSYS)),
		         load(offsetof(seccomp_data, nr))};
	}
	void on(int call, const Code& then)
	{
		code_.push_back(jumpIf(BPF_JEQ, static_cast<std::uint32_t>(call), 0, static_cast<unsigned>(then.size())));
		code_.insert(code_.end(), then.begin(), then.end());
	}
	bool hold(std::uint32_t otherwise)
	{
		code_.push_back(answer(otherwise));
		sock_fprog program = {static_cast<unsigned short>(code_.size()), code_.data()};
		return kArchitecture != 0 && syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
	}

private:
	Code code_;
};

void addConditions(Filter& filter, const Permits& permits)
{
	const auto self = static_cast<std::uint32_t>(getpid());
	filter.on(SYS_mmap, notRunIfWritten());
	for (const int call : {SYS_mprotect, SYS_pkey_mprotect})
		filter.on(call, noneOf(2, PROT_EXEC));
	constexpr std::uint32_t kWriting = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
	const Code allow = {answer(kAllow)};
	filter.on(SYS_openat, permits.write ? allow : noneOf(2, kWriting));
#ifdef SYS_open
	filter.on(SYS_open, permits.write ? allow : noneOf(1, kWriting));
#endif
	for (const int call : {SYS_close, SYS_dup})
		filter.on(call, notTheLifePipe({0}, allow));
	filter.on(SYS_dup3, notTheLifePipe({0, 1}, allow));
#ifdef SYS_dup2
	filter.on(SYS_dup2, notTheLifePipe({0, 1}, allow));
#endif
	// Owners of a file get signals, so none can be named.
	filter.on(SYS_fcntl,
	          notTheLifePipe({0}, anyOf(1,
	                                    {F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_DUPFD, F_DUPFD_CLOEXEC, F_GETLK, F_SETLK,
	                                     F_SETLKW, F_OFD_GETLK, F_OFD_SETLK, F_OFD_SETLKW, F_GET_SEALS},
	                                    EACCES)));
	filter.on(SYS_ioctl,
	          notTheLifePipe({0}, anyOf(1, {TCGETS, TIOCGWINSZ, FIONREAD, FIONBIO, FIOCLEX, FIONCLEX}, ENOTTY)));
	if (permits.execute)
		filter.on(SYS_execve, allow);
	filter.on(SYS_kill, anyOf(0, {self}, EACCES));
	filter.on(SYS_tgkill, anyOf(0, {self}, EACCES));
	// A sanitizer sets limits where a program starts, and forks to look for leaks where it ends.
	if (kSanitized)
		for (const int call :
		     {SYS_clone, SYS_prctl, SYS_ptrace, SYS_personality, SYS_wait4, SYS_execve, SYS_prlimit64, SYS_setrlimit})
			filter.on(call, allow);
	filter.on(SYS_prlimit64, ownLimits());
	filter.on(SYS_clone, onlyThreads());
	filter.on(SYS_prctl,
	          anyOf(0, {PR_SET_NAME, PR_GET_NAME, PR_SET_NO_NEW_PRIVS, PR_GET_NO_NEW_PRIVS, PR_CAPBSET_READ}, ENOSYS));
}

} // namespace

bool holdBySeccomp(const Permits& permits)
{
	Filter filter;
	addConditions(filter, permits);
	for (const int call : kAllowed)
		filter.on(call, {answer(kAllow)});
	return filter.hold(refuseWith(ENOSYS));
}

bool refuseExecBySeccomp()
{
	Filter filter;
	filter.on(SYS_execve, {answer(refuseWith(ENOSYS))});
	return filter.hold(kAllow);
}

} // namespace vp::reader::door
