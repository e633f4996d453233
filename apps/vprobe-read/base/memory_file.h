#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vp::reader
{

// A file in memory, which readers open by its path.
class MemoryFile
{
public:
	MemoryFile();
	~MemoryFile();
	MemoryFile(const MemoryFile&) = delete;
	MemoryFile& operator=(const MemoryFile&) = delete;

	std::string path() const;
	std::uint64_t size() const { return size_; }
	void append(std::string_view bytes);
	// Writes over bytes that were appended before.
	void overwrite(std::uint64_t at, std::string_view bytes) const;
	// Skips some bytes. They read as zeros and take no memory.
	void skip(std::uint64_t bytes) { size_ += bytes; }
	// Ends the file behind all bytes that were appended or skipped.
	void end() const;

private:
	int file_ = -1;
	std::uint64_t size_ = 0;
};

} // namespace vp::reader
