#include "memory_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <new>

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace vp::reader
{

namespace
{

int openMemory()
{
	return memfd_create("vprobe-copy", MFD_CLOEXEC);
}

// Raises the limit of open files, since an index may name more pieces than the limit allows.
void allowMoreFiles()
{
	struct rlimit limit = {};
	if (getrlimit(RLIMIT_NOFILE, &limit) != 0)
		return;
	limit.rlim_cur = limit.rlim_max;
	setrlimit(RLIMIT_NOFILE, &limit);
}

} // namespace

MemoryFile::MemoryFile() : file_(openMemory())
{
	if (file_ < 0 && errno == EMFILE)
	{
		allowMoreFiles();
		file_ = openMemory();
	}
	if (file_ < 0)
		throw std::bad_alloc();
}

MemoryFile::~MemoryFile()
{
	if (file_ >= 0)
		close(file_);
}

std::string MemoryFile::path() const
{
	return fmt::format("/proc/self/fd/{}", file_);
}

void MemoryFile::append(std::string_view bytes)
{
	overwrite(size_, bytes);
	size_ += bytes.size();
}

void MemoryFile::overwrite(std::uint64_t at, std::string_view bytes) const
{
	while (!bytes.empty())
	{
		const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
		if (written <= 0)
			throw std::bad_alloc();
		at += static_cast<std::uint64_t>(written);
		bytes.remove_prefix(static_cast<std::size_t>(written));
	}
}

void MemoryFile::end() const
{
	if (ftruncate(file_, static_cast<off_t>(size_)) != 0)
		throw std::bad_alloc();
}

} // namespace vp::reader
