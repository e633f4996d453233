#include "read/source_stamp.h"

#include <cstddef>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

constexpr std::size_t kHeadBytes = 64 << 10;

} // namespace

SourceStamp stampOf(int descriptor)
{
	struct stat facts = {};
	std::vector<unsigned char> head(kHeadBytes);
	const ssize_t count = pread(descriptor, head.data(), head.size(), 0);
	if (fstat(descriptor, &facts) != 0 || count < 0)
		return {};
	constexpr std::uint64_t basis = 0xCBF29CE484222325, prime = 0x100000001B3, nanoseconds = 1'000'000'000;
	std::uint64_t hash = basis;
	for (ssize_t i = 0; i < count; ++i)
		hash = (hash ^ head[static_cast<std::size_t>(i)]) * prime;
	return {.device = facts.st_dev,
	        .number = facts.st_ino,
	        .bytes = static_cast<std::uint64_t>(facts.st_size),
	        .changed = static_cast<std::uint64_t>(facts.st_mtim.tv_sec) * nanoseconds +
	                   static_cast<std::uint64_t>(facts.st_mtim.tv_nsec),
	        .head = hash};
}

} // namespace vp::read
