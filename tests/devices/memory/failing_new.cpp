// Preloaded, it takes the place of operator new: the Nth call from the program's own code fails, between the beginning
// and the end of main().
//
// VPROBE_MEMORY_FAULT=PROGRAM:N    in the program of that name, vprobe or vprobe-read; 0: none fails
// VPROBE_MEMORY_FAULT=PROGRAM:N+   all calls from the Nth on fail
// VPROBE_MEMORY_CALLS=FILE         tells how many there were, and which of them were the first of their place
//
// Calls of libraries are not counted, since what they do without memory is not up to us: only those whose return
// address lies in the program's own file. vprobe gives vprobe-read few variables of its environment, and not these:
// execve() adds them where the reader is to fail.
#include "memory_calls.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#define VP_SHOWN __attribute__((visibility("default")))

namespace vp::memory
{

namespace
{

constexpr const char* kFault = "VPROBE_MEMORY_FAULT";
constexpr const char* kCalls = "VPROBE_MEMORY_CALLS";
constexpr std::size_t kMaxPieces = 16;

struct Piece
{
	std::uintptr_t begin = 0, end = 0;
};

// All of it is there before any constructor runs.
std::array<Piece, kMaxPieces> code; // the program's own file
std::array<std::atomic<std::uintptr_t>, 4 * kMaxPlaces> places;
std::array<std::atomic<bool>, 4 * kMaxPlaces> is_shared; // libraries run the code there too
std::atomic<bool> counts = false;
std::atomic<std::uint64_t> calls = 0;
std::uint64_t first_to_fail = 0, last_to_fail = 0;
MemoryCalls* told = nullptr;
int (*real_main)(int, char**, char**) = nullptr;
std::terminate_handler handler_of_program = nullptr;

// The program's file comes first.
int noteCode(dl_phdr_info* info, std::size_t, void*)
{
	std::size_t n = 0;
	for (int i = 0; i < info->dlpi_phnum && n < kMaxPieces; ++i)
	{
		const auto& header = info->dlpi_phdr[i];
		if (header.p_type == PT_LOAD && (header.p_flags & PF_X))
			code[n++] = {info->dlpi_addr + header.p_vaddr, info->dlpi_addr + header.p_vaddr + header.p_memsz};
	}
	return 1;
}

bool isOwn(std::uintptr_t place)
{
	return std::any_of(code.begin(), code.end(),
	                   [=](const Piece& piece) { return piece.begin <= place && place < piece.end; });
}

// A weak function that the program shows to libraries takes the place of theirs.
bool servesLibraries(std::uintptr_t place)
{
	Dl_info info{};
	void* found = nullptr;
	if (dladdr1(reinterpret_cast<void*>(place), &info, &found, RTLD_DL_SYMENT) == 0 || !found)
		return false;
	const auto& symbol = *static_cast<const ElfW(Sym)*>(found);
	return ELF64_ST_BIND(symbol.st_info) == STB_WEAK &&
	       place < reinterpret_cast<std::uintptr_t>(info.dli_saddr) + symbol.st_size;
}

// Returns the index of a place of the code, and whether it is new.
std::pair<std::size_t, bool> noted(std::uintptr_t place)
{
	for (std::size_t i = place * 0x9E3779B97F4A7C15u % places.size();; i = (i + 1) % places.size())
	{
		std::uintptr_t held = places[i].load();
		if (held == place)
			return {i, false};
		if (held == 0)
		{
			is_shared[i] = servesLibraries(place);
			if (places[i].compare_exchange_strong(held, place))
				return {i, true};
			if (held == place)
				return {i, false};
		}
	}
}

// Returns true if the program itself called the shared function that lies at the place.
bool isCalledByUs(std::uintptr_t place)
{
	std::array<void*, 16> frames{};
	const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
	bool is_behind = false;
	for (int i = 0; i < count; ++i)
	{
		const auto frame = reinterpret_cast<std::uintptr_t>(frames[static_cast<std::size_t>(i)]);
		if (is_behind && !(isOwn(frame) && servesLibraries(frame)))
			return isOwn(frame);
		is_behind = is_behind || frame == place;
	}
	return false;
}

bool fails(void* caller)
{
	const auto place = reinterpret_cast<std::uintptr_t>(caller);
	if (!counts.load(std::memory_order_relaxed) || !isOwn(place))
		return false;
	const auto [index, is_new] = noted(place);
	if (is_shared[index] && !isCalledByUs(place))
		return false;
	const std::uint64_t call = ++calls;
	if (told)
	{
		std::atomic_ref(told->count).store(call);
		if (is_new)
			told->first_calls[std::min<std::uint64_t>(std::atomic_ref(told->places)++, kMaxPlaces - 1)] = call;
	}
	return first_to_fail <= call && call <= last_to_fail;
}

void onTerminate()
{
	if (told)
		told->terminated = 1;
	if (handler_of_program)
		handler_of_program();
	std::abort();
}

[[noreturn]] void refuse(const char* text)
{
	std::fprintf(stderr, "%s: vprobe:N, vprobe-read:N or either with a plus sign behind it, not %s\n", kFault, text);
	std::_Exit(99);
}

const char* programOf(char* path)
{
	const char* slash = std::strrchr(path, '/');
	return slash ? slash + 1 : path;
}

// Maps the file at once: later the reader's sandbox lets nobody open one.
void tellCalls()
{
	const char* file = std::getenv(kCalls);
	const int descriptor = file ? open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0666) : -1;
	if (descriptor < 0)
		return;
	if (ftruncate(descriptor, sizeof(MemoryCalls)) == 0)
	{
		void* mapped = mmap(nullptr, sizeof(MemoryCalls), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
		told = mapped == MAP_FAILED ? nullptr : static_cast<MemoryCalls*>(mapped);
	}
	close(descriptor);
}

void begin()
{
	const char* text = std::getenv(kFault);
	const char* colon = text ? std::strchr(text, ':') : nullptr;
	if (!text)
		return;
	char* end = nullptr;
	if (!colon || (first_to_fail = std::strtoull(colon + 1, &end, 10), end == colon + 1))
		refuse(text);
	last_to_fail = std::strcmp(end, "+") == 0 ? ~std::uint64_t(0) : first_to_fail;
	if (first_to_fail == 0)
		first_to_fail = 1, last_to_fail = 0;
	std::array<char, 4096> self{};
	if (readlink("/proc/self/exe", self.data(), self.size() - 1) < 0)
		return;
	const std::size_t length = static_cast<std::size_t>(colon - text);
	const char* name = programOf(self.data());
	if (std::strlen(name) != length || std::strncmp(name, text, length) != 0)
		return;
	dl_iterate_phdr(noteCode, nullptr);
	std::array<void*, 1> first{};
	backtrace(first.data(), 1); // loads what it needs
	tellCalls();
	counts = true;
}

int countedMain(int count, char** arguments, char** environment)
{
	begin();
	const int status = real_main(count, arguments, environment);
	counts = false;
	return status;
}

void* allocated(std::size_t size, std::size_t alignment, void* caller)
{
	if (fails(caller))
		return nullptr;
	if (alignment == 0)
		return std::malloc(std::max<std::size_t>(size, 1));
	return std::aligned_alloc(alignment, (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment);
}

void* orThrow(void* memory)
{
	if (!memory)
		throw std::bad_alloc();
	return memory;
}

} // namespace

} // namespace vp::memory

// The C++ library's operator delete frees what malloc() gave, so it stays as it is.
#define VP_CALLER __builtin_return_address(0)
using vp::memory::allocated;
using vp::memory::orThrow;

VP_SHOWN void* operator new(std::size_t size)
{
	return orThrow(allocated(size, 0, VP_CALLER));
}

VP_SHOWN void* operator new[](std::size_t size)
{
	return orThrow(allocated(size, 0, VP_CALLER));
}

VP_SHOWN void* operator new(std::size_t size, std::align_val_t alignment)
{
	return orThrow(allocated(size, static_cast<std::size_t>(alignment), VP_CALLER));
}

VP_SHOWN void* operator new[](std::size_t size, std::align_val_t alignment)
{
	return orThrow(allocated(size, static_cast<std::size_t>(alignment), VP_CALLER));
}

VP_SHOWN void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
	return allocated(size, 0, VP_CALLER);
}

VP_SHOWN void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
	return allocated(size, 0, VP_CALLER);
}

VP_SHOWN void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
	return allocated(size, static_cast<std::size_t>(alignment), VP_CALLER);
}

VP_SHOWN void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
	return allocated(size, static_cast<std::size_t>(alignment), VP_CALLER);
}

extern "C" VP_SHOWN int __libc_start_main(int (*main)(int, char**, char**), int count, char** arguments, void (*init)(),
                                          void (*fini)(), void (*rtld_fini)(), void* stack_end)
{
	vp::memory::real_main = main;
	const auto real = reinterpret_cast<decltype(&__libc_start_main)>(dlsym(RTLD_NEXT, "__libc_start_main"));
	return real(vp::memory::countedMain, count, arguments, init, fini, rtld_fini, stack_end);
}

// A program may have a last word. That it needed one is told.
VP_SHOWN std::terminate_handler std::set_terminate(std::terminate_handler handler) noexcept
{
	using SetTerminate = std::terminate_handler (*)(std::terminate_handler);
	const auto real = reinterpret_cast<SetTerminate>(dlsym(RTLD_NEXT, "_ZSt13set_terminatePFvvE"));
	vp::memory::handler_of_program = handler;
	return real(vp::memory::onTerminate);
}

// Called between fork() and the new program: it allocates nothing.
extern "C" VP_SHOWN int execve(const char* program, char* const arguments[], char* const environment[]) noexcept
{
	static std::array<char*, 1024> more;
	static std::array<char, 4096> preload, fault, calls;
	const auto real = reinterpret_cast<decltype(&execve)>(dlsym(RTLD_NEXT, "execve"));
	const char* reader = "vprobe-read:";
	const char* asked = std::getenv(vp::memory::kFault);
	if (!asked || std::strncmp(asked, reader, std::strlen(reader)) != 0)
		return real(program, arguments, environment);
	std::size_t n = 0;
	while (environment[n] && n + 4 < more.size())
	{
		more[n] = environment[n];
		++n;
	}
	const auto add = [&](std::array<char, 4096>& text, const char* name)
	{
		const char* value = std::getenv(name);
		if (value && std::snprintf(text.data(), text.size(), "%s=%s", name, value) < static_cast<int>(text.size()))
			more[n++] = text.data();
	};
	add(preload, "LD_PRELOAD");
	add(fault, vp::memory::kFault);
	add(calls, vp::memory::kCalls);
	more[n] = nullptr;
	return real(program, arguments, more.data());
}
