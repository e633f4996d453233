#include "write/unfinished.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace vp::write
{

namespace
{

// Names of the files being written, where a signal handler can read them. A file past the last place is only left
// behind when the program is interrupted.
struct Unfinished
{
	std::atomic<bool> taken = false;
	std::atomic<bool> named = false;
	std::array<char, 4096> name;
};
std::array<Unfinished, 8> unfinished;

// The program is about to end, by a signal that may have come to any thread.
std::atomic<bool> ending = false;
std::atomic<int> touching = 0; // threads between a look at `ending` and what they do to files
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free); // for the handler

constexpr timespec kMillisecond{0, 1'000'000};

// As the kernel gives them: readdir() may take memory, which a signal handler must not.
struct Entry
{
	std::uint64_t number;
	std::int64_t offset;
	std::uint16_t length;
	unsigned char type;
	char name[1];
};

// Removes a folder of files. Another program may still write there, until the folder is gone.
void removeFolder(const char* name)
{
	constexpr int kTries = 50;
	for (int i = 0; i < kTries && rmdir(name) != 0; ++i)
	{
		const int folder = open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
		if (folder < 0)
			return;
		alignas(Entry) std::array<char, 4096> entries;
		for (long bytes; (bytes = syscall(SYS_getdents64, folder, entries.data(), entries.size())) > 0;)
			for (long at = 0; at < bytes;)
			{
				const auto* entry = reinterpret_cast<const Entry*>(entries.data() + at);
				if (unlinkat(folder, entry->name, 0) != 0 && i > 0)
					nanosleep(&kMillisecond, nullptr);
				at += entry->length;
			}
		close(folder);
	}
}

} // namespace

TouchingFiles::TouchingFiles()
{
	++touching;
	if (!ending)
		return;
	--touching;
	for (;;)
		pause();
}

TouchingFiles::~TouchingFiles()
{
	--touching;
}

void rememberUnfinished(const std::string& name)
{
	for (Unfinished& place : unfinished)
		if (name.size() < place.name.size() && !place.taken.exchange(true))
		{
			std::memcpy(place.name.data(), name.c_str(), name.size() + 1);
			place.named = true;
			return;
		}
}

void forgetUnfinished(const std::string& name)
{
	for (Unfinished& place : unfinished)
		if (place.named && name == place.name.data())
		{
			place.named = false;
			place.taken = false;
			return;
		}
}

void removeUnfinishedFiles() noexcept
{
	ending = true;
	// Other threads come to rest first; where this one was interrupted in the middle of it, waiting is in vain.
	for (int ms = 0; ms < 50 && touching > 0; ++ms)
		nanosleep(&kMillisecond, nullptr);
	for (const Unfinished& place : unfinished)
		if (place.named && unlink(place.name.data()) != 0)
			removeFolder(place.name.data());
}

} // namespace vp::write
