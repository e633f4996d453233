#include "printed_text.h"

#include <cstdio>

#include <sys/mman.h>
#include <unistd.h>

namespace vp::reader
{

PrintedText::PrintedText()
{
	std::fflush(stderr);
	file_ = memfd_create("printed", MFD_CLOEXEC);
	standard_error_ = file_ < 0 ? -1 : dup(STDERR_FILENO);
	if (standard_error_ >= 0)
		dup2(file_, STDERR_FILENO);
}

PrintedText::~PrintedText()
{
	std::fflush(stderr);
	if (standard_error_ >= 0)
	{
		dup2(standard_error_, STDERR_FILENO);
		close(standard_error_);
	}
	if (file_ >= 0)
		close(file_);
}

std::string PrintedText::text() const
{
	std::fflush(stderr);
	std::string text(64 << 10, '\0');
	const ssize_t size = file_ < 0 ? 0 : pread(file_, text.data(), text.size(), 0);
	text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
	return text;
}

} // namespace vp::reader
