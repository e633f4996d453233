#include "bytes_read.h"

#include "read/protocol.h"

#include <array>
#include <atomic>
#include <charconv>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader
{

namespace
{

std::uint64_t before = 0;
std::atomic<std::uint64_t> mapped = 0;

std::uint64_t readSoFar()
{
	std::array<char, 256> text;
	const ssize_t size = pread(read::kCountsFd, text.data(), text.size() - 1, 0);
	constexpr std::string_view key = "rchar: ";
	const std::string_view counts(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
	const std::size_t at = counts.find(key);
	std::uint64_t value = 0;
	if (at != counts.npos)
		std::from_chars(counts.data() + at + key.size(), counts.data() + counts.size(), value);
	return value;
}

} // namespace

std::uint64_t bytesRead()
{
	const std::uint64_t now = readSoFar();
	return (now > before ? now - before : 0) + mapped;
}

void countMapped(std::uint64_t bytes)
{
	mapped += bytes;
}

void startCounting()
{
	// vprobe-read-more finds it open.
	if (fcntl(read::kCountsFd, F_GETFD) < 0)
		if (const int counts = open("/proc/self/io", O_RDONLY); counts >= 0 && counts != read::kCountsFd)
		{
			dup2(counts, read::kCountsFd);
			close(counts);
		}
	before = readSoFar();
}

} // namespace vp::reader
