#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vp::reader
{

// A file in a zip archive, stored or deflated.
struct ZipEntry
{
	std::string name;
	std::string_view packed;
	std::uint64_t size = 0; // unpacked
	bool deflated = false;
	std::uint32_t checksum = 0;
};

// Returns the list at the archive's end. Throws a Refusal if the list is damaged.
std::vector<ZipEntry> zipEntries(std::string_view archive);

// Unpacks an entry. Throws a Refusal if its size or checksum is wrong.
std::string unpackEntry(const ZipEntry& entry);

} // namespace vp::reader
