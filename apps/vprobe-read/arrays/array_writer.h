#pragma once

#include "grid/field.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

// Writes arrays one after the other into a shared memory the parent gave, and describes each for the manifest.
class ArrayWriter
{
public:
	explicit ArrayWriter(int memory) : memory_(memory) {}

	nlohmann::json write(vp::grid::NumberType type, const void* data, std::size_t bytes);

	// The same in pieces, for arrays that are converted on the way.
	void begin();
	void append(const void* data, std::size_t bytes);
	nlohmann::json end(vp::grid::NumberType type);

	// Room for an array whose bytes are put there in any order, by any thread.
	std::size_t reserve(std::size_t bytes);
	void put(std::size_t at, const void* data, std::size_t bytes) const;
	static nlohmann::json describe(vp::grid::NumberType type, std::size_t at, std::size_t bytes);
	// Where the next array comes behind, and as if nothing had been written from there on.
	std::size_t mark() const { return position_; }
	void rewind(std::size_t mark);

private:
	int memory_; // a file descriptor
	std::size_t start_ = 0;
	std::size_t position_ = 0;
};

nlohmann::json writeInt64(ArrayWriter& writer, std::span<const std::int32_t> values);
nlohmann::json writeInt64(ArrayWriter& writer, std::span<const std::int64_t> values);
// Ids of 32 bits where all of them fit, else of 64.
nlohmann::json writeIds(ArrayWriter& writer, std::span<const std::int32_t> ids);
nlohmann::json writeIds(ArrayWriter& writer, std::span<const std::int64_t> ids);
