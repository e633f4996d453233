// Replaces the system's functions that open files, for all libraries of this program, and notes each file that is
// opened for reading. Rejected: a list in each of 40 readers, which would miss files that their libraries open.
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/stand_in.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>

namespace vp::reader
{

// The headers' inline forms of these functions would be in the way, so the names are given to the linker here.
#define VP_EXPORTED extern "C" __attribute__((visibility("default")))

namespace
{

template <class Function>
Function* next(const char* name)
{
	return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool onlyReads(int flags)
{
	return (flags & O_ACCMODE) == O_RDONLY && !(flags & O_DIRECTORY);
}

bool onlyReads(const char* mode)
{
	return mode && mode[0] == 'r' && !std::strchr(mode, '+');
}

void noteOpened(bool is_open, const char* path)
{
	if (is_open)
		return noteFile(path);
	const int error = errno;
	if (error == EACCES)
		noteRefused(path);
	errno = error;
}

int opened(int descriptor, const char* path, int flags)
{
	if (onlyReads(flags))
		noteOpened(descriptor >= 0, path);
	return descriptor;
}

std::FILE* opened(std::FILE* file, const char* path, const char* mode)
{
	if (onlyReads(mode))
		noteOpened(file != nullptr, path);
	return file;
}

bool isBlocked(const char* path)
{
	if (!isNoFile(path))
		return false;
	errno = EINVAL;
	return true;
}

// The file that another one stands in for; empty for none.
std::string replaced_file, replacing_file;

const char* pathToOpen(const char* path)
{
	return path && !replaced_file.empty() && replaced_file == path ? replacing_file.c_str() : path;
}

using Open = int(const char*, int, ...);
using CheckedOpen = int(const char*, int);
using OpenStream = std::FILE*(const char*, const char*);

} // namespace

StandIn::StandIn(const std::string& file, const std::string& other)
{
	replaced_file = file;
	replacing_file = other;
}

StandIn::~StandIn()
{
	replaced_file.clear();
}

#define VP_OPEN(NAME, SYMBOL)                                                                                          \
	VP_EXPORTED int NAME(const char* path, int flags, ...) __asm__(SYMBOL);                                            \
	VP_EXPORTED int NAME(const char* path, int flags, ...)                                                             \
	{                                                                                                                  \
		static Open* const system = next<Open>(SYMBOL);                                                                \
		std::va_list rest;                                                                                             \
		va_start(rest, flags);                                                                                         \
		const bool makes = (flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE;                                      \
		const mode_t mode = makes ? va_arg(rest, mode_t) : 0;                                                          \
		va_end(rest);                                                                                                  \
		const bool reads = onlyReads(flags);                                                                           \
		return reads && isBlocked(path) ? -1                                                                           \
		                                : opened(system(reads ? pathToOpen(path) : path, flags, mode), path, flags);   \
	}

#define VP_CHECKED_OPEN(NAME, SYMBOL)                                                                                  \
	VP_EXPORTED int NAME(const char* path, int flags) __asm__(SYMBOL);                                                 \
	VP_EXPORTED int NAME(const char* path, int flags)                                                                  \
	{                                                                                                                  \
		static CheckedOpen* const system = next<CheckedOpen>(SYMBOL);                                                  \
		return onlyReads(flags) && isBlocked(path) ? -1 : opened(system(path, flags), path, flags);                    \
	}

#define VP_OPEN_STREAM(NAME, SYMBOL)                                                                                   \
	VP_EXPORTED std::FILE* NAME(const char* path, const char* mode) __asm__(SYMBOL);                                   \
	VP_EXPORTED std::FILE* NAME(const char* path, const char* mode)                                                    \
	{                                                                                                                  \
		static OpenStream* const system = next<OpenStream>(SYMBOL);                                                    \
		return onlyReads(mode) && isBlocked(path) ? nullptr : opened(system(path, mode), path, mode);                  \
	}

VP_OPEN(watchedOpen, "open")
VP_OPEN(watchedOpen64, "open64")
VP_CHECKED_OPEN(watchedCheckedOpen, "__open_2")
VP_CHECKED_OPEN(watchedCheckedOpen64, "__open64_2")
VP_OPEN_STREAM(watchedStream, "fopen")
VP_OPEN_STREAM(watchedStream64, "fopen64")

} // namespace vp::reader
