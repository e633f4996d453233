#pragma once

#include <cstdint>
#include <string_view>

namespace vp::read
{

// The index of FILE is FILE.vpx (docs/LARGE.md).
constexpr std::string_view kIndexEnding = ".vpx";

// The marks by which an index knows its file. If the bytes of the file change, one of them does, as far as the system
// can tell.
struct SourceStamp
{
	std::uint64_t device = 0;
	std::uint64_t number = 0; // on the device (inode)
	std::uint64_t bytes = 0;
	std::uint64_t changed = 0; // nanoseconds since 1970
	std::uint64_t head = 0;    // a hash of the first 64 KiB: FNV-1a of 64 bits

	bool operator==(const SourceStamp&) const = default;
};

// Returns the stamp of an open file. One that cannot be read has the stamp of no file.
SourceStamp stampOf(int descriptor);

} // namespace vp::read
