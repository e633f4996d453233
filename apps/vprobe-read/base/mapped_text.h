#pragma once

#include "refusal.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::reader
{

// Maps a whole file to read it.
class MappedText
{
public:
	explicit MappedText(const std::string& file)
	{
		struct stat about;
		const int fd = open(file.c_str(), O_RDONLY | O_CLOEXEC);
		if (fd < 0 || fstat(fd, &about) != 0)
			throw Refusal(fmt::format("its piece {} cannot be opened; keep them together", file));
		if (!S_ISREG(about.st_mode))
		{
			close(fd);
			throw Refusal(fmt::format("its piece {} is {}; name a file there", file,
			                          S_ISDIR(about.st_mode) ? "a folder" : "no regular file"));
		}
		size_ = static_cast<std::size_t>(about.st_size);
		at_ = size_ ? mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fd, 0) : nullptr;
		const int error = errno;
		close(fd);
		if (at_ == MAP_FAILED && error == ENOMEM)
			throw std::bad_alloc();
		if (at_ == MAP_FAILED)
			throw Refusal(fmt::format("its piece {} cannot be read: {}", file, std::strerror(error)));
	}
	~MappedText()
	{
		if (at_)
			munmap(at_, size_);
	}
	MappedText(const MappedText&) = delete;
	MappedText& operator=(const MappedText&) = delete;

	// Tells the system that a part of the text will be read next, so that it comes in one piece and not page by page.
	void announce(std::string_view part) const
	{
		const auto offset = static_cast<std::size_t>(part.data() - text().data());
		const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), first = offset / page * page;
		madvise(static_cast<char*>(at_) + first, offset + part.size() - first, MADV_WILLNEED);
	}

	std::string_view text() const { return {static_cast<const char*>(at_), size_}; }

private:
	void* at_ = nullptr;
	std::size_t size_ = 0;
};

} // namespace vp::reader
