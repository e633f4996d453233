#include "last_word.h"

#include "base/sanitized.h"
#include "exit_code.h"
#include "report/console.h"
#include "write/unfinished.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <dlfcn.h>
#include <execinfo.h>
#include <sys/uio.h>
#include <unistd.h>

namespace vp::app
{

namespace
{

constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::size_t kStackSize = 64 * 1024; // a full stack leaves none for the handler

// Made before a crash: a handler allocates nothing.
std::array<char, 32> name_of_program{"vprobe"};
std::string line_of_driver;
std::string line_of_program;
volatile std::sig_atomic_t has_spoken = 0;

// The name of a file without its folders.
std::string_view baseName(const char* path)
{
	const std::string_view whole = path ? path : "";
	const std::size_t slash = whole.rfind('/');
	return slash == whole.npos ? whole : whole.substr(slash + 1);
}

bool isAnyOf(std::string_view name, std::initializer_list<std::string_view> beginnings)
{
	return std::ranges::any_of(beginnings, [&](std::string_view beginning) { return name.starts_with(beginning); });
}

// Returns true if the innermost code that is no part of the C library lies in a driver. Code without a file was made by
// one: this program makes none.
bool isInDriver()
{
	std::array<void*, 64> frames{};
	const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
	bool is_behind_handler = false; // frames of the handler come first, then one of the C library
	for (int i = 0; i < count; ++i)
	{
		Dl_info place{};
		const bool has_file = dladdr(frames[static_cast<std::size_t>(i)], &place) != 0;
		const std::string_view name = has_file ? baseName(place.dli_fname) : std::string_view();
		const bool is_system = isAnyOf(name, {"libc.so", "libc-", "libpthread", "libgcc_s", "libstdc++", "ld-linux",
		                                      "libm.so", "linux-vdso", "libasan", "libubsan"});
		if (is_system)
		{
			is_behind_handler = true;
			continue;
		}
		if (!is_behind_handler)
			continue;
		return !has_file || isAnyOf(name, {"libvulkan_", "libLLVM", "libGLX_", "libEGL_", "libnvidia", "libamdvlk",
		                                   "libvk_swiftshader", "libgallium", "libigdml", "libdrm"});
	}
	return false;
}

void write(const std::string& line)
{
	const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
	(void)written; // nothing is left to do about it
}

void onCrash(int number)
{
	std::signal(number, SIG_DFL);
	if (has_spoken == 0)
	{
		has_spoken = 1;
		const bool in_driver = isInDriver();
		write(in_driver ? line_of_driver : line_of_program);
		write::removeUnfinishedFiles();
		if (in_driver)
			_exit(static_cast<int>(ExitCode::no_device));
	}
	raise(number);
}

[[noreturn]] void endUnhandled(std::string_view reason)
{
	printLine(std::string(reason) + "; please report it with the command line");
	has_spoken = 1;
	write::removeUnfinishedFiles();
	std::abort();
}

[[noreturn]] void onUnhandled()
{
	try
	{
		if (const std::exception_ptr error = std::current_exception())
			std::rethrow_exception(error);
	}
	catch (const std::bad_alloc&)
	{
		sayOutOfMemory();
		write::removeUnfinishedFiles();
		_exit(static_cast<int>(ExitCode::output));
	}
	catch (const std::exception& error)
	{
		endUnhandled(error.what());
	}
	catch (...)
	{
		// it says nothing
	}
	endUnhandled("an error that nobody handled");
}

} // namespace

void sayOutOfMemory() noexcept
{
	const auto part = [](std::string_view text) { return iovec{const_cast<char*>(text.data()), text.size()}; };
	const std::array line{part(name_of_program.data()), part(": "), part(kOutOfMemory), part("\n")};
	const ssize_t written = writev(STDERR_FILENO, line.data(), static_cast<int>(line.size()));
	(void)written; // nothing is left to do about it
}

void sayLastWord(std::string_view program)
{
	std::set_terminate(onUnhandled); // before anything may fail
	name_of_program = {};
	program.copy(name_of_program.data(), name_of_program.size() - 1);
	line_of_driver =
	    std::string(program) + ": the driver of the device crashed; choose another by --device, or update it\n";
	line_of_program =
	    std::string(program) + ": crashed; please report it with the command line and, if you may, the input\n";
	if (kSanitized)
		return;
	std::array<void*, 1> first{};
	backtrace(first.data(), 1); // loads what it needs
	static std::vector<std::byte> stack(kStackSize);
	stack_t own{};
	own.ss_sp = stack.data();
	own.ss_size = stack.size();
	sigaltstack(&own, nullptr);
	struct sigaction action = {};
	action.sa_handler = onCrash;
	action.sa_flags = SA_ONSTACK;
	for (const int number : kCrashes)
		sigaction(number, &action, nullptr);
}

} // namespace vp::app
