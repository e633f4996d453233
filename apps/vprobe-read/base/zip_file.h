#pragma once

#include <string>
#include <string_view>
#include <vector>

// A file in a zip archive, stored or deflated.
struct ZipEntry
{
	std::string name;
	std::string_view packed;
	std::uint64_t size = 0; // unpacked
	bool deflated = false;
	std::uint32_t checksum = 0;
};

// The list at the archive's end. Throws a Refusal where it cannot be followed.
std::vector<ZipEntry> zipEntries(std::string_view archive);

// Throws a Refusal where it does not unpack to its size and checksum.
std::string unpackEntry(const ZipEntry& entry);
